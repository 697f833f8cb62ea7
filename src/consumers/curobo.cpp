// What a cuRobo robot configuration says of collisions, to be merged into its `kinematics`: the links with spheres, the spheres in the
// links' frames, and the pairs of links that are not checked against each other (pairs_without_check.cpp); where it is said that they never
// meet, that is proved, while cuRobo's own tools sample. Links that have anything else, such as a box that was kept, have no spheres for
// it: cuRobo would miss it, so that is refused.
#include <algorithm>
#include <map>

#include "collision_hulls/config/link_decisions.h"
#include "collision_hulls/error.h"
#include "config/quoted.h"
#include "consumers/written_model.h"
#include "pipeline/mesh_uses.h"
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

bool isOther(const GeometryElement& element) {
  return element.kind != GeometryElement::Kind::kSphere && element.kind != GeometryElement::Kind::kNone;
}

bool hasOthers(const std::vector<GeometryElement>& elements) {
  return std::any_of(elements.begin(), elements.end(), isOther);
}

/// Whether a link will have other elements than spheres, whatever becomes of its meshes.
bool willHaveOthers(const LinkDescription& link, const LinkOptions* options) {
  const CollisionFate fate = collisionFate(link, options);
  if (fate != CollisionFate::kReplaced) return fate == CollisionFate::kStay && hasOthers(link.collisions);
  const SourceElements source = sourceElements(link, options->source);
  return std::any_of(source.elements.begin(), source.elements.end(), [&](const GeometryElement& element) {
    const bool is_there = source.visual ? isSolidPrimitive(element) : element.kind != GeometryElement::Kind::kMesh;
    return is_there && isOther(element);
  });
}

std::vector<std::string> linksWithOthers(const RobotDescription& robot, const Options& options, const RunControl& control) {
  const LinkDecisions decisions = firstModelDecisions(options, robot, control);
  std::vector<std::string> links;
  for (const LinkDescription& link : robot.links)
    if (willHaveOthers(link, decisions.of(link.name))) links.push_back(link.name);
  return links;
}

[[noreturn]] void refuse(const std::vector<std::string>& links, const std::string& remedy) {
  throw Error(ErrorCode::kBadOption, "--for curobo: " + someHave(links) +
                                         " other collision elements than spheres, which cuRobo would miss; " + remedy +
                                         "describe them by spheres or by meshes that are not kept, or leave --for curobo out");
}

}  // namespace

void checkForCurobo(const RobotDescription& robot, const Options& options, const RunControl& control) {
  const std::vector<std::string> links = linksWithOthers(robot, options, control);
  if (links.empty()) return;
  Options of_visuals = options;
  of_visuals.source = Source::kVisual;
  const bool visuals_do = options.source != Source::kVisual && linksWithOthers(robot, of_visuals, control).empty();
  const std::string outside = options.links.empty() ? "" : options.links_place.empty() ? "leave --links out, " : "leave 'only' out, ";
  refuse(links, visuals_do ? "choose --source visual, " : outside);
}

ConsumerFiles curoboFiles(const WrittenModel& model, const std::vector<DisabledPair>& pairs) {
  std::vector<std::string> others;
  for (const LinkDescription& link : model.robot().links)
    if (hasOthers(link.collisions)) others.push_back(link.name);
  if (!others.empty()) refuse(others, "");
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
  return {{"config/" + robotFileName(model.robot().name) + "_spheres.yml", text}};
}

}  // namespace collision_hulls
