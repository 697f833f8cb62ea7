// report.html of a result.
#pragma once

#include <string>

#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

constexpr const char* kPageFile = "report.html";

/// The page's text. Its report has everything but the time that writing takes.
std::string pageOf(const RobotResult& result);

}  // namespace collision_hulls
