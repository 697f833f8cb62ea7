# For the build of a description's own package, after find_package(collision_hulls) or find_package(catkin COMPONENTS collision_hulls):
#
#   collision_hulls_generate(urdf/arm.urdf CONFIG config/hulls.yaml)
#   collision_hulls_add_test(urdf/arm.urdf MAX_UNCOVERED 0 MAX_PROTRUSION 1cm)
#
# The programs lie beside the package that was found, in an installed tree as in a devel space.

set(COLLISION_HULLS_PROGRAMS_DIR "${collision_hulls_DIR}/../../../lib/collision_hulls" CACHE INTERNAL "where collision_hulls' programs are")

# catkin gives variables alone. With these, a project links the library alike whether it was built with ROS or without.
foreach(library collision_hulls collision_hulls_core)
  if(collision_hulls_LIBRARIES AND NOT TARGET collision_hulls::${library})
    add_library(collision_hulls::${library} INTERFACE IMPORTED)
    set_target_properties(collision_hulls::${library} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${collision_hulls_INCLUDE_DIRS}"
      INTERFACE_LINK_LIBRARIES "${collision_hulls_LIBRARIES}")
  endif()
endforeach()

# Lists may be empty; what takes one value may not, as a gate would be gone with a variable that is not set.
function(_collision_hulls_expect_values call missing)
  if(missing)
    list(REMOVE_ITEM missing PACKAGE_PATH OPTIONS DEPENDS)
  endif()
  if(missing)
    message(FATAL_ERROR "${call}: ${missing} has no value; is it a variable that is not set?")
  endif()
endfunction()

# What a program of collision_hulls is called in commands and, if it is built here, depended on by.
function(_collision_hulls_program result name)
  if(TARGET ${name})
    set(${result} $<TARGET_FILE:${name}> PARENT_SCOPE)
    return()
  endif()
  get_filename_component(program "${COLLISION_HULLS_PROGRAMS_DIR}/${name}" ABSOLUTE)
  if(NOT EXISTS "${program}")
    message(FATAL_ERROR "collision_hulls: there is no program '${program}': build and install collision_hulls, or set "
      "COLLISION_HULLS_PROGRAMS_DIR to the folder of its programs.")
  endif()
  set(${result} "${program}" PARENT_SCOPE)
endfunction()

# The output folder of a description: OUTPUT, or <name>_collision below the build.
function(_collision_hulls_output result robot output)
  get_filename_component(name "${robot}" NAME_WE)
  if(output)
    get_filename_component(output "${output}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_BINARY_DIR}")
  else()
    set(output "${CMAKE_CURRENT_BINARY_DIR}/${name}_collision")
  endif()
  set(${result} "${output}" PARENT_SCOPE)
endfunction()

