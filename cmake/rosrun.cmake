# rosrun passes over what lies in build/ of a package's own folder, where scripts/demo and scripts/test build: links beside it show it the
# programs. Not the node, which roslaunch would find twice.
string(FIND "${PROJECT_BINARY_DIR}/" "${PROJECT_SOURCE_DIR}/build/" build_in_source)
if(build_in_source EQUAL 0)
  foreach(program ${PROGRAMS} physics peer_bullet_hacd peer_bullet_vcd)
    if(TARGET ${program} AND NOT program STREQUAL "${PROJECT_NAME}_node")
      file(MAKE_DIRECTORY "${PROJECT_SOURCE_DIR}/.rosrun")
      file(CREATE_LINK "${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION}/${program}" "${PROJECT_SOURCE_DIR}/.rosrun/${program}" SYMBOLIC)
    endif()
  endforeach()
endif()
