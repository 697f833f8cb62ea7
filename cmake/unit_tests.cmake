# Unit tests: one program per room, from test/<room>. They are built by the target `tests`.

set(TESTED_ROOMS ${CORE_ROOMS} ${ROBOT_ROOMS} decode bench tools demo)

# What nearly all tests include is parsed once. Not with a compiler cache, as for the libraries.
if(COLLISION_HULLS_PRECOMPILE AND NOT CMAKE_CXX_COMPILER_LAUNCHER AND TARGET GTest::Main)
  file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/test_headers.cpp" CONTENT "")
  add_library(test_headers OBJECT EXCLUDE_FROM_ALL "${PROJECT_BINARY_DIR}/test_headers.cpp")
  target_link_libraries(test_headers GTest::Main Eigen3::Eigen Threads::Threads)
  target_compile_options(test_headers PRIVATE $<$<CONFIG:Release>:-O1>)
  target_precompile_headers(test_headers PRIVATE
    <gtest/gtest.h> <Eigen/Core> <Eigen/Geometry> <algorithm> <cmath> <filesystem> <fstream> <functional> <map> <optional> <sstream> <string>
    <vector>)
endif()

# add_unit_tests(NAME SOURCE...): by catkin if this is its build, so that its results lie where `catkin_make run_tests` looks for them.
function(add_unit_tests name)
  if(COLLISION_HULLS_ROS)
    catkin_add_gtest(${name} ${ARGN})
    target_link_libraries(${name} gtest_main)
  else()
    add_executable(${name} EXCLUDE_FROM_ALL ${ARGN})
    target_link_libraries(${name} GTest::Main)
    add_test(NAME ${name} COMMAND ${name})
    add_dependencies(tests ${name})
  endif()
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)  # most of a test's time is its compilation
  if(TARGET test_headers)
    target_precompile_headers(${name} REUSE_FROM test_headers)
  endif()
endfunction()

function(add_room_tests room)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS test/${room}/*_test.cpp)
  if(NOT sources)
    return()
  endif()
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")  # not among the programs, where rosrun would find them
  add_unit_tests(${room}_test ${sources})
  target_include_directories(${room}_test PRIVATE test src)
  set(library ${PROJECT_NAME}_bench command_line)
  if(room IN_LIST CORE_ROOMS AND NOT COLLISION_HULLS_UNITY)  # files joined need what any of them does
    set(library ${PROJECT_NAME}_core)  # what a room's tests link is what has to be built to run them
  endif()
  add_dependencies(${room}_test ${PROJECT_NAME}_reader)
  target_link_libraries(${room}_test ${PROJECT_NAME}_decode ${library} found::assimp found::fcl found::tbb found::tinyxml2 nlohmann_json::nlohmann_json)
  target_compile_definitions(${room}_test PRIVATE
    TEST_DATA="${PROJECT_SOURCE_DIR}/test/data" SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared"
    DEMO_ROBOT="${PROJECT_SOURCE_DIR}" PROGRAMS="${PROGRAMS_DIR}")
endfunction()

foreach(room ${TESTED_ROOMS})
  add_room_tests(${room})
endforeach()
add_dependencies(tools_test ${PROGRAMS})

# A reader program that does what its questions say, and breaks every rule.
add_executable(misbehaving_test_reader EXCLUDE_FROM_ALL test/sandbox/misbehaving_reader.cpp)
target_include_directories(misbehaving_test_reader PRIVATE src)
target_link_libraries(misbehaving_test_reader ${PROJECT_NAME}_core)
set_target_properties(misbehaving_test_reader PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")
foreach(room sandbox mesh)
  add_dependencies(${room}_test misbehaving_test_reader)
  target_compile_definitions(${room}_test PRIVATE TEST_READER="${PROJECT_BINARY_DIR}/tests/misbehaving_test_reader")
endforeach()

# The rooms of programs that are built only where a package is installed.
function(add_optional_room_tests room package)
  if(TARGET ${room}_room)
    add_room_tests(${room})
    target_link_libraries(${room}_test ${room}_room)
  else()
    add_test(NAME ${room}_test COMMAND ${CMAKE_COMMAND} -E echo "skipped: ${package} is not installed")
    set_tests_properties(${room}_test PROPERTIES SKIP_REGULAR_EXPRESSION "^skipped")
  endif()
endfunction()

add_optional_room_tests(physics DART)
add_optional_room_tests(planning OMPL)

# What a cancel may have to wait for: no test, since it measures.
add_executable(longest_look_test EXCLUDE_FROM_ALL test/looks/longest_look.cpp)
target_link_libraries(longest_look_test ${PROJECT_NAME})
set_target_properties(longest_look_test PROPERTIES OUTPUT_NAME longest_look RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")
