// Where a description is at fault that urdfdom refuses, and what to do about it.
#pragma once

#include <string>

namespace tinyxml2 {
class XMLElement;
}

namespace collision_hulls {

struct Refusal {
  int line = 0;        ///< of the joint or link that urdfdom complains about, as tinyxml2 counts; of the root where it names none
  std::string remedy;  ///< an instruction, such as "rename one of them"
};

/// `complaints`: what urdfdom logged when it refused `robot`. A name that two elements share is placed at the second.
Refusal refusalOf(const tinyxml2::XMLElement& robot, const std::string& complaints);

}  // namespace collision_hulls
