// collision_hulls_reader: reads meshes, descriptions and scenes for the library, which starts it, in a process that can do nothing else.
#include "collision_hulls/error.h"
#include "mesh/mesh_question.h"
#include "robot/robot_question.h"
#include "sandbox/file_reader.h"
#include "scene/yaml_question.h"
#include "xml/xml_question.h"

namespace {

using namespace collision_hulls;

std::string answer(const Question& question) {
  switch (static_cast<Reading>(kindOf(question.head))) {
    case Reading::kMesh: return answerMeshQuestion(question);
    case Reading::kBufferFiles: return answerBufferQuestion(question);
    case Reading::kRobot: return answerRobotQuestion(question);
    case Reading::kXml: return answerXmlQuestion(question);
    case Reading::kYaml: return answerYamlQuestion(question);
  }
  throw Error(ErrorCode::kInternal, "a question of no known kind");
}

}  // namespace

int main() {
  return collision_hulls::serve(answer);
}
