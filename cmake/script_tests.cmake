# Tests of the package as a whole: its form, its programs as a user calls them, and its use by another package.
# Exit status 77 of a script means that a program it needs is not there. None has a program's name: rosrun would find it, too.

function(add_script_test name)
  add_test(NAME ${name} COMMAND ${ARGN} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT "ROS_HOSTNAME=localhost;PYTHONDONTWRITEBYTECODE=1")
endfunction()

add_script_test(catkin_lint test/scripts/catkin_lint)
add_script_test(clang_format test/scripts/clang_format)
add_script_test(shellcheck test/scripts/shell_scripts)
add_script_test(rooms test/scripts/rooms "${CORE_ROOMS}" "${ROBOT_ROOMS}" "${OUTER_ROOMS}" $<TARGET_FILE:${PROJECT_NAME}_core> $<TARGET_FILE:${PROJECT_NAME}>)
add_script_test(without_ros test/scripts/without_ros "${CMAKE_CXX_COMPILER_LAUNCHER}")
add_script_test(documented_options test/scripts/documented_options ${PROGRAMS_DIR}/decompose ${PROGRAMS_DIR}/fit_scene)
add_script_test(documented_ros test/scripts/documented_ros)
add_script_test(documents test/scripts/documents)
add_script_test(constants test/scripts/constants)
add_script_test(readme_commands test/scripts/readme_commands ${PROJECT_BINARY_DIR})
add_script_test(figures test/scripts/figures_test ${PROGRAMS_DIR})
add_script_test(benchmark test/scripts/benchmark_test ${PROGRAMS_DIR})
add_script_test(stability test/scripts/stability_test ${PROGRAMS_DIR})
add_script_test(physics test/scripts/physics_test ${PROGRAMS_DIR})
add_script_test(scene_charts test/scripts/scene_charts_test ${PROGRAMS_DIR})
add_script_test(results test/scripts/results_test ${PROGRAMS_DIR})
add_script_test(goals test/scripts/goals_test ${PROGRAMS_DIR})
add_script_test(demo test/scripts/demo_test ${PROJECT_BINARY_DIR})
add_script_test(rosrun test/scripts/rosrun_test ${PROJECT_BINARY_DIR})
add_script_test(demo_meshes test/demo/regenerate_test)

# catkin bakes the prefix into what it installs, so the test needs one of its own: scripts/test sets it.
string(FIND "${CMAKE_INSTALL_PREFIX}" "${PROJECT_BINARY_DIR}/" prefix_in_build)
if(prefix_in_build EQUAL 0)
  add_script_test(consumer test/scripts/consumer "${PROJECT_BINARY_DIR}" "${CMAKE_INSTALL_PREFIX}")
endif()
