# Collision models in a physics engine, where DART is installed (libdart-dev, libdart-utils-urdf-dev, libdart-collision-bullet-dev): the
# program physics, and its tests.

find_package(DART 6.10 QUIET COMPONENTS utils-urdf collision-bullet)
if(DART_FOUND)
  file(GLOB PHYSICS_SOURCES CONFIGURE_DEPENDS src/physics/*.cpp)
  add_library(physics_room STATIC ${PHYSICS_SOURCES})
  target_include_directories(physics_room PUBLIC src)
  target_link_libraries(physics_room
    PUBLIC ${PROJECT_NAME} dart dart-utils-urdf dart-collision-bullet found::assimp nlohmann_json::nlohmann_json)
  add_executable(physics src/tools/physics.cpp)
  target_link_libraries(physics physics_room command_line)
  set_target_properties(physics PROPERTIES INSTALL_RPATH "$ORIGIN/..")
  install(TARGETS physics RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
endif()

function(add_physics_test)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")  # not among the programs; catkin asks for it at once
  file(GLOB physics_tests CONFIGURE_DEPENDS test/physics/*_test.cpp)
  catkin_add_gtest(physics_test ${physics_tests})
  target_include_directories(physics_test PRIVATE test)
  target_link_libraries(physics_test physics_room gtest_main)
  target_compile_definitions(physics_test PRIVATE DEMO_ROBOT="${CMAKE_CURRENT_SOURCE_DIR}")
endfunction()

if(CATKIN_ENABLE_TESTING AND DART_FOUND)
  add_physics_test()
elseif(CATKIN_ENABLE_TESTING)
  add_test(NAME physics_test COMMAND ${CMAKE_COMMAND} -E echo "skipped: DART is not installed")
  set_tests_properties(physics_test PROPERTIES SKIP_REGULAR_EXPRESSION "^skipped")
endif()
