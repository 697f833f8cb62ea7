# The node, the only program that knows ROS, with its tests, which link all of it but its main().

include(cmake/scene_messages.cmake)

function(include_ros_for target)
  target_include_directories(${target} PRIVATE src)
  target_include_directories(${target} SYSTEM PRIVATE ${catkin_INCLUDE_DIRS} ${SCENE_MESSAGE_INCLUDE_DIRS})
endfunction()

room_sources(NODE_SOURCES ros)
list(REMOVE_ITEM NODE_SOURCES "${PROJECT_SOURCE_DIR}/src/ros/bags/bag_reader.cpp" "${PROJECT_SOURCE_DIR}/src/ros/${PROJECT_NAME}_node.cpp")
list(FILTER NODE_SOURCES EXCLUDE REGEX "${SCENE_MESSAGE_FILES}")
add_library(ros_room STATIC ${NODE_SOURCES} ${SCENE_MESSAGE_SOURCES})
# The messages' headers alone: code for other languages takes time, too.
add_dependencies(ros_room ${PROJECT_NAME}_generate_messages_cpp ${catkin_EXPORTED_TARGETS} ${SCENE_MESSAGE_TARGETS})
include_ros_for(ros_room)
target_compile_definitions(ros_room PUBLIC ${SCENE_MESSAGE_DEFINITIONS})
target_link_libraries(ros_room PUBLIC ${PROJECT_NAME} ${catkin_LIBRARIES})
set_up_unity(ros_room)
add_executable(${PROJECT_NAME}_node src/ros/${PROJECT_NAME}_node.cpp)
include_ros_for(${PROJECT_NAME}_node)
target_link_libraries(${PROJECT_NAME}_node ros_room)
set_target_properties(${PROJECT_NAME}_node PROPERTIES INSTALL_RPATH "$ORIGIN/..")

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
  file(GLOB ros_tests CONFIGURE_DEPENDS test/ros/*_test.cpp)
  list(FILTER ros_tests EXCLUDE REGEX "${SCENE_MESSAGE_FILES}")
  catkin_add_gtest(ros_test ${ros_tests} ${SCENE_MESSAGE_TESTS})
  add_dependencies(ros_test ${PROJECT_NAME}_reader ${PROJECT_NAME}_bag_reader)
  include_ros_for(ros_test)
  target_include_directories(ros_test PRIVATE test)
  target_link_libraries(ros_test ros_room gtest_main)

  # A master for each, on a free port; only picture.test needs a display, which it starts itself.
  file(GLOB node_tests CONFIGURE_DEPENDS test/ros/*.test)
  foreach(node_test ${node_tests})
    get_filename_component(name ${node_test} NAME_WE)
    add_rostest(test/ros/${name}.test DEPENDENCIES ${PROJECT_NAME}_node)
    # Alone, as they wait for answers in limited time.
    set_tests_properties(_ctest_${PROJECT_NAME}_rostest_test_ros_${name}.test PROPERTIES ENVIRONMENT ROS_HOSTNAME=localhost RUN_SERIAL TRUE)
  endforeach()
endfunction()
