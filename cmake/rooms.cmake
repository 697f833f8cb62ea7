# The rooms, which are folders of src/, of include/collision_hulls/ and of test/. A file may include its own room and rooms above it in
# this list, none below. This is the only place that lists them: the targets, the unit tests and test/scripts/rooms all read it.
# collision_hulls_core: a mesh in, hulls, primitives or spheres with their proof out. Eigen, Qhull, TBB; libseccomp in sandbox, Assimp and
# tinyxml2 in mesh.
set(CORE_ROOMS base geometry sandbox mesh measure decompose primitives)

# collision_hulls: robots and scenes. FCL in query, tinyxml2 in xml and robot, urdfdom in robot, yaml-cpp in scene.
set(ROBOT_ROOMS query check storage xml robot scene reach fit report verify config web pipeline consumers)

# What the library's users never link: benchmarks, DART's physics, OMPL's planning, the programs, the Python module, the node, rviz's panel.
set(OUTER_ROOMS bench physics planning tools python ros panel)

# room_sources(RESULT ROOM...): the .cpp files of rooms, with those in their folders.
function(room_sources result)
  set(sources)
  foreach(room ${ARGN})
    file(GLOB_RECURSE room_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${room}/*.cpp")
    list(APPEND sources ${room_sources})
  endforeach()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()