# collision_hulls_generate(ROBOT [CONFIG FILE] [OUTPUT DIR] [TARGET NAME] [PACKAGE_PATH DIR...] [OPTIONS ARG...] [DEPENDS FILE...])
#
# Makes the collision model of a .urdf or .xacro file when the project is built: a package in OUTPUT (default <build>/<robot>_collision), by
# the target TARGET (default <robot>_collision, in which characters that target names do not allow become "_"). <robot>: the file's name up
# to its first dot. ROS does not look into a build folder: install the package (doc/library.md). It is made again if the description, the
# configuration, a file in DEPENDS or decompose itself has changed; without DEPENDS, if anything in the source package's folders meshes,
# urdf and xacro has. Nothing else runs, and meshes that did not change come from the cache. OPTIONS are those of decompose. The package
# that is built is found by its own name in URIs.
function(collision_hulls_generate robot)
  cmake_parse_arguments(arg "" "CONFIG;OUTPUT;TARGET" "PACKAGE_PATH;OPTIONS;DEPENDS" ${ARGN})
  _collision_hulls_expect_values("collision_hulls_generate(${robot})" "${arg_KEYWORDS_MISSING_VALUES}")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "collision_hulls_generate(${robot}): '${arg_UNPARSED_ARGUMENTS}' is not understood; options of decompose go after OPTIONS.")
  endif()
  _collision_hulls_program(decompose decompose)
  _collision_hulls_output(output "${robot}" "${arg_OUTPUT}")
  get_filename_component(robot_file "${robot}" ABSOLUTE)
  get_filename_component(name "${robot}" NAME_WE)
  set(target "${arg_TARGET}")
  if(NOT target)
    string(REGEX REPLACE "[^A-Za-z0-9_.+-]" "_" target "${name}_collision")
  endif()
  set(inputs "${robot_file}")
  set(command "${decompose}" "${robot_file}" --output "${output}" --quiet --package-path "${PROJECT_NAME}=${PROJECT_SOURCE_DIR}")
  if(arg_CONFIG)
    get_filename_component(config "${arg_CONFIG}" ABSOLUTE)
    list(APPEND inputs "${config}")
    list(APPEND command --config "${config}")
  endif()
  foreach(path ${arg_PACKAGE_PATH})
    list(APPEND command --package-path "${path}")
  endforeach()
  if(NOT arg_DEPENDS)
    file(GLOB_RECURSE arg_DEPENDS CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/meshes/*" "${PROJECT_SOURCE_DIR}/urdf/*" "${PROJECT_SOURCE_DIR}/xacro/*")
  endif()
  # A stamp, since the output is replaced as a whole, with files that keep their dates.
  set(stamp "${CMAKE_CURRENT_BINARY_DIR}/${target}.stamp")
  add_custom_command(
    OUTPUT "${stamp}"
    COMMAND ${command} ${arg_OPTIONS}
    COMMAND "${CMAKE_COMMAND}" -E touch "${stamp}"
    DEPENDS ${inputs} ${arg_DEPENDS} "${decompose}"
    COMMENT "Collision model of ${robot}"
    VERBATIM)
  add_custom_target(${target} ALL DEPENDS "${stamp}")
  if(TARGET collision_hulls_reader)
    add_dependencies(${target} decompose collision_hulls_reader)
  endif()
  set_property(DIRECTORY PROPERTY COLLISION_HULLS_OUTPUT_${robot_file} "${output}")
endfunction()

# collision_hulls_add_test(ROBOT [RESULT FILE] [NAME NAME] [MAX_UNCOVERED LENGTH] [MAX_PROTRUSION LENGTH] [PACKAGE_PATH DIR...]
#                          [OPTIONS ARG...])
#
# A test that runs verify on the description and on RESULT: another description, or a package; by default what collision_hulls_generate(ROBOT)
# makes, which comes first and in the same CMakeLists.txt if it has an OUTPUT of its own. RESULT may be ROBOT itself. Without a gate it only fails
# if something cannot be read. OPTIONS are those of verify.
function(collision_hulls_add_test robot)
  cmake_parse_arguments(arg "" "RESULT;NAME;MAX_UNCOVERED;MAX_PROTRUSION" "PACKAGE_PATH;OPTIONS" ${ARGN})
  _collision_hulls_expect_values("collision_hulls_add_test(${robot})" "${arg_KEYWORDS_MISSING_VALUES}")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "collision_hulls_add_test(${robot}): '${arg_UNPARSED_ARGUMENTS}' is not understood; options of verify go after OPTIONS.")
  endif()
  _collision_hulls_program(verify verify)
  get_filename_component(robot_file "${robot}" ABSOLUTE)
  get_filename_component(name "${robot}" NAME_WE)
  if(arg_RESULT)
    get_filename_component(result "${arg_RESULT}" ABSOLUTE)
  else()
    get_property(result DIRECTORY PROPERTY COLLISION_HULLS_OUTPUT_${robot_file})
    if(NOT result)
      _collision_hulls_output(result "${robot}" "")
    endif()
    get_filename_component(folder "${result}" DIRECTORY)
    list(APPEND arg_PACKAGE_PATH "${folder}")
  endif()
  if(NOT arg_NAME)
    set(arg_NAME collision_hulls_${name})
  endif()
  set(command "${verify}" "${robot_file}" "${result}" --package-path "${PROJECT_NAME}=${PROJECT_SOURCE_DIR}")
  foreach(path ${arg_PACKAGE_PATH})
    list(APPEND command --package-path "${path}")
  endforeach()
  foreach(gate UNCOVERED PROTRUSION)
    if(DEFINED arg_MAX_${gate})
      string(TOLOWER ${gate} option)
      list(APPEND command --max-${option} "${arg_MAX_${gate}}")
    endif()
  endforeach()
  add_test(NAME ${arg_NAME} COMMAND ${command} ${arg_OPTIONS})
endfunction()
