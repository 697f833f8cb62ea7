// Stands in for the library's askAboutText(): what a worker would do is done here, where the fuzzer sees it. The linker prefers a program's
// functions to those of shared libraries.
#include "robot/robot_question.h"
#include "sandbox/file_reader.h"
#include "scene/yaml_question.h"
#include "xml/xml_question.h"

namespace collision_hulls {

std::string askAboutText(const std::string& head, const std::string& text, const std::string& /*subject*/, const RunControl& /*control*/) {
  const Question question{head, text, -1};
  switch (static_cast<Reading>(kindOf(head))) {
    case Reading::kRobot: return answerRobotQuestion(question);
    case Reading::kXml: return answerXmlQuestion(question);
    default: return answerYamlQuestion(question);
  }
}

}  // namespace collision_hulls
