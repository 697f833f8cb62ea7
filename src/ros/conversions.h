// The core's types as messages. What is drawn of them: markers.h.
#pragma once

#include <collision_hulls/DecomposeFeedback.h>
#include <collision_hulls/LinkReport.h>
#include <collision_hulls/RunTotals.h>

#include <string>
#include <vector>

#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

/// A row of the report; `origin`: of the element in its link's frame, in which messages give places.
LinkReport toMessage(const ElementReport& row, const Eigen::Isometry3d& origin);
std::vector<LinkReport> toMessages(const RobotResult& result);
RunTotals toTotals(const Report& report);
DecomposeFeedback toMessage(const Step& step);

/// A line for each mesh that failed, then what was made: "robot 'arm': 7 hulls and 2 primitives for 3 meshes, 1 failed; largest protrusion
/// 4.91 mm (hand)".
std::string summary(const std::string& robot, const Report& report);

/// What the library says, with options as parameters of the node: "--close-openings 5cm" becomes "~close_openings 5cm", "--no-validate"
/// "~validate false", and a name at the start, as in "max-hulls '-1'", "max_hulls". Options that the program alone has stay, and so do
/// quotations and indented lines, which are commands.
std::string inNodeWords(const std::string& text);

/// Throws kBadOption for a request's `base` that is neither empty nor an absolute path, such as a URI. ~base may be one: it opens what it
/// names (places.h), and a request may not.
void checkBase(const std::string& base);

}  // namespace collision_hulls
