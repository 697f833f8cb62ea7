# The ROS package's frame: catkin, messages, and where things go. cmake/node.cmake adds the node.

# Message generation needs the Python that has catkin's modules: on Debian the system's, whatever comes first on PATH.
if(NOT DEFINED PYTHON_EXECUTABLE AND NOT DEFINED Python3_EXECUTABLE AND EXISTS "/usr/lib/python3/dist-packages/catkin_pkg")
  set(PYTHON_EXECUTABLE /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()

include(cmake/devel_space.cmake)
begin_devel_space()
# Debian 11's catkin remembers from the last configuration that there is GoogleMock, but not its targets.
unset(GMOCK_FOUND CACHE)
unset(GTEST_FOUND CACHE)

find_package(catkin REQUIRED COMPONENTS
  actionlib actionlib_msgs geometry_msgs message_generation rosbag_storage roscpp roslib sensor_msgs std_msgs tf2_msgs visualization_msgs)

# catkin asks for tests by default; a machine without what they need builds all the rest.
if(CATKIN_ENABLE_TESTING)
  find_package(rostest QUIET)
  if(NOT rostest_FOUND OR NOT GTEST_FOUND)
    message(WARNING "No tests, as gtest or rostest is missing: scripts/install_dependencies test installs them.")
    set(CATKIN_ENABLE_TESTING OFF)
  endif()
endif()
set(COLLISION_HULLS_TESTS ${CATKIN_ENABLE_TESTING})

add_message_files(FILES LinkChoice.msg LinkPreview.msg LinkRegion.msg LinkReport.msg NodeState.msg RunTotals.msg)
add_service_files(FILES Build.srv Decompose.srv FitScene.srv Preview.srv Validate.srv)
add_action_files(FILES Build.action Decompose.action FitScene.action Validate.action)
generate_messages(DEPENDENCIES actionlib_msgs geometry_msgs std_msgs)

# A user of the library needs Eigen's headers and nothing else; a user of the messages their message packages.
catkin_package(
  INCLUDE_DIRS include
  LIBRARIES ${PROJECT_NAME} ${PROJECT_NAME}_core
  CATKIN_DEPENDS actionlib_msgs geometry_msgs message_runtime std_msgs
  DEPENDS EIGEN3
  CFG_EXTRAS ${PROJECT_NAME}-functions.cmake)

set(LIBRARY_DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
set(PROGRAM_DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
set(INCLUDE_DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
set(SHARE_DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
set(PYTHON_DESTINATION ${CATKIN_PACKAGE_PYTHON_DESTINATION})
set(PYTHON_PACKAGE_DIR "${CATKIN_DEVEL_PREFIX}/${PYTHON_DESTINATION}")
set(PROGRAMS_DIR "${CATKIN_DEVEL_PREFIX}/${PROGRAM_DESTINATION}")
