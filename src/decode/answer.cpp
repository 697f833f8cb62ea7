// Each question knows how it travels, and each decoder what the bytes mean; here they meet.
#include "decode/answer.h"

#include "collision_hulls/error.h"
#include "decode/decode_mesh.h"
#include "decode/decode_xml.h"
#include "decode/decode_yaml.h"
#include "decode/urdf/decode_robot.h"
#include "mesh/mesh_question.h"
#include "robot/robot_question.h"
#include "sandbox/file_reader.h"
#include "xml/xml_question.h"

namespace collision_hulls {

std::string answerReading(const Question& question) {
  switch (static_cast<Reading>(kindOf(question.head))) {
    case Reading::kMesh: return answerMeshQuestion(question, decodeMesh);
    case Reading::kBufferFiles: return answerBufferQuestion(question);
    case Reading::kRobot: return answerRobotQuestion(question, decodeRobot);
    case Reading::kXml: return answerXmlQuestion(question, decodeXml);
    case Reading::kYaml: return answerYamlQuestion(question, decodeYaml);
  }
  throw Error(ErrorCode::kInternal, "a question of no known kind");
}

}  // namespace collision_hulls
