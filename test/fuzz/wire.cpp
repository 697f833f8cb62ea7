// What the library and its reader program tell each other. The first byte chooses: an answer, as a worker that was taken over may write it,
// to a question about a mesh, the files of its buffers, a robot, XML or YAML; or the head of a question about a mesh.
#include "collision_hulls/error.h"
#include "decode/decode_mesh.h"
#include "fuzz/target.h"
#include "geometry/bytes.h"
#include "mesh/mesh_question.h"
#include "robot/robot_question.h"
#include "sandbox/reader_program.h"
#include "scene/yaml_question.h"
#include "xml/xml_question.h"

namespace collision_hulls::fuzz {
namespace {

void takeWire(const std::string& input) {
  std::string bytes = input;
  const unsigned char choice = firstOf(bytes) % 6;
  try {
    if (choice == 0) meshIn(answerIn(bytes, "input.obj"), "input.obj", {});
    if (choice == 1) answerMeshQuestion({bytes, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", -1}, decodeMesh);
    if (choice == 2) robotIn(bytes);
    if (choice == 3) xmlIn(bytes);
    if (choice == 4) yamlIn(bytes);
    if (choice == 5) bufferFilesIn(bytes, "input.gltf");
  } catch (const ByteFault&) {  // the caller makes an error of it
  } catch (const Error&) {      // any that a worker may name
  }
}

const Registered kWire("wire", takeWire);

}  // namespace
}  // namespace collision_hulls::fuzz
