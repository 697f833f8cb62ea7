// Models come straight from the flows that programs run, without files between. Hulls are taken from the results; primitives, the
// original's and new ones alike, from the rewritten description, which says which of them are left.
#include "planning/robot_model.h"

#include <algorithm>
#include <map>

#include "base/string_parts.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

constexpr const char* kFitted = "fitted";

std::size_t indexOf(const RobotDescription& robot, const std::string& link) {
  const auto found = std::find_if(robot.links.begin(), robot.links.end(), [&](const LinkDescription& l) { return l.name == link; });
  return static_cast<std::size_t>(found - robot.links.begin());
}

void addPrimitives(const std::vector<GeometryElement>& elements, std::size_t link, RobotModel& model) {
  for (const GeometryElement& element : elements)
    if (element.kind != Kind::kMesh && element.kind != Kind::kNone) model.bodies.push_back({link, element});
}

void expectComplete(const RobotResult& result) {
  for (const ElementReport& row : result.report.links) {
    if (row.status == Status::kFailed)
      throw Error(ErrorCode::kBadGeometry, "link '" + row.link + "', mesh '" + row.uri + "': " + row.reason +
                                               "; planning is compared on complete robots only, so mend the mesh");
  }
}

RobotModel originalOf(const RobotDescription& robot, const RobotResult& result) {
  RobotModel model{kOriginalModel, {}};
  for (const ElementResult& element : result.elements)
    model.bodies.push_back({indexOf(robot, element.link), element.original, element.source.origin});
  for (std::size_t i = 0; i < robot.links.size(); ++i) addPrimitives(sourceElements(robot.links[i], Source::kAuto).elements, i, model);
  return model;
}

/// The pairs that the fit leaves out, and those of its SRDF.
IgnoredPairs ignoredPairs(const RobotDescription& robot, const Scene& scene, const RobotResult& fit) {
  IgnoredPairs ignored(robot.links.size() + scene.bodies.size());
  std::map<std::string, std::size_t> bodies;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) bodies[scene.bodies[i].name] = robot.links.size() + i;
  for (const LeftOutPair& pair : fit.report.scene->left_out)
    ignored.ignore(indexOf(robot, pair.first), pair.links ? indexOf(robot, pair.second) : bodies.at(pair.second));
  for (const auto& [path, text] : fit.extra_files) {
    for (const DisabledPair& pair : parseDisabledPairs(text, robot, path).pairs)
      ignored.ignore(indexOf(robot, pair.link1), indexOf(robot, pair.link2));
  }
  return ignored;
}

}  // namespace

std::vector<std::string> allModels() {
  return {kOriginalModel, "single_hull", "default", kFitted, "spheres"};
}

void checkModels(const std::vector<std::string>& names) {
  const std::vector<std::string> known = allModels();
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw Error(ErrorCode::kBadOption, "model '" + name + "' is unknown: use some of " + listed(known));
  }
}

ModelMaker::ModelMaker(const Input& robot, const std::vector<std::string>& names, const ModelRequest& options)
    : robot_(robot), names_(names), options_(options) {
  checkModels(names);
}

RobotResult ModelMaker::decomposed(const std::string& name) const {
  Options options = options_.options;
  if (name == "single_hull") options.method = Method::kSingleHull;
  if (name == "spheres") options.shapes = Shapes::kSpheres;
  RobotResult result = decomposeRobot(robot_.robot, robot_.find_package, options, defaultOutput(robot_));
  expectComplete(result);
  return result;
}

RobotModel ModelMaker::modelOf(const std::string& name, const RobotResult& result) const {
  RobotModel model{name, {}};
  for (const ElementResult& element : result.elements) {
    const std::size_t link = indexOf(robot_.robot, element.link), hulls = element.hulls.size() - element.primitives.size();
    for (std::size_t i = 0; i < hulls; ++i) model.bodies.push_back({link, element.hulls[i], element.source.origin});
  }
  const RobotDescription rewritten = parseRobotDescription(result.urdf);
  for (std::size_t i = 0; i < rewritten.links.size(); ++i) addPrimitives(rewritten.links[i].collisions, i, model);
  return model;
}

SceneModels ModelMaker::make(const Scene& scene) {
  SceneRequest request;
  request.scene = scene;
  request.clearance = options_.clearance;
  request.samples = options_.samples;
  const RobotResult fit = fitRobotToScene(robot_.robot, robot_.find_package, request, options_.options, defaultOutput(robot_));
  expectComplete(fit);
  SceneModels result{{}, ignoredPairs(robot_.robot, scene, fit)};
  if (made_.empty()) {
    for (const std::string& name : names_) {
      if (name == kFitted) continue;
      made_.push_back(name == kOriginalModel ? originalOf(robot_.robot, fit) : modelOf(name, decomposed(name)));
    }
  }
  auto next = made_.begin();
  for (const std::string& name : names_) result.models.push_back(name == kFitted ? modelOf(name, fit) : *next++);
  return result;
}

}  // namespace collision_hulls
