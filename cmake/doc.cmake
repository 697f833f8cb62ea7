# `cmake --build build --target doc`: the public headers and the documents as HTML in build/html. Optional. A test builds it.

find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  set(DOXYGEN_USE_MDFILE_AS_MAINPAGE "${PROJECT_SOURCE_DIR}/README.md")  # the name alone would mean those of the rooms, too
  set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
  set(DOXYGEN_EXTRACT_ALL YES)  # a name that says it all has no comment
  set(DOXYGEN_QUIET YES)
  set(DOXYGEN_WARN_AS_ERROR YES)
  set(DOXYGEN_HAVE_DOT NO)
  set(DOXYGEN_FILTER_PATTERNS
    "*.md=sed -E -f ${PROJECT_SOURCE_DIR}/cmake/doc_links.sed" "*.h=sed -E -f ${PROJECT_SOURCE_DIR}/cmake/doc_headers.sed")
  # Pictures, and files that the documents link to.
  set(DOXYGEN_IMAGE_PATH doc doc/figures doc/results)
  file(GLOB files RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS CHANGELOG.rst action/*.action msg/*.msg srv/*.srv doc/results/*.csv doc/results/*.json doc/figures/*.csv)
  set(DOXYGEN_HTML_EXTRA_FILES ${files})
  file(GLOB pages RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS doc/*.md doc/results/*.md src/*/README.md)
  doxygen_add_docs(doc include README.md CONTRIBUTING.md ${pages} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
endif()
