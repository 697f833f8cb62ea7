# Tests with the programs that take the results, where their packages are installed. Each is skipped with a message where it is not.

# add_consumer_test(NAME LIBRARY HEADER DEBIAN_PACKAGE [SUFFIX...]): test/with_packages/NAME_test.cpp, with found::LIBRARY.
function(add_consumer_test name library header debian_package)
  set_property(GLOBAL APPEND PROPERTY CONSUMER_TESTS ${name})
  if(NOT TARGET found::${library})
    find(${library} ${header} ${ARGN})
  endif()
  if(NOT TARGET found::${library})
    add_test(NAME ${name}_test COMMAND ${CMAKE_COMMAND} -E echo "skipped: ${debian_package} is not installed")
    set_tests_properties(${name}_test PROPERTIES SKIP_REGULAR_EXPRESSION "^skipped")
    return()
  endif()
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")
  add_unit_tests(${name}_test test/with_packages/${name}_test.cpp)
  add_dependencies(${name}_test ${PROJECT_NAME}_reader decompose)
  target_include_directories(${name}_test PRIVATE test src)
  target_link_libraries(${name}_test ${PROJECT_NAME} found::${library} nlohmann_json::nlohmann_json)
  target_compile_definitions(${name}_test PRIVATE DEMO_ROBOT="${PROJECT_SOURCE_DIR}" PROGRAMS="${PROGRAMS_DIR}"
    SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared")
endfunction()

# Its headers include those of other libraries, which pkg-config knows.
find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND)
  pkg_check_modules(sdformat12 QUIET IMPORTED_TARGET sdformat12)
  if(TARGET PkgConfig::sdformat12)
    add_library(found::sdformat12 INTERFACE IMPORTED)
    target_link_libraries(found::sdformat12 INTERFACE PkgConfig::sdformat12)
  endif()
endif()

# DART's own CMake files make the targets (physics.cmake).
if(DART_FOUND)
  add_library(found::dart INTERFACE IMPORTED)
  target_link_libraries(found::dart INTERFACE physics_room dart-utils)
endif()

add_consumer_test(self_filter geometric_shapes geometric_shapes/bodies.h libgeometric-shapes-dev)
add_consumer_test(padding geometric_shapes geometric_shapes/bodies.h libgeometric-shapes-dev)
add_consumer_test(mujoco mujoco mujoco/mujoco.h libmujoco-dev)
add_consumer_test(gazebo sdformat12 sdf/sdf.hh libsdformat-dev)
add_consumer_test(dart dart dart/dart.hpp "libdart-utils-urdf-dev, libdart-collision-bullet-dev")

file(GLOB consumer_tests CONFIGURE_DEPENDS test/with_packages/*_test.cpp)
get_property(added_tests GLOBAL PROPERTY CONSUMER_TESTS)
foreach(file ${consumer_tests})
  get_filename_component(name "${file}" NAME_WE)
  string(REGEX REPLACE "_test$" "" name "${name}")
  if(NOT name IN_LIST added_tests)
    message(FATAL_ERROR "test/with_packages/${name}_test.cpp is not built: name its library here, in an add_consumer_test().")
  endif()
endforeach()
