// collision_hulls_reader: reads meshes, descriptions and scenes for the library, which starts it, in a process that can do nothing else.
#include "decode/answer.h"

int main() {
  return collision_hulls::serve(collision_hulls::answerReading);
}
