# A digest of the library's sources, of the compiler with its flags, and of the libraries that hulls depend on, so that the cache finds
# nothing of another library. As a script (-P) it writes OUTPUT for the sources in ROOT and the text BUILD; the build runs it whenever a
# source changes.
if(CMAKE_SCRIPT_MODE_FILE)
  string(REPLACE "," ";" rooms "${ROOMS}")
  file(GLOB sources RELATIVE "${ROOT}" "${ROOT}/include/collision_hulls/*.h")
  foreach(room ${rooms})
    file(GLOB_RECURSE room_sources RELATIVE "${ROOT}" "${ROOT}/include/collision_hulls/${room}/*.h" "${ROOT}/src/${room}/*.h" "${ROOT}/src/${room}/*.cpp")
    list(APPEND sources ${room_sources})
  endforeach()
  set(text "${BUILD}")
  foreach(source ${sources})
    file(SHA256 "${ROOT}/${source}" digest)
    string(APPEND text "\n${source} ${digest}")
  endforeach()
  string(SHA256 digest "${text}")
  file(WRITE "${OUTPUT}" "#include \"pipeline/source_digest.h\"

const char* ${NAMESPACE}::sourceDigest() {
  return \"${digest}\";
}
")
  return()
endif()

# Hulls, their rows of the report, the bodies of primitives and the validation are remembered, so the whole library counts, and its reader.
set(digested_rooms ${CORE_ROOMS} ${ROBOT_ROOMS} decode)
room_sources(digested_sources ${digested_rooms})
list(JOIN digested_rooms "," digested_rooms)

set(output "${CMAKE_CURRENT_BINARY_DIR}/source_digest.cpp")
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
set(build "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} ${CMAKE_SYSTEM_PROCESSOR} ${CMAKE_BUILD_TYPE}")
string(APPEND build " ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}")
string(APPEND build " assimp ${assimp_VERSION} ccd ${ccd_VERSION} eigen ${Eigen3_VERSION} fcl ${fcl_VERSION}")
string(APPEND build " tinyxml2 ${tinyxml2_VERSION} urdfdom ${urdfdom_model_VERSION}")
file(SHA256 "${qhull_r_LIBRARY}" qhull)
string(APPEND build " qhull ${qhull}")
file(GLOB_RECURSE headers CONFIGURE_DEPENDS include/*.h src/*.h)
add_custom_command(
  OUTPUT "${output}"
  COMMAND "${CMAKE_COMMAND}" "-DROOT=${PROJECT_SOURCE_DIR}" "-DOUTPUT=${output}" "-DNAMESPACE=${PROJECT_NAME}" "-DBUILD=${build}" "-DROOMS=${digested_rooms}"
          -P "${CMAKE_CURRENT_LIST_FILE}"
  DEPENDS "${CMAKE_CURRENT_LIST_FILE}" ${digested_sources} ${headers}
  VERBATIM)
target_sources(${PROJECT_NAME} PRIVATE "${output}")
