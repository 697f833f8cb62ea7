# The style and the script of report.html, src/web/page/, as text within the library: a page needs them wherever a program or a node runs,
# and a library finds no installed file without knowing where it was installed to. CMake runs again when one of them changes.
set(page_scripts data camera canvas_view three_view page)
set(page_text "")
foreach(part style.css ${page_scripts})
  if(part IN_LIST page_scripts)
    set(part "${part}.js")
  endif()
  set(file "${PROJECT_SOURCE_DIR}/src/web/page/${part}")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  file(READ "${file}" text)
  get_filename_component(kind "${part}" LAST_EXT)
  string(APPEND page_text${kind} "${text}\n")
endforeach()
set(output "${CMAKE_CURRENT_BINARY_DIR}/page_files.cpp")
file(WRITE "${output}.new" "#include \"web/page_files.h\"

const char* ${PROJECT_NAME}::pageStyle() {
  return R\"page(${page_text.css})page\";
}

const char* ${PROJECT_NAME}::pageScript() {
  return R\"page(${page_text.js})page\";
}
")
configure_file("${output}.new" "${output}" COPYONLY)
target_sources(${PROJECT_NAME} PRIVATE "${output}")
