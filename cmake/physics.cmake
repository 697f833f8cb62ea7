# Collision models in a physics engine, where DART is installed (libdart-dev, libdart-utils-urdf-dev, libdart-collision-bullet-dev): the
# program physics.

find_package(DART 6.10 QUIET COMPONENTS utils-urdf collision-bullet)
if(DART_FOUND)
  room_sources(PHYSICS_SOURCES physics)
  add_library(physics_room STATIC ${PHYSICS_SOURCES})
  set_up_library(physics_room)
  target_link_libraries(physics_room
    PUBLIC ${PROJECT_NAME}_bench dart dart-utils-urdf dart-collision-bullet found::assimp nlohmann_json::nlohmann_json)
  add_executable(physics src/tools/physics.cpp)
  set_up_program(physics)
  target_link_libraries(physics physics_room)
  list(APPEND PROGRAMS physics)
endif()
