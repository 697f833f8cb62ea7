# One program per file of src/tools, but for the parser of command lines, which they share.

add_library(command_line STATIC src/tools/command_line.cpp)
target_include_directories(command_line PRIVATE src)
target_link_libraries(command_line PUBLIC ${PROJECT_NAME} PRIVATE Boost::program_options)

function(add_program name)
  add_executable(${name} src/tools/${name}.cpp)
  target_include_directories(${name} PRIVATE src)
  target_link_libraries(${name} ${ARGN} command_line nlohmann_json::nlohmann_json)
endfunction()

add_program(decompose ${PROJECT_NAME})
add_program(fit_scene ${PROJECT_NAME})
add_program(benchmark ${PROJECT_NAME}_bench)
add_program(stability ${PROJECT_NAME}_bench)
set(PROGRAMS decompose fit_scene benchmark stability)

include(cmake/peers.cmake)
include(cmake/physics.cmake)
