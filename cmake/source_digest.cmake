# A digest of the library's sources, of the compiler with its flags, and of the libraries that hulls depend on, so that the cache finds
# nothing of another library. As a script (-P) it writes OUTPUT for the sources in ROOT and the text BUILD; the build runs it whenever a
# source changes.
if(CMAKE_SCRIPT_MODE_FILE)
  file(GLOB_RECURSE sources RELATIVE "${ROOT}" "${ROOT}/include/*.h" "${ROOT}/src/*.h" "${ROOT}/src/*.cpp")
  # Rooms that come after the hulls, and change none.
  list(FILTER sources EXCLUDE REGEX "^(src|include/[a-z_]+)/(bench|physics|ros|scene|tools)/")
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

set(output "${CMAKE_CURRENT_BINARY_DIR}/source_digest.cpp")
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
set(build "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} ${CMAKE_SYSTEM_PROCESSOR} ${CMAKE_BUILD_TYPE}")
string(APPEND build " ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}")
string(APPEND build " assimp ${assimp_VERSION} eigen ${Eigen3_VERSION} fcl ${fcl_VERSION}")
file(SHA256 "${qhull_r_LIBRARY}" qhull)
string(APPEND build " qhull ${qhull}")
file(GLOB_RECURSE headers CONFIGURE_DEPENDS include/*.h src/*.h)
add_custom_command(
  OUTPUT "${output}"
  COMMAND "${CMAKE_COMMAND}" "-DROOT=${PROJECT_SOURCE_DIR}" "-DOUTPUT=${output}" "-DNAMESPACE=${PROJECT_NAME}" "-DBUILD=${build}"
          -P "${CMAKE_CURRENT_LIST_FILE}"
  DEPENDS "${CMAKE_CURRENT_LIST_FILE}" ${CORE_SOURCES} ${headers}
  VERBATIM)
target_sources(${PROJECT_NAME} PRIVATE "${output}")
