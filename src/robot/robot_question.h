// Robot descriptions that are parsed in a process of their own: both ends of the question.
#pragma once

#include <functional>
#include <string>

#include "collision_hulls/robot/robot_description.h"
#include "sandbox/serve.h"

namespace collision_hulls {

/// How messages name a description. Lines of a .xacro file are those of its expansion, and the name says so.
std::string descriptionLabel(const std::string& path);

/// Takes a description's text and path: decodeRobot() of the room decode.
using RobotDecoder = std::function<RobotDescription(const std::string&, const std::string&)>;

/// The worker's end.
std::string answerRobotQuestion(const Question& question, const RobotDecoder& decode);

/// The description in an answer, without its text and path. Throws ByteFault for what is none, such as joints that form no tree.
RobotDescription robotIn(const std::string& answer);

}  // namespace collision_hulls
