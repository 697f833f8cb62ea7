# The libraries, none of which knows ROS: collision_hulls_core (meshes), collision_hulls (robots and scenes), and the benchmarks'.

function(add_room_library name type)
  room_sources(sources ${ARGN})
  add_library(${name} ${type} ${sources})
  target_include_directories(${name}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  set_target_properties(${name} PROPERTIES INSTALL_RPATH "$ORIGIN")
  # Half of each compilation would be the parsing of these. Not with a compiler cache, which they would defeat, nor for other tools that
  # read compile_commands.json.
  if(COLLISION_HULLS_PRECOMPILE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    target_precompile_headers(${name} PRIVATE
      <Eigen/Core> <Eigen/Geometry> <algorithm> <cmath> <filesystem> <functional> <map> <optional> <sstream> <string> <vector>)
  endif()
endfunction()

add_room_library(${PROJECT_NAME}_core "" ${CORE_ROOMS})
target_link_libraries(${PROJECT_NAME}_core
  PUBLIC Eigen3::Eigen
  PRIVATE found::assimp found::qhull_r found::tbb Threads::Threads)

add_room_library(${PROJECT_NAME} "" ${ROBOT_ROOMS})
target_compile_definitions(${PROJECT_NAME} PRIVATE COLLISION_HULLS_VERSION="${PROJECT_VERSION}")
target_link_libraries(${PROJECT_NAME}
  PUBLIC ${PROJECT_NAME}_core
  PRIVATE found::fcl found::ccd found::tinyxml2 found::urdfdom_model found::yaml-cpp nlohmann_json::nlohmann_json Threads::Threads)
include(cmake/source_digest.cmake)

add_room_library(${PROJECT_NAME}_bench STATIC bench)
target_link_libraries(${PROJECT_NAME}_bench
  PUBLIC ${PROJECT_NAME}
  PRIVATE found::fcl found::ccd nlohmann_json::nlohmann_json Threads::Threads)
# A benchmark says what it was built from.
set_source_files_properties(src/bench/machine.cpp PROPERTIES COMPILE_DEFINITIONS
  "COLLISION_HULLS_BUILD=\"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}, ${CMAKE_BUILD_TYPE}\";COLLISION_HULLS_LIBRARIES=\"assimp ${assimp_VERSION}, ccd ${ccd_VERSION}, eigen ${Eigen3_VERSION}, fcl ${fcl_VERSION}\"")

set(LIBRARIES ${PROJECT_NAME}_core ${PROJECT_NAME})
