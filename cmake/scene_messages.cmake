# Scenes that MoveIt and OctoMap publish, where the packages of their messages are: Debian has neither. moveit_msgs brings octomap_msgs.

set(SCENE_MESSAGE_FILES "/(octomap_message|planning_scene)(_test)?\\.cpp$")  # sources and tests, whether they are built or not
set(SCENE_MESSAGE_SOURCES)
find_package(octomap_msgs QUIET)
if(octomap_msgs_FOUND)
  list(APPEND SCENE_MESSAGE_SOURCES src/ros/octomap_message.cpp)
  list(APPEND SCENE_MESSAGE_TESTS test/ros/octomap_message_test.cpp)
  list(APPEND SCENE_MESSAGE_DEFINITIONS COLLISION_HULLS_OCTOMAP_MSGS)
  list(APPEND SCENE_MESSAGE_INCLUDE_DIRS ${octomap_msgs_INCLUDE_DIRS})
  list(APPEND SCENE_MESSAGE_TARGETS ${octomap_msgs_EXPORTED_TARGETS})  # headers that the same workspace makes
  find_package(moveit_msgs QUIET)
  if(moveit_msgs_FOUND)
    list(APPEND SCENE_MESSAGE_SOURCES src/ros/planning_scene.cpp)
    list(APPEND SCENE_MESSAGE_TESTS test/ros/planning_scene_test.cpp)
    list(APPEND SCENE_MESSAGE_DEFINITIONS COLLISION_HULLS_MOVEIT_MSGS)
    list(APPEND SCENE_MESSAGE_INCLUDE_DIRS ${moveit_msgs_INCLUDE_DIRS})
    list(APPEND SCENE_MESSAGE_TARGETS ${moveit_msgs_EXPORTED_TARGETS})
  endif()
endif()
