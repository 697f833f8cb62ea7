# Collision models under a planner, where OMPL is installed (libompl-dev): the program plan_benchmark.

find_package(ompl 1.5 QUIET)
if(ompl_FOUND)
  room_sources(PLANNING_SOURCES planning)
  add_library(planning_room STATIC ${PLANNING_SOURCES})
  set_up_library(planning_room)
  # OMPL's headers do not pass our warnings; its list of libraries names some that packages do not install.
  target_include_directories(planning_room SYSTEM PRIVATE ${OMPL_INCLUDE_DIR})
  find_library(OMPL_LIBRARY ompl)
  target_link_libraries(planning_room PUBLIC ${PROJECT_NAME}_bench nlohmann_json::nlohmann_json PRIVATE ${OMPL_LIBRARY})
  add_executable(plan_benchmark src/tools/plan_benchmark.cpp)
  set_up_program(plan_benchmark)
  target_link_libraries(plan_benchmark planning_room)
  list(APPEND PROGRAMS plan_benchmark)
endif()
