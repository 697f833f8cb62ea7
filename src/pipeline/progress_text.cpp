// Percent and time are rounded down and up to what such an estimate is worth, so that the text stays calm.
#include "collision_hulls/pipeline/progress_text.h"

#include <cmath>

#include "base/counted.h"
#include "report/check_text.h"

namespace collision_hulls {
namespace {

std::string rounded(double value, double to) {
  return std::to_string(static_cast<long long>(to * std::ceil(value / to)));
}

/// As exact as such an estimate is.
std::string timeLeft(double seconds) {
  if (seconds < 0) return "";
  if (seconds < 1) return ", about 1 s left";
  if (seconds < 10) return ", about " + rounded(seconds, 1) + " s left";
  if (seconds < 60) return ", about " + rounded(seconds, 5) + " s left";
  if (seconds < 120) return ", about " + rounded(seconds, 10) + " s left";
  if (seconds < 2 * 3600) return ", about " + rounded(seconds / 60, 1) + " min left";
  return ", about " + rounded(seconds / 3600, 1) + " h left";
}

std::string activity(const Step& step) {
  if (step.stage == "read") return "reading " + counted(step.total, "mesh", "meshes");
  if (step.stage == "fit") return "fitting to the scene";
  if (step.stage == "certify") return "certifying the fitted hulls";
  if (step.stage == "validate") return "validating";
  if (step.stage == "pairs") return "proving which links never meet";
  return std::to_string(step.done) + " of " + counted(step.total, "mesh", "meshes") + ", " + countedBodies(step.hulls, step.primitives);
}

}  // namespace

std::string stepText(const Step& step) {
  return activity(step) + (step.fraction < 1 ? timeLeft(step.seconds_left) : "");
}

int percent(const Step& step) {
  return static_cast<int>(100 * step.fraction);
}

std::string progressLine(const Step& step) {
  return step.stage == "read" || step.stage == "pairs" ? stepText(step) : std::to_string(percent(step)) + " %, " + stepText(step);
}

}  // namespace collision_hulls
