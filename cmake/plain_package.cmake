# The frame without ROS and catkin: libraries, programs and their tests, laid out as catkin lays them out, and a CMake package for
# find_package(collision_hulls), which gives the targets collision_hulls::collision_hulls and collision_hulls::collision_hulls_core.

set(BUILD_SHARED_LIBS ON)
set(LIBRARY_DESTINATION lib)
set(PROGRAM_DESTINATION lib/${PROJECT_NAME})
set(INCLUDE_DESTINATION include/${PROJECT_NAME})
set(SHARE_DESTINATION share/${PROJECT_NAME})

# The system's Python, which the packages of the system are for. Debian's looks below /usr/local in a folder with its version.
find_program(PYTHON_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(PYTHON_EXECUTABLE python3)
set(python_version 3)
if(PYTHON_EXECUTABLE)
  execute_process(COMMAND "${PYTHON_EXECUTABLE}" -c "import sysconfig; print(sysconfig.get_python_version(), end='')" OUTPUT_VARIABLE python_version)
endif()
if(EXISTS "/etc/debian_version")
  set(PYTHON_DESTINATION lib/python${python_version}/dist-packages/${PROJECT_NAME})
else()
  set(PYTHON_DESTINATION lib/python${python_version}/site-packages/${PROJECT_NAME})
endif()
set(PYTHON_PACKAGE_DIR "${PROJECT_BINARY_DIR}/${PYTHON_DESTINATION}")

set(PROGRAMS_DIR "${PROJECT_BINARY_DIR}/${PROGRAM_DESTINATION}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${LIBRARY_DESTINATION}")
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROGRAMS_DIR}")

find_package(GTest QUIET)
set(COLLISION_HULLS_TESTS ${GTEST_FOUND})
if(DEFINED BUILD_TESTING AND NOT BUILD_TESTING)
  set(COLLISION_HULLS_TESTS OFF)
endif()
if(COLLISION_HULLS_TESTS)
  enable_testing()
  add_custom_target(tests)
endif()

function(install_cmake_package)
  set(config "${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake")
  file(WRITE "${config}"
    "include(CMakeFindDependencyMacro)\nfind_dependency(Eigen3)\ninclude(\"\${CMAKE_CURRENT_LIST_DIR}/${PROJECT_NAME}Targets.cmake\")\ninclude(\"\${CMAKE_CURRENT_LIST_DIR}/${PROJECT_NAME}-functions.cmake\")\n")
  include(CMakePackageConfigHelpers)
  write_basic_package_version_file("${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
  install(TARGETS ${PROJECT_NAME} ${PROJECT_NAME}_core EXPORT ${PROJECT_NAME}Targets LIBRARY DESTINATION ${LIBRARY_DESTINATION})
  install(EXPORT ${PROJECT_NAME}Targets NAMESPACE ${PROJECT_NAME}:: DESTINATION ${SHARE_DESTINATION}/cmake)
  install(FILES "${config}" "${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake" "${PROJECT_SOURCE_DIR}/cmake/${PROJECT_NAME}-functions.cmake" DESTINATION ${SHARE_DESTINATION}/cmake)
endfunction()
