# Collision models in a physics engine, where DART is installed (libdart-dev, libdart-utils-urdf-dev, libdart-collision-bullet-dev): the
# program physics.

find_package(DART 6.10 QUIET COMPONENTS utils-urdf collision-bullet)
if(DART_FOUND)
  add_room_library(physics_room STATIC physics)
  target_link_libraries(physics_room
    PUBLIC ${PROJECT_NAME}_bench dart dart-utils-urdf dart-collision-bullet found::assimp nlohmann_json::nlohmann_json)
  add_program(physics physics_room)
  list(APPEND PROGRAMS physics)
endif()
