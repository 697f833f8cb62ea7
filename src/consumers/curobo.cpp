// What a cuRobo robot configuration says of collisions, to be merged into its `kinematics`: the links with spheres, the spheres in the
// links' frames, and the pairs of links that are not checked against each other, which are proved never to meet where cuRobo's own tools
// sample. Links that have anything else, such as a box that was kept, have no spheres for it: cuRobo would miss it, so that is refused.
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

void refuseOthers(const LinkDescription& link) {
  for (const GeometryElement& element : link.collisions)
    if (element.kind != GeometryElement::Kind::kSphere && element.kind != GeometryElement::Kind::kNone)
      throw Error(ErrorCode::kBadOption,
                  "--for curobo: link '" + link.name +
                      "' has other collision elements than spheres, which cuRobo would miss; choose --source visual, "
                      "remove the link, or leave --for curobo out");
}

}  // namespace

ConsumerFiles curoboFiles(const WrittenModel& model, const RunControl& control) {
  std::vector<std::string> links;
  std::string spheres;
  for (const LinkDescription& link : model.robot().links) {
    refuseOthers(link);
    std::string of_link;
    for (const GeometryElement& element : link.collisions)
      if (element.kind == GeometryElement::Kind::kSphere) of_link += sphereText(element);
    if (of_link.empty()) continue;
    links.push_back(link.name);
    spheres += "  " + quoted(link.name) + ":\n" + of_link;
  }
  std::map<std::string, std::vector<std::string>> ignored;
  for (const DisabledPair& pair : pairsWithoutCheck(model, control)) ignored[pair.link1].push_back(pair.link2);
  std::string pairs;
  for (const auto& [link, others] : ignored) pairs += "  " + quoted(link) + ": " + listOf(others) + "\n";
  const std::string text =
      "# For the kinematics section of a cuRobo robot configuration. Metres, in the links' frames.\ncollision_link_names: " +
      listOf(links) + "\ncollision_spheres:" + (spheres.empty() ? " {}\n" : "\n" + spheres) +
      "self_collision_ignore:" + (pairs.empty() ? " {}\n" : "\n" + pairs);
  return {{"config/" + fileName(model.robot().name) + "_spheres.yml", text}};
}

}  // namespace collision_hulls
