# Everything that a user of the installed package needs: headers, library, programs, launch files, demo robot.

foreach(program ${PROGRAMS})
  set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/..")
endforeach()

install(TARGETS ${PROJECT_NAME}
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
install(TARGETS ${PROGRAMS} RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(DIRECTORY include/${PROJECT_NAME}/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
install(FILES scripts/completion.bash DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
install(DIRECTORY launch meshes rviz urdf DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION} PATTERN source EXCLUDE)
catkin_install_python(PROGRAMS scripts/benchmark_charts scripts/decompose_client scripts/joint_sliders scripts/physics_charts scripts/rviz_at_root scripts/rviz_picture scripts/scene_charts
  scripts/stability_charts
  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
