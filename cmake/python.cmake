# The Python module collision_hulls, where pybind11 is (pybind11-dev, python3-dev).
#
# It is the same Python package as that of the messages, as ROS calls that by the name of the ROS package: an extension and an __init__.py
# beside the folders msg and srv. Message generation leaves an __init__.py as it is, and installs the folder of the devel space with all that
# is in it. This __init__.py loads the extension when a function is called, so that who wants messages alone needs neither it nor numpy.
#
# pybind11's own CMake files would set catkin's PYTHON_VERSION to another value.

option(COLLISION_HULLS_PYTHON "Build the Python module, where pybind11 is installed" ON)

find_path(PYBIND11_INCLUDE_DIR pybind11/numpy.h)
mark_as_advanced(PYBIND11_INCLUDE_DIR)

# PYTHON_FACTS: the folder of Python.h, and the ending of extensions.
set(PYTHON_FACTS)
if(COLLISION_HULLS_PYTHON AND PYTHON_EXECUTABLE AND PYBIND11_INCLUDE_DIR)
  execute_process(
    COMMAND "${PYTHON_EXECUTABLE}" -c "import sysconfig as s; print(s.get_path('include'), s.get_config_var('EXT_SUFFIX'), sep=';', end='')"
    OUTPUT_VARIABLE PYTHON_FACTS ERROR_QUIET)
endif()
if(PYTHON_FACTS)
  list(GET PYTHON_FACTS 0 python_headers)
endif()
# Python itself is not linked with sanitizers, and could not load a module that is.
if(NOT PYTHON_FACTS OR NOT EXISTS "${python_headers}/Python.h" OR COLLISION_HULLS_SANITIZE OR COLLISION_HULLS_SANITIZE_THREADS OR COLLISION_HULLS_FUZZ)
  message(STATUS "No Python module: it needs pybind11 and Python's headers (pybind11-dev, python3-dev), and no sanitizers.")
  return()
endif()

list(GET PYTHON_FACTS 1 python_suffix)
room_sources(PYTHON_SOURCES python)
add_library(${PROJECT_NAME}_python MODULE ${PYTHON_SOURCES})
add_dependencies(${PROJECT_NAME}_python ${PROJECT_NAME}_reader)
target_include_directories(${PROJECT_NAME}_python PRIVATE src)
target_include_directories(${PROJECT_NAME}_python SYSTEM PRIVATE "${PYBIND11_INCLUDE_DIR}" "${python_headers}")
target_link_libraries(${PROJECT_NAME}_python command_line)
set_target_properties(command_line PROPERTIES POSITION_INDEPENDENT_CODE ON)
file(RELATIVE_PATH to_libraries "/${PYTHON_DESTINATION}" "/${LIBRARY_DESTINATION}")
set_target_properties(${PROJECT_NAME}_python PROPERTIES
  OUTPUT_NAME _core PREFIX "" SUFFIX "${python_suffix}" CXX_VISIBILITY_PRESET hidden
  LIBRARY_OUTPUT_DIRECTORY "${PYTHON_PACKAGE_DIR}" INSTALL_RPATH "$ORIGIN/${to_libraries}")
# py.typed: type checkers read the annotations.
foreach(file __init__.py py.typed)
  configure_file(src/python/${PROJECT_NAME}/${file} "${PYTHON_PACKAGE_DIR}/${file}" COPYONLY)
  install(FILES src/python/${PROJECT_NAME}/${file} DESTINATION ${PYTHON_DESTINATION})
endforeach()

install(TARGETS ${PROJECT_NAME}_python LIBRARY DESTINATION ${PYTHON_DESTINATION})
