// collision_hulls_reader: reads meshes for the library, which starts it, in a process that can do nothing else.
#include "mesh/mesh_question.h"
#include "sandbox/serve.h"

int main() {
  return collision_hulls::serve(collision_hulls::answerMeshQuestion);
}
