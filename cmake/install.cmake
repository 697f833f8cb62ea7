# Everything that a user of the installed package needs: headers, libraries, programs, launch files, demo robot.

install(TARGETS ${PROJECT_NAME} ${PROJECT_NAME}_core
  ARCHIVE DESTINATION ${LIBRARY_DESTINATION}
  LIBRARY DESTINATION ${LIBRARY_DESTINATION}
  RUNTIME DESTINATION ${PROGRAM_DESTINATION})
foreach(program ${PROGRAMS})
  install(TARGETS ${program} RUNTIME DESTINATION ${PROGRAM_DESTINATION})
endforeach()
if(TARGET ${PROJECT_NAME}_panel)
  install(TARGETS ${PROJECT_NAME}_panel LIBRARY DESTINATION ${LIBRARY_DESTINATION})
endif()
install(DIRECTORY include/${PROJECT_NAME}/ DESTINATION ${INCLUDE_DESTINATION})
# The modules and the workflow of scripts/batch/batch, which finds them from its own place.
install(FILES scripts/batch/Snakefile scripts/batch/slurm_status src/web/page/style.css DESTINATION ${SHARE_DESTINATION}/batch)
install(DIRECTORY scripts/batch/ DESTINATION ${SHARE_DESTINATION}/batch FILES_MATCHING PATTERN "*.py" PATTERN "page.*")
install(FILES LICENSE scripts/completion.bash DESTINATION ${SHARE_DESTINATION})
install(DIRECTORY meshes schema urdf DESTINATION ${SHARE_DESTINATION} PATTERN source EXCLUDE)
install(FILES scripts/charts.py DESTINATION ${PROGRAM_DESTINATION})  # beside the scripts that import it, as ros_session.py below
if(NOT COLLISION_HULLS_ROS)
  install(PROGRAMS scripts/batch/batch scripts/benchmark_charts scripts/physics_charts scripts/plan_charts scripts/scene_charts scripts/stability_charts
    DESTINATION ${PROGRAM_DESTINATION})
  install_cmake_package()
  return()
endif()

install(DIRECTORY launch rviz DESTINATION ${SHARE_DESTINATION})
catkin_install_python(PROGRAMS scripts/batch/batch scripts/benchmark_charts scripts/decompose_client scripts/joint_sliders scripts/physics_charts scripts/plan_charts scripts/preview_latency scripts/rviz_at_root scripts/rviz_picture scripts/scene_charts
  scripts/stability_charts
  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(FILES scripts/ros_session.py DESTINATION ${PROGRAM_DESTINATION})
