// Links that stand alike with all joints at zero may still move apart: their joints are compared pair by pair.
#include "verify/joint_differences.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/decimal.h"

namespace collision_hulls {
namespace {

constexpr double kSameNumber = 1e-6;  // of it, or of 1 if that is more: text may have fewer digits

bool equalNumbers(double a, double b) {
  return std::abs(a - b) <= kSameNumber * std::max({1.0, std::abs(a), std::abs(b)});
}

std::string kindOf(const JointDescription& joint) {
  using Kind = JointDescription::Kind;
  switch (joint.kind) {
    case Kind::kFixed: return "is fixed";
    case Kind::kRevolute: return "is revolute";
    case Kind::kContinuous: return "is continuous";
    case Kind::kPrismatic: return "is prismatic";
    case Kind::kFloating: return "floats";
    case Kind::kPlanar: return "is planar";
  }
  return "";
}

std::string axisOf(const JointDescription& joint) {
  return "has the axis '" + decimal(joint.axis.x()) + " " + decimal(joint.axis.y()) + " " + decimal(joint.axis.z()) + "'";
}

std::string mimicOf(const JointDescription& joint) {
  if (joint.mimic.empty()) return "follows no joint";
  return "follows '" + joint.mimic + "' (times " + decimal(joint.mimic_multiplier) + ", plus " + decimal(joint.mimic_offset) + ")";
}

std::string rangeOf(const JointDescription& joint) {
  return "goes from " + decimal(joint.lower) + " to " + decimal(joint.upper);
}

bool equalMimics(const JointDescription& a, const JointDescription& b) {
  return a.mimic == b.mimic && equalNumbers(a.mimic_multiplier, b.mimic_multiplier) && equalNumbers(a.mimic_offset, b.mimic_offset);
}

bool equalRanges(const JointDescription& a, const JointDescription& b) {
  return equalNumbers(a.lower, b.lower) && equalNumbers(a.upper, b.upper);
}

/// The first that differs; empty: nothing does.
std::string differenceOf(const JointDescription& original, const JointDescription& result) {
  const auto said = [&](std::string (*what)(const JointDescription&)) {
    return "'" + result.name + "', which " + what(result) + " there and " + what(original) + " in ORIGINAL";
  };
  using Kind = JointDescription::Kind;
  if (original.kind != result.kind) return said(kindOf);
  if (original.kind == Kind::kFixed || original.kind == Kind::kFloating) return "";
  if ((original.axis - result.axis).cwiseAbs().maxCoeff() > kSameNumber) return said(axisOf);
  if (original.kind == Kind::kPlanar) return "";
  if (!equalMimics(original, result)) return said(mimicOf);
  return original.mimic.empty() && !equalRanges(original, result) ? said(rangeOf) : "";
}

}  // namespace

std::vector<std::string> jointDifferences(const RobotDescription& original, const RobotDescription& result) {
  std::map<std::string, const JointDescription*> of_result;  // by the link that it moves
  for (const JointDescription& joint : result.joints) of_result[joint.child] = &joint;
  std::vector<std::string> differences;
  for (const JointDescription& joint : original.joints) {
    const auto other = of_result.find(joint.child);
    if (other == of_result.end()) continue;
    if (const std::string text = differenceOf(joint, *other->second); !text.empty()) differences.push_back(text);
  }
  return differences;
}

}  // namespace collision_hulls
