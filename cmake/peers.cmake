# Programs around other libraries' decompositions, for the benchmark, where Bullet's extras are installed (libbullet-extras-dev).

find_path(BULLET_EXTRAS_INCLUDE_DIR ConvexDecomposition/ConvexBuilder.h PATH_SUFFIXES bullet)
find_library(BULLET_HACD_LIBRARY HACD)
find_library(BULLET_CONVEX_DECOMPOSITION_LIBRARY ConvexDecomposition)
find_library(BULLET_LINEAR_MATH_LIBRARY LinearMath)

if(BULLET_EXTRAS_INCLUDE_DIR AND BULLET_HACD_LIBRARY AND BULLET_CONVEX_DECOMPOSITION_LIBRARY AND BULLET_LINEAR_MATH_LIBRARY)
  add_executable(peer_bullet_hacd src/tools/peer_bullet_hacd.cpp)
  target_link_libraries(peer_bullet_hacd ${PROJECT_NAME} ${BULLET_HACD_LIBRARY})
  add_executable(peer_bullet_vcd src/tools/peer_bullet_vcd.cpp)
  target_link_libraries(peer_bullet_vcd ${PROJECT_NAME} ${BULLET_CONVEX_DECOMPOSITION_LIBRARY} ${BULLET_LINEAR_MATH_LIBRARY})
  foreach(peer peer_bullet_hacd peer_bullet_vcd)
    set_up_program(${peer})
    target_include_directories(${peer} SYSTEM PRIVATE ${BULLET_EXTRAS_INCLUDE_DIR})
    list(APPEND PROGRAMS ${peer})
  endforeach()
endif()
