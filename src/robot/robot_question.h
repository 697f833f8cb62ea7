// Robot descriptions that are parsed in a process of their own: both ends of the question.
#pragma once

#include <string>

#include "collision_hulls/robot/robot_description.h"
#include "sandbox/serve.h"

namespace collision_hulls {

/// How messages name a description. Lines of a .xacro file are those of its expansion, and the name says so.
std::string descriptionLabel(const std::string& path);

/// What parseRobotDescription() does, in this process.
RobotDescription decodeRobotDescription(const std::string& urdf_text, const std::string& path);

/// The worker's end.
std::string answerRobotQuestion(const Question& question);

/// The description in an answer, without its text and path. Throws ByteFault for what is none, such as joints that form no tree.
RobotDescription robotIn(const std::string& answer);

}  // namespace collision_hulls
