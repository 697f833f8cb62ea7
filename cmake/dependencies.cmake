# What the library and its programs link: all of it is in Debian 11 and 12, and in Ubuntu 20.04 with ROS Noetic, which brings FCL 0.6.
#
# Libraries are looked for by header and file. Their own CMake files are no help everywhere: Debian 11's libccd has none, those of Assimp
# 5.0 there name a folder that does not exist, and others name packages that nothing needs.

# find(NAME HEADER [SUFFIX...]): the target found::NAME and NAME_VERSION, if the library is there.
function(find name header)
  find_library(${name}_LIBRARY ${name})
  find_path(${name}_INCLUDE_DIR ${header} PATH_SUFFIXES ${ARGN})
  mark_as_advanced(${name}_LIBRARY ${name}_INCLUDE_DIR)
  if(NOT ${name}_LIBRARY OR NOT ${name}_INCLUDE_DIR)
    return()
  endif()
  add_library(found::${name} UNKNOWN IMPORTED)
  set_target_properties(found::${name} PROPERTIES
    IMPORTED_LOCATION "${${name}_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${${name}_INCLUDE_DIR}")
  get_filename_component(file "${${name}_LIBRARY}" REALPATH)
  set(version "")  # of a file without one, as a library built by hand may be
  if(file MATCHES "\\.so\\.(.+)$")  # libassimp.so.5.2.5
    set(version "${CMAKE_MATCH_1}")
  endif()
  set(${name}_VERSION "${version}" PARENT_SCOPE)
endfunction()

# require_library(NAME HEADER DEBIAN_PACKAGE [SUFFIX...]): the same, or an error that says what to install.
macro(require_library name header debian_package)
  find(${name} ${header} ${ARGN})
  if(NOT TARGET found::${name})
    message(FATAL_ERROR "The library ${name} is missing: install ${debian_package}, or run scripts/install_dependencies.")
  endif()
endmacro()

find_package(Boost REQUIRED COMPONENTS program_options)
find_package(Eigen3 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Threads REQUIRED)
require_library(assimp assimp/Importer.hpp libassimp-dev)
require_library(ccd ccd/ccd.h libccd-dev)
require_library(console_bridge console_bridge/console.h libconsole-bridge-dev)
require_library(fcl fcl/config.h libfcl-dev)
require_library(qhull_r libqhull_r/qhull_ra.h libqhull-dev)
require_library(tbb tbb/global_control.h libtbb-dev)
require_library(tinyxml2 tinyxml2.h libtinyxml2-dev)
require_library(urdfdom_model urdf_parser/urdf_parser.h liburdfdom-dev urdfdom)
require_library(yaml-cpp yaml-cpp/yaml.h libyaml-cpp-dev)

# Not needed to work, but to keep a hostile mesh from files and network.
find(seccomp seccomp.h)
if(NOT TARGET found::seccomp)
  message(WARNING "Without libseccomp the program that reads meshes is not kept from files and network by a filter of system calls: "
    "install libseccomp-dev, or run scripts/install_dependencies.")
endif()

# Ubuntu 20.04's own libfcl-dev is 0.5, which has another interface; Noetic has 0.6 as a package of its own.
if(NOT fcl_VERSION STREQUAL "" AND fcl_VERSION VERSION_LESS 0.6)
  message(FATAL_ERROR "FCL ${fcl_VERSION} (${fcl_LIBRARY}) is too old: install FCL 0.6 or later, with ROS Noetic ros-noetic-fcl.")
endif()
