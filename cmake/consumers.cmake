# Tests with the programs that take the results, where their packages are installed. Each is skipped with a message where it is not.

# add_consumer_test(NAME LIBRARY HEADER DEBIAN_PACKAGE [SUFFIX...]): test/consumers/NAME_test.cpp, with found::LIBRARY.
function(add_consumer_test name library header debian_package)
  find(${library} ${header} ${ARGN})
  if(NOT TARGET found::${library})
    add_test(NAME ${name}_test COMMAND ${CMAKE_COMMAND} -E echo "skipped: ${debian_package} is not installed")
    set_tests_properties(${name}_test PROPERTIES SKIP_REGULAR_EXPRESSION "^skipped")
    return()
  endif()
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")
  add_unit_tests(${name}_test test/consumers/${name}_test.cpp)
  add_dependencies(${name}_test ${PROJECT_NAME}_reader decompose)
  target_include_directories(${name}_test PRIVATE test src)
  target_link_libraries(${name}_test ${PROJECT_NAME} found::${library} nlohmann_json::nlohmann_json)
  target_compile_definitions(${name}_test PRIVATE DEMO_ROBOT="${PROJECT_SOURCE_DIR}" PROGRAMS="${PROGRAMS_DIR}"
    SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared")
endfunction()

add_consumer_test(self_filter geometric_shapes geometric_shapes/bodies.h libgeometric-shapes-dev)
