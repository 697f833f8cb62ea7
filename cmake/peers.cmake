# Programs around other libraries' decompositions, for the benchmark, where Bullet's extras are installed (libbullet-extras-dev).

find_path(BULLET_EXTRAS_INCLUDE_DIR ConvexDecomposition/ConvexBuilder.h PATH_SUFFIXES bullet)
find_library(BULLET_HACD_LIBRARY HACD)
find_library(BULLET_CONVEX_DECOMPOSITION_LIBRARY ConvexDecomposition)
find_library(BULLET_LINEAR_MATH_LIBRARY LinearMath)

function(add_peer name)
  add_executable(${name} src/tools/${name}.cpp)
  target_include_directories(${name} PRIVATE src)
  target_include_directories(${name} SYSTEM PRIVATE ${BULLET_EXTRAS_INCLUDE_DIR})
  target_link_libraries(${name} ${PROJECT_NAME} ${ARGN})
endfunction()

if(BULLET_EXTRAS_INCLUDE_DIR AND BULLET_HACD_LIBRARY AND BULLET_CONVEX_DECOMPOSITION_LIBRARY AND BULLET_LINEAR_MATH_LIBRARY)
  add_peer(peer_bullet_hacd ${BULLET_HACD_LIBRARY})
  add_peer(peer_bullet_vcd ${BULLET_CONVEX_DECOMPOSITION_LIBRARY} ${BULLET_LINEAR_MATH_LIBRARY})
  list(APPEND PROGRAMS peer_bullet_hacd peer_bullet_vcd)
endif()
