# The libraries, none of which knows ROS: collision_hulls_core (meshes), collision_hulls (robots and scenes), the reader program's, and the
# benchmarks'.

function(set_up_library name)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  set_target_properties(${name} PROPERTIES INSTALL_RPATH "$ORIGIN")
  # A function without a header belongs in an unnamed namespace: two of one name would be one to the linker.
  target_compile_options(${name} PRIVATE -Wmissing-declarations)
  # Half of each compilation would be the parsing of these. Not with a compiler cache, which they would defeat, nor for other tools that
  # read compile_commands.json.
  if(COLLISION_HULLS_PRECOMPILE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    target_precompile_headers(${name} PRIVATE
      <Eigen/Core> <Eigen/Geometry> <algorithm> <cmath> <filesystem> <functional> <map> <optional> <sstream> <string> <vector>)
  endif()
  set_up_unity(${name})
endfunction()

# By folder, so that a file's private names have to differ from those of its folder alone.
function(set_up_unity name)
  if(NOT COLLISION_HULLS_UNITY OR CMAKE_VERSION VERSION_LESS 3.18)
    return()
  endif()
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # GCC takes what is private to a file for a header's.
  target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  get_target_property(sources ${name} SOURCES)
  foreach(source ${sources})
    get_filename_component(folder "${source}" DIRECTORY)
    get_filename_component(folder "${folder}" ABSOLUTE)
    file(RELATIVE_PATH folder "${PROJECT_SOURCE_DIR}/src" "${folder}")
    if(NOT folder MATCHES "^\\.\\.")
      string(MAKE_C_IDENTIFIER "${folder}" folder)
      set_source_files_properties("${source}" PROPERTIES UNITY_GROUP ${folder})
    endif()
  endforeach()
endfunction()

room_sources(CORE_SOURCES ${CORE_ROOMS})
add_library(${PROJECT_NAME}_core ${CORE_SOURCES})
set_up_library(${PROJECT_NAME}_core)
target_include_directories(${PROJECT_NAME}_core PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
target_compile_features(${PROJECT_NAME}_core PUBLIC cxx_std_17)
target_link_libraries(${PROJECT_NAME}_core
  PUBLIC Eigen3::Eigen
  PRIVATE found::qhull_r found::tbb nlohmann_json::nlohmann_json Threads::Threads ${CMAKE_DL_LIBS})
if(COLLISION_HULLS_SANITIZE_THREADS)
  # See parallel.cpp. Headers precompiled, or files joined, with the other options are of no use to it.
  set_source_files_properties(src/base/parallel.cpp PROPERTIES COMPILE_OPTIONS -fno-sanitize=thread
    COMPILE_DEFINITIONS COLLISION_HULLS_SANITIZE_THREADS SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
endif()
if(TARGET found::seccomp)
  target_link_libraries(${PROJECT_NAME}_core PRIVATE found::seccomp)
  set_source_files_properties(src/sandbox/confine.cpp PROPERTIES COMPILE_DEFINITIONS COLLISION_HULLS_SECCOMP)
endif()

# Objects, as the reader program takes them without FCL, whose many symbols take long to load.
room_sources(DESCRIPTION_SOURCES ${DESCRIPTION_ROOMS})
add_library(${PROJECT_NAME}_descriptions OBJECT ${DESCRIPTION_SOURCES})
set_up_library(${PROJECT_NAME}_descriptions)
set_target_properties(${PROJECT_NAME}_descriptions PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_link_libraries(${PROJECT_NAME}_descriptions PUBLIC ${PROJECT_NAME}_core PRIVATE nlohmann_json::nlohmann_json Threads::Threads)

room_sources(ROBOT_SOURCES ${ROBOT_ROOMS})
list(REMOVE_ITEM ROBOT_SOURCES ${DESCRIPTION_SOURCES})
add_library(${PROJECT_NAME} ${ROBOT_SOURCES} $<TARGET_OBJECTS:${PROJECT_NAME}_descriptions>)
set_up_library(${PROJECT_NAME})
target_compile_definitions(${PROJECT_NAME} PRIVATE COLLISION_HULLS_VERSION="${PROJECT_VERSION}")
target_link_libraries(${PROJECT_NAME}
  PUBLIC ${PROJECT_NAME}_core
  PRIVATE found::fcl found::ccd nlohmann_json::nlohmann_json Threads::Threads)
include(cmake/source_digest.cmake)
include(cmake/web_page.cmake)

# What parses foreign bytes with libraries of others. Only the reader program links it, which is all that such bytes can take over.
room_sources(DECODE_SOURCES decode)
add_library(${PROJECT_NAME}_decode STATIC ${DECODE_SOURCES})
set_up_library(${PROJECT_NAME}_decode)
target_link_libraries(${PROJECT_NAME}_decode
  PUBLIC ${PROJECT_NAME}_core
  PRIVATE found::assimp found::console_bridge found::tinyxml2 found::urdfdom_model found::yaml-cpp)

room_sources(BENCH_SOURCES bench)
add_library(${PROJECT_NAME}_bench STATIC ${BENCH_SOURCES})
set_up_library(${PROJECT_NAME}_bench)
target_link_libraries(${PROJECT_NAME}_bench
  PUBLIC ${PROJECT_NAME}
  PRIVATE found::fcl found::ccd nlohmann_json::nlohmann_json Threads::Threads)
# A benchmark says what it was built from.
set_source_files_properties(src/bench/machine.cpp PROPERTIES COMPILE_DEFINITIONS
  "COLLISION_HULLS_BUILD=\"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}, ${CMAKE_BUILD_TYPE}\";COLLISION_HULLS_LIBRARIES=\"assimp ${assimp_VERSION}, ccd ${ccd_VERSION}, eigen ${Eigen3_VERSION}, fcl ${fcl_VERSION}\"")
