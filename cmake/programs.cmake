# One program per file of src/tools, but for the parser of command lines, which they share.

add_library(command_line STATIC src/tools/command_line.cpp)
target_include_directories(command_line PRIVATE src)
target_link_libraries(command_line PUBLIC ${PROJECT_NAME} PRIVATE Boost::program_options)

# Reads foreign files in a process of its own: whatever reads meshes or descriptions needs it.
add_executable(${PROJECT_NAME}_reader src/tools/reader.cpp $<TARGET_OBJECTS:${PROJECT_NAME}_descriptions>)
target_include_directories(${PROJECT_NAME}_reader PRIVATE src)
target_link_libraries(${PROJECT_NAME}_reader ${PROJECT_NAME}_decode)
set_target_properties(${PROJECT_NAME}_reader PROPERTIES INSTALL_RPATH "$ORIGIN/..")

function(set_up_program name)
  add_dependencies(${name} ${PROJECT_NAME}_reader)
  target_include_directories(${name} PRIVATE src)
  target_link_libraries(${name} command_line nlohmann_json::nlohmann_json)
  set_target_properties(${name} PROPERTIES INSTALL_RPATH "$ORIGIN/..")
endfunction()

set(PROGRAMS benchmark decompose fit_scene stability verify)
foreach(program ${PROGRAMS})
  add_executable(${program} src/tools/${program}.cpp)
  set_up_program(${program})
endforeach()
target_link_libraries(benchmark ${PROJECT_NAME}_bench)
target_link_libraries(stability ${PROJECT_NAME}_bench)

list(APPEND PROGRAMS ${PROJECT_NAME}_reader)

include(cmake/peers.cmake)
include(cmake/physics.cmake)
include(cmake/planning.cmake)
