// Each refusal names the setting, where it stands, and what to do instead.
#include "pipeline/scene/fit_refusals.h"

#include <algorithm>
#include <string>

#include "base/millimetres.h"
#include "collision_hulls/error.h"
#include "pipeline/scene/fit_notes.h"

namespace collision_hulls {
namespace {

/// Refuses padding and shapes; names the link unless all links have the same.
void refuseLinkSettings(const RobotDescription& robot, const Options& options, const LinkDecisions& decisions) {
  for (const LinkDescription& link : robot.links) {
    const LinkOptions* const decided = decisions.of(link.name);
    if (!decided || decided->action != Action::kDecompose) continue;
    const auto ofLink = [&](bool is_for_all) { return is_for_all ? std::string() : " of link '" + link.name + "'"; };
    if (decided->padding > 0)
      throw Error(ErrorCode::kBadOption,
                  "padding '" + toString(lengthOf(decided->padding)) + "'" + ofLink(decided->padding == options.padding) +
                      " does not apply to fit_scene: a fitted model holds the meshes, and the clearance adds nothing around them; omit "
                      "it, and pad in the planner, or use decompose");
    if (decided->shapes != Shapes::kHulls)
      throw Error(ErrorCode::kBadOption, std::string("shapes '") + name(decided->shapes) + "'" + ofLink(decided->shapes == options.shapes) +
                                             " does not apply to fit_scene, which takes primitives where the scene allows; omit it");
  }
}

}  // namespace

void refuseOtherWays(const RobotDescription& robot, const Options& options, const LinkDecisions& decisions) {
  if (!options.models.empty())
    throw Error(ErrorCode::kBadOption,
                "model '" + options.models.front().name + "': a scene decides on the detail, so fitting makes one model; omit it");
  if (options.tree)
    throw Error(ErrorCode::kBadOption, "tree '" + toString(*options.tree) +
                                           "' does not apply to fit_scene, whose trees always have leaves for the tolerance; omit it");
  if (options.time_limit > 0)
    throw Error(ErrorCode::kBadOption, "time-limit does not apply to fit_scene, which needs whole hull trees; omit it");
  if (!options.region_rules.empty()) {
    const RegionRule& first = options.region_rules.front();
    throw Error(ErrorCode::kBadOption,
                (first.place.empty() ? "" : first.place + ": ") + "region '" + first.name +
                    "' does not apply to fit_scene, where the scene alone decides how far hulls protrude; omit it, or use decompose");
  }
  refuseLinkSettings(robot, options, decisions);
  const std::string& link = decisions.firstOfOtherMethod();
  if (link.empty()) return;
  const std::string& place = decisions.otherMethodPlace();
  throw Error(ErrorCode::kBadOption, (place.empty() ? "" : place + ": ") + "method '" + name(decisions.of(link)->method) + "'" +
                                         (place.empty() ? "" : " of link '" + link + "'") +
                                         " builds no hull tree, which fitting to a scene needs; use certified" +
                                         (place.empty() ? "" : ", or keep the link"));
}

void checkClearance(double clearance, const RobotDescription& robot) {
  constexpr double kAlwaysAllowed = 1;  // [m] for robots without joints, too
  const double reach = reachOf(robot);
  if (clearance <= std::max(kAlwaysAllowed, reach)) return;
  throw Error(ErrorCode::kBadOption, "clearance '" + toString(lengthOf(clearance)) + "' is more than robot '" + robot.name + "' reaches (" +
                                         millimetres(reach) + "): did you mean " + toString(lengthOf(clearance / 1000)) +
                                         "? Without a unit, a number is in metres");
}

}  // namespace collision_hulls
