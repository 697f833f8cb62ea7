# What the library and its programs link. Debian 11 and 12 have all of it; Ubuntu 20.04 has FCL 0.6 through ROS.

# find_library, but absence is an error that names the package to install.
macro(require_library variable library debian_package)
  find_library(${variable} ${library})
  if(NOT ${variable})
    message(FATAL_ERROR "The library ${library} is missing: install ${debian_package}, or run scripts/install_dependencies.")
  endif()
endmacro()

find_package(Boost REQUIRED COMPONENTS program_options)
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
