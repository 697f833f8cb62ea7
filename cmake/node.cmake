# The node, the only program that knows ROS, with its tests.

include(cmake/scene_messages.cmake)
room_sources(NODE_SOURCES ros)
list(FILTER NODE_SOURCES EXCLUDE REGEX "/(bag_reader|octomap_message|planning_scene)\\.cpp$")
add_executable(${PROJECT_NAME}_node ${NODE_SOURCES} ${SCENE_MESSAGE_SOURCES})
# The messages' headers alone: code for other languages takes time, too.
add_dependencies(${PROJECT_NAME}_node ${PROJECT_NAME}_generate_messages_cpp ${catkin_EXPORTED_TARGETS} ${SCENE_MESSAGE_TARGETS})
target_include_directories(${PROJECT_NAME}_node PRIVATE src)
target_include_directories(${PROJECT_NAME}_node SYSTEM PRIVATE ${catkin_INCLUDE_DIRS} ${SCENE_MESSAGE_INCLUDE_DIRS})
target_compile_definitions(${PROJECT_NAME}_node PRIVATE ${SCENE_MESSAGE_DEFINITIONS})
target_link_libraries(${PROJECT_NAME}_node ${PROJECT_NAME} ${catkin_LIBRARIES})
set_target_properties(${PROJECT_NAME}_node PROPERTIES INSTALL_RPATH "$ORIGIN/..")
set_up_unity(${PROJECT_NAME}_node)

# Reads bags for the node, in a process of its own.
add_executable(${PROJECT_NAME}_bag_reader src/ros/bags/bag_reader.cpp)
add_dependencies(${PROJECT_NAME}_bag_reader ${catkin_EXPORTED_TARGETS})
target_include_directories(${PROJECT_NAME}_bag_reader PRIVATE src)
target_include_directories(${PROJECT_NAME}_bag_reader SYSTEM PRIVATE ${catkin_INCLUDE_DIRS})
target_link_libraries(${PROJECT_NAME}_bag_reader ${PROJECT_NAME}_core ${catkin_LIBRARIES})
set_target_properties(${PROJECT_NAME}_bag_reader PROPERTIES INSTALL_RPATH "$ORIGIN/..")

add_dependencies(${PROJECT_NAME}_node ${PROJECT_NAME}_reader ${PROJECT_NAME}_bag_reader)
list(APPEND PROGRAMS ${PROJECT_NAME}_node ${PROJECT_NAME}_bag_reader)

function(add_node_tests)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")  # not among the programs, where rosrun would find them
  catkin_add_gtest(ros_test
    test/ros/conversions_test.cpp test/ros/joint_states_test.cpp test/ros/markers_test.cpp test/ros/robot_trees_test.cpp
    test/ros/settings_test.cpp test/ros/validation_test.cpp test/ros/worker_test.cpp ${SCENE_MESSAGE_TESTS}
    src/ros/annotations.cpp src/ros/conversions.cpp src/ros/joint_states.cpp src/ros/markers.cpp src/ros/pen.cpp
    src/ros/preview/robot_trees.cpp src/ros/preview/settings.cpp src/ros/preview/validation.cpp src/ros/robot_bounds.cpp
    src/ros/worker.cpp ${SCENE_MESSAGE_SOURCES})
  add_dependencies(ros_test ${PROJECT_NAME}_reader ${PROJECT_NAME}_bag_reader ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS} ${SCENE_MESSAGE_TARGETS})
  target_include_directories(ros_test PRIVATE src test)
  target_include_directories(ros_test SYSTEM PRIVATE ${catkin_INCLUDE_DIRS} ${SCENE_MESSAGE_INCLUDE_DIRS})
  target_link_libraries(ros_test ${PROJECT_NAME} ${catkin_LIBRARIES} gtest_main)

  # A master for each, on a free port; only picture.test needs a display, which it starts itself.
  file(GLOB node_tests CONFIGURE_DEPENDS test/ros/*.test)
  foreach(node_test ${node_tests})
    get_filename_component(name ${node_test} NAME_WE)
    add_rostest(test/ros/${name}.test DEPENDENCIES ${PROJECT_NAME}_node)
    # Alone, as they wait for answers in limited time.
    set_tests_properties(_ctest_${PROJECT_NAME}_rostest_test_ros_${name}.test PROPERTIES ENVIRONMENT ROS_HOSTNAME=localhost RUN_SERIAL TRUE)
  endforeach()
endfunction()
