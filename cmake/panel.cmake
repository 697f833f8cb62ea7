# The rviz panel, where rviz is (librviz-dev, which brings libinteractive-markers-dev, and qtbase5-dev), and its tests. Without it
# everything else is as it is with it.

find_package(rviz QUIET)
find_package(Qt5 QUIET COMPONENTS Widgets)
find_package(pluginlib QUIET)
find_package(interactive_markers QUIET)
if(rviz_FOUND AND Qt5_FOUND AND pluginlib_FOUND AND interactive_markers_FOUND)
  room_sources(PANEL_SOURCES panel)
  add_library(${PROJECT_NAME}_panel MODULE ${PANEL_SOURCES} src/ros/pen.cpp src/ros/preview/settings.cpp)
  add_dependencies(${PROJECT_NAME}_panel ${PROJECT_NAME}_generate_messages_cpp ${catkin_EXPORTED_TARGETS})
  target_include_directories(${PROJECT_NAME}_panel PRIVATE src)
  target_include_directories(${PROJECT_NAME}_panel SYSTEM PRIVATE ${catkin_INCLUDE_DIRS} ${rviz_INCLUDE_DIRS} ${pluginlib_INCLUDE_DIRS}
    ${interactive_markers_INCLUDE_DIRS})
  target_compile_definitions(${PROJECT_NAME}_panel PRIVATE QT_NO_KEYWORDS)
  target_link_libraries(${PROJECT_NAME}_panel ${PROJECT_NAME} ${catkin_LIBRARIES} ${rviz_LIBRARIES} ${pluginlib_LIBRARIES}
    ${interactive_markers_LIBRARIES} Qt5::Widgets)
  set_target_properties(${PROJECT_NAME}_panel PROPERTIES AUTOMOC ON INSTALL_RPATH "$ORIGIN")
  set_up_unity(${PROJECT_NAME}_panel)
else()
  message(STATUS "No rviz panel, as rviz's headers or Qt's are missing: scripts/install_dependencies view installs them.")
endif()

# What knows neither rviz nor Qt is tested without them, the forms (test/panel/*_form_test.cpp) with Qt alone. A test of another file than
# those listed here does not link.
function(add_panel_tests)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")
  file(GLOB form_tests CONFIGURE_DEPENDS test/panel/*_form_test.cpp)
  file(GLOB plain_tests CONFIGURE_DEPENDS test/panel/*_test.cpp)
  list(REMOVE_ITEM plain_tests ${form_tests})
  set(plain_sources src/panel/link_table.cpp src/panel/region_shape.cpp src/panel/tolerance_scale.cpp)
  catkin_add_gtest(panel_test ${plain_tests} ${plain_sources})
  target_include_directories(panel_test PRIVATE test src)
  target_link_libraries(panel_test ${PROJECT_NAME} gtest_main)
  add_dependencies(panel_test ${PROJECT_NAME}_reader)

  if(NOT TARGET ${PROJECT_NAME}_panel)
    return()
  endif()
  catkin_add_gtest(panel_form_test ${form_tests} src/panel/settings_form.cpp src/panel/table_model.cpp ${plain_sources})
  set_target_properties(panel_form_test PROPERTIES AUTOMOC ON)
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
  target_link_libraries(panel_driver ${catkin_LIBRARIES} ${rviz_LIBRARIES} Qt5::Widgets Qt5::Test X11)
  add_dependencies(tests panel_driver)
endfunction()
