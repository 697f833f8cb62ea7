# The target collision_hulls_demo: what scripts/demo builds, and all that README's first steps use: the programs that decompose and verify,
# the node with its Python client, and the panel. Benchmarks, their peers and the Python module come with all the rest, in `all`.

add_custom_target(${PROJECT_NAME}_demo)
add_dependencies(${PROJECT_NAME}_demo
  decompose fit_scene verify ${PROJECT_NAME}_node ${PROJECT_NAME}_generate_messages_cpp ${PROJECT_NAME}_generate_messages_py)
if(TARGET ${PROJECT_NAME}_panel)
  add_dependencies(${PROJECT_NAME}_demo ${PROJECT_NAME}_panel)
endif()
