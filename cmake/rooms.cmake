# The rooms, which are folders of src/, of include/collision_hulls/ and of test/. A file may include its own room and rooms above it in
# this list, none below. This is the only place that lists them: the targets, the unit tests and test/scripts/rooms all read it.
# collision_hulls_core: a mesh in, hulls, primitives or spheres with their proof out. Eigen, Qhull, TBB; libseccomp in sandbox.
set(CORE_ROOMS base geometry sandbox mesh measure decompose primitives)

# collision_hulls: robots and scenes. FCL in query. The reader program shares DESCRIPTION_ROOMS.
set(ROBOT_ROOMS query check storage xml robot scene reach fit report verify config web pipeline consumers)
set(DESCRIPTION_ROOMS storage xml robot scene)

# What the library's users never link: the parsers of the reader program (Assimp, tinyxml2, urdfdom, yaml-cpp), benchmarks, DART's physics,
# OMPL's planning, the programs, the Python module, the node, rviz's panel.
set(OUTER_ROOMS decode bench physics planning tools python ros panel)

# room_sources(RESULT ROOM...): the .cpp files of rooms, with those in their folders.
function(room_sources result)
  set(sources)
  foreach(room ${ARGN})
    file(GLOB_RECURSE room_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${room}/*.cpp")
    list(APPEND sources ${room_sources})
  endforeach()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()
