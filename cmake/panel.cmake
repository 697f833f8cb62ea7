# The rviz panel, where rviz is (librviz-dev, which brings libinteractive-markers-dev, and qtbase5-dev), and its tests. Without it
# everything else is as it is with it.

find_package(rviz QUIET)
find_package(Qt5 QUIET COMPONENTS Widgets)
find_package(pluginlib QUIET)
find_package(interactive_markers QUIET)
if(rviz_FOUND AND Qt5_FOUND AND pluginlib_FOUND AND interactive_markers_FOUND)
  qt5_wrap_cpp(PANEL_MOC src/panel/hulls_panel.h src/panel/node_client.h src/panel/region_form.h src/panel/region_server.h)
  qt5_wrap_cpp(FORM_MOC src/panel/settings_form.h)
  add_library(${PROJECT_NAME}_panel MODULE
    src/panel/hulls_panel.cpp src/panel/link_table.cpp src/panel/node_client.cpp src/panel/panel_actions.cpp
    src/panel/panel_regions.cpp src/panel/region_form.cpp src/panel/region_markers.cpp src/panel/region_server.cpp
    src/panel/region_shape.cpp src/panel/settings_form.cpp src/panel/table_model.cpp src/panel/tolerance_scale.cpp
    src/ros/pen.cpp src/ros/preview/settings.cpp ${PANEL_MOC} ${FORM_MOC})
  add_dependencies(${PROJECT_NAME}_panel ${PROJECT_NAME}_generate_messages_cpp ${catkin_EXPORTED_TARGETS})
  target_include_directories(${PROJECT_NAME}_panel PRIVATE src)
  target_include_directories(${PROJECT_NAME}_panel SYSTEM PRIVATE ${catkin_INCLUDE_DIRS} ${rviz_INCLUDE_DIRS} ${pluginlib_INCLUDE_DIRS}
    ${interactive_markers_INCLUDE_DIRS})
  target_compile_definitions(${PROJECT_NAME}_panel PRIVATE QT_NO_KEYWORDS)
  target_link_libraries(${PROJECT_NAME}_panel ${PROJECT_NAME} ${catkin_LIBRARIES} ${rviz_LIBRARIES} ${pluginlib_LIBRARIES}
    ${interactive_markers_LIBRARIES} Qt5::Widgets)
  set_target_properties(${PROJECT_NAME}_panel PROPERTIES INSTALL_RPATH "$ORIGIN")
  set_up_unity(${PROJECT_NAME}_panel)
else()
  message(STATUS "No rviz panel, as rviz's headers or Qt's are missing: scripts/install_dependencies view installs them.")
endif()

function(add_panel_tests)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")
  catkin_add_gtest(panel_test
    test/panel/link_table_test.cpp test/panel/region_shape_test.cpp test/panel/tolerance_scale_test.cpp src/panel/link_table.cpp
    src/panel/region_shape.cpp src/panel/tolerance_scale.cpp)
  target_include_directories(panel_test PRIVATE test src)
  target_link_libraries(panel_test ${PROJECT_NAME} gtest_main)
  add_dependencies(panel_test ${PROJECT_NAME}_reader)

  if(NOT TARGET ${PROJECT_NAME}_panel)
    return()
  endif()
  catkin_add_gtest(panel_form_test
    test/panel/settings_form_test.cpp src/panel/settings_form.cpp src/panel/table_model.cpp src/panel/link_table.cpp
    src/panel/tolerance_scale.cpp ${FORM_MOC})
  add_dependencies(panel_form_test ${PROJECT_NAME}_panel)  # which makes FORM_MOC: one of the two has to come first
  target_include_directories(panel_form_test PRIVATE test src)
  target_compile_definitions(panel_form_test PRIVATE QT_NO_KEYWORDS)
  target_link_libraries(panel_form_test ${PROJECT_NAME} Qt5::Widgets)

  # What test/ros/panel.test drives rviz with.
  find_package(Qt5 QUIET COMPONENTS Test)
  if(NOT TARGET Qt5::Test)
    return()
  endif()
  add_executable(panel_driver EXCLUDE_FROM_ALL test/panel/panel_driver.cpp)
  target_include_directories(panel_driver SYSTEM PRIVATE ${catkin_INCLUDE_DIRS} ${rviz_INCLUDE_DIRS})
  target_link_libraries(panel_driver ${catkin_LIBRARIES} ${rviz_LIBRARIES} Qt5::Widgets Qt5::Test)
  add_dependencies(tests panel_driver)
endfunction()
