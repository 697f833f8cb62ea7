# What the library and its programs link. Debian 12 has all of it; Ubuntu 20.04 all but CLI11, and FCL 0.6 through ROS.

# find_library, but absence is an error that names the package to install.
macro(require_library variable library debian_package)
  find_library(${variable} ${library})
  if(NOT ${variable})
    message(FATAL_ERROR "The library ${library} is missing: install ${debian_package}, or run scripts/install_dependencies.")
  endif()
endmacro()

find_package(Eigen3 REQUIRED)
find_package(assimp REQUIRED)
find_package(ccd REQUIRED)
# 0.6 or later: 0.5, Ubuntu 20.04's libfcl-dev, has another interface. Noetic has 0.6.1 as ros-noetic-fcl.
find_package(fcl 0.6 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Threads REQUIRED)
require_library(QHULL_LIBRARY qhull_r libqhull-dev)
require_library(TBB_LIBRARY tbb libtbb-dev)
require_library(TINYXML2_LIBRARY tinyxml2 libtinyxml2-dev)
require_library(URDFDOM_LIBRARY urdfdom_model liburdfdom-dev)
require_library(YAML_CPP_LIBRARY yaml-cpp libyaml-cpp-dev)

find_package(CLI11 QUIET)
if(NOT CLI11_FOUND)
  message(FATAL_ERROR "CLI11 is missing: install libcli11-dev. Ubuntu 20.04 has no such package: download a release of "
                      "CLI11 (headers only), `cmake --install` it, and give its prefix in CMAKE_PREFIX_PATH.")
endif()
