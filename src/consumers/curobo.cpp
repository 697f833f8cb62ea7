// What a cuRobo robot configuration says of collisions, to be merged into its `kinematics`: the links with spheres, the spheres in the
// links' frames, and the pairs of links that are not checked against each other (pairs_without_check.cpp); where it is said that they never
// meet, that is proved, while cuRobo's own tools sample. Links that have anything else, such as a box that was kept, have no spheres for
// it: cuRobo would miss it, so that is refused.
#include <algorithm>
#include <map>

#include "collision_hulls/error.h"
#include "config/quoted.h"
#include "consumers/written_model.h"
#include "robot/number_text.h"
#include "storage/names.h"

namespace collision_hulls {
namespace {

std::string listOf(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + quoted(name);
  return "[" + text + "]";
}

std::string sphereText(const GeometryElement& sphere) {
  const Eigen::Vector3d centre = sphere.origin.translation();
  return "    - {center: [" + numberText(centre.x()) + ", " + numberText(centre.y()) + ", " + numberText(centre.z()) +
         "], radius: " + numberText(sphere.size.x()) + "}\n";
}

bool hasOthers(const LinkDescription& link) {
  return std::any_of(link.collisions.begin(), link.collisions.end(), [](const GeometryElement& element) {
    return element.kind != GeometryElement::Kind::kSphere && element.kind != GeometryElement::Kind::kNone;
  });
}

void refuseOthers(const WrittenModel& model) {
  std::vector<std::string> links;
  for (const LinkDescription& link : model.robot().links)
    if (hasOthers(link)) links.push_back(link.name);
  if (links.empty()) return;
  const std::string choose = model.result().report.options.source == Source::kVisual ? "" : "choose --source visual, ";
  throw Error(ErrorCode::kBadOption, "--for curobo: " + someHave(links) +
                                         " other collision elements than spheres, which cuRobo would miss; " + choose +
                                         "remove them by --config, or leave --for curobo out");
}

}  // namespace

ConsumerFiles curoboFiles(const WrittenModel& model, const std::vector<DisabledPair>& pairs) {
  refuseOthers(model);
  std::vector<std::string> links;
  std::string spheres;
  for (const LinkDescription& link : model.robot().links) {
    std::string of_link;
    for (const GeometryElement& element : link.collisions)
      if (element.kind == GeometryElement::Kind::kSphere) of_link += sphereText(element);
    if (of_link.empty()) continue;
    links.push_back(link.name);
    spheres += "  " + quoted(link.name) + ":\n" + of_link;
  }
  std::map<std::string, std::vector<std::string>> ignored;
  for (const DisabledPair& pair : pairs) ignored[pair.link1].push_back(pair.link2);
  std::string ignore;
  for (const auto& [link, others] : ignored) ignore += "  " + quoted(link) + ": " + listOf(others) + "\n";
  const std::string text =
      "# For the kinematics section of a cuRobo robot configuration. Metres, in the links' frames.\ncollision_link_names: " +
      listOf(links) + "\ncollision_spheres:" + (spheres.empty() ? " {}\n" : "\n" + spheres) +
      "self_collision_ignore:" + (ignore.empty() ? " {}\n" : "\n" + ignore);
  return {{"config/" + fileName(model.robot().name) + "_spheres.yml", text}};
}

}  // namespace collision_hulls
