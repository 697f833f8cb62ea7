# Everything that a user of the installed package needs: headers, libraries, programs, launch files, demo robot.

foreach(program ${PROGRAMS})
  set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/..")
endforeach()

install(TARGETS ${LIBRARIES} EXPORT ${PROJECT_NAME}Targets
  ARCHIVE DESTINATION ${LIBRARY_DESTINATION}
  LIBRARY DESTINATION ${LIBRARY_DESTINATION}
  RUNTIME DESTINATION ${PROGRAM_DESTINATION})
install(TARGETS ${PROGRAMS} RUNTIME DESTINATION ${PROGRAM_DESTINATION})
install(DIRECTORY include/${PROJECT_NAME}/ DESTINATION ${INCLUDE_DESTINATION})
if(NOT COLLISION_HULLS_ROS)
  install_cmake_package()
  return()
endif()

install(FILES scripts/completion.bash DESTINATION ${SHARE_DESTINATION})
install(DIRECTORY launch meshes rviz urdf DESTINATION ${SHARE_DESTINATION} PATTERN source EXCLUDE)
catkin_install_python(PROGRAMS scripts/benchmark_charts scripts/decompose_client scripts/joint_sliders scripts/physics_charts scripts/rviz_at_root scripts/rviz_picture scripts/scene_charts
  scripts/stability_charts
  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
