# What a shell finds that has sourced build/devel/setup.bash.
#
# In a build of this package alone, ROS sees devel/share/collision_hulls as the package's folder: links to the files that an installed
# package has. It must not be the source folder: rosrun does not look below <package>/build, where the programs are, and tab completion
# would offer every script in it, while it shall offer the programs alone. In a catkin workspace the source folder is the package, as ever.

set(PACKAGE_FILES package.xml scripts/completion.bash launch meshes rviz schema urdf)

# Before find_package(catkin), which adds the source folder to this list and takes a snapshot of the environment for the tests: their
# nodes lie in test/ros, so that for them the source folder is the package.
macro(begin_devel_space)
  set(STANDALONE OFF)
  if(CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR AND NOT DEFINED CATKIN_DEVEL_PREFIX)
    set(STANDALONE ON)
    file(REMOVE "${CMAKE_BINARY_DIR}/devel/.catkin")
  endif()
endmacro()

function(link_to_devel_space folder)
  set(package "${CATKIN_DEVEL_PREFIX}/share/${PROJECT_NAME}/${folder}")
  file(MAKE_DIRECTORY "${package}")
  foreach(file ${ARGN})
    get_filename_component(name "${file}" NAME)
    file(CREATE_LINK "${PROJECT_SOURCE_DIR}/${file}" "${package}/${name}" SYMBOLIC)
  endforeach()
endfunction()

macro(finish_devel_space)
  # Completion of options, in every kind of build; ROS_PACKAGE_PATH keeps what it held, which in a workspace is catkin's to decide.
  catkin_add_env_hooks(50.${PROJECT_NAME} SHELLS bash DIRECTORY "${PROJECT_SOURCE_DIR}/cmake/env_hooks")
  if(STANDALONE)
    catkin_add_env_hooks(1.ros_package_path SHELLS sh DIRECTORY "${PROJECT_SOURCE_DIR}/cmake/env_hooks" SKIP_INSTALL)
    file(GLOB messages RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS msg/*.msg)
    link_to_devel_space(. ${PACKAGE_FILES} action srv)
    link_to_devel_space(msg ${messages})
    # Empty: the packages are in share, by the path that the shell has sourced, be it through a link or not.
    file(WRITE "${CATKIN_DEVEL_PREFIX}/.catkin" "")
  else()
    link_to_devel_space(. scripts/completion.bash)
  endif()
endmacro()
