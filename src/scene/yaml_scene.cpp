// Reads the YAML format that readScene() documents. Unknown and duplicate keys are errors, so that a typing error is never ignored.
#include <algorithm>
#include <set>

#include "base/in_context.h"
#include "base/nearest_name.h"
#include "base/string_parts.h"
#include "base/uri_text.h"
#include "collision_hulls/error.h"
#include "geometry/pi.h"
#include "geometry/roll_pitch_yaw.h"
#include "scene/reading.h"
#include "scene/yaml_node.h"
#include "storage/text_file.h"

namespace collision_hulls {
namespace {

const std::set<std::string> kShapes{"box", "sphere", "cylinder", "cone", "plane", "mesh"};

void expectKeys(const YamlValue& map, const std::set<std::string>& known) {
  std::set<std::string> seen;
  for (const std::string& key : map.keys()) {
    if (!known.count(key) && key.rfind("frame", 0) == 0)
      map.fail("'" + shown(key) + "' is not known here: all poses of a scene are in the frame of the robot's root link; remove it");
    if (!known.count(key))
      map.fail("'" + shown(key) + "' is not known here; use one of " + listed(known) + didYouMean(key, {known.begin(), known.end()}));
    if (!seen.insert(key).second) map.fail("'" + key + "' appears twice; remove one");
  }
}

Eigen::Vector3d vector(const YamlValue& value) {
  const std::vector<double> numbers = value.numbers(3);
  return {numbers[0], numbers[1], numbers[2]};
}

Eigen::Isometry3d pose(const YamlValue& value) {
  if (!value.isMap()) value.fail("expected a map, such as {xyz: [0, 0, 0.5], rpy: [0, 0, 0]}");
  expectKeys(value, {"xyz", "rpy", "quaternion"});
  if (value.has("rpy") && value.has("quaternion")) value.fail("a pose takes rpy or quaternion, not both");
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (value.has("xyz")) result.translation() = vector(value["xyz"]);
  if (value.has("rpy")) {
    const Eigen::Vector3d rpy = vector(value["rpy"]);
    if (rpy.cwiseAbs().maxCoeff() > 2 * kPi)
      value["rpy"].fail("an angle of rpy is more than a whole turn; give radians, as in [0, 0, 1.57]");
    result.linear() = fromRollPitchYaw(rpy).toRotationMatrix();
  }
  if (value.has("quaternion")) {
    const std::vector<double> q = value["quaternion"].numbers(4);
    inContext(value["quaternion"].place(), [&] { result.linear() = checkedQuaternion(q[0], q[1], q[2], q[3]).toRotationMatrix(); });
  }
  return result;
}

/// What messages call a body: by its name, or else by its number in the list, from 1.
std::string labelOf(const YamlValue& body, std::size_t number) {
  const bool is_named = body.has("name") && body["name"].isScalar() && !body["name"].text().empty();
  return is_named ? "body '" + shown(body["name"].text()) + "'" : "body " + std::to_string(number);
}

std::string shapeOf(const YamlValue& body) {
  std::vector<std::string> found;
  for (const std::string& key : body.keys()) {
    if (kShapes.count(key)) found.push_back(key);
  }
  if (found.size() != 1) {
    body.fail("a body needs one shape, this one has " + std::to_string(found.size()) +
              "; shapes are box, sphere, cylinder, cone, plane and mesh");
  }
  return found.front();
}

class YamlSceneReader {
 public:
  YamlSceneReader(const std::string& file, const SceneReading& how) : file_(file), control_(how.control), meshes_(how) {}

  Scene read() {
    const YamlValue root = YamlValue::parse(readTextFile(file_, ".yaml file", control_), file_, ErrorCode::kBadScene, 1, control_);
    if (root.isMap()) expectKeys(root, {"name", "bodies"});
    if (!root.has("bodies")) root.fail("a scene needs a list 'bodies:'; an empty scene has 'bodies: []'");
    Scene scene;
    SceneBuilder builder(scene);
    if (root.has("name")) scene.name = root["name"].text();
    std::size_t number = 0;
    for (const YamlValue& value : root["bodies"].items()) {
      control_.check();
      SceneBody body = bodyOf(value.called(labelOf(value, ++number)));
      inContext(value.where(), [&] { builder.add(std::move(body)); });
    }
    scene.files = meshes_.files();
    return scene;
  }

 private:
  SceneBody bodyOf(const YamlValue& value) {
    expectKeys(value, {"name", "pose", "scale", "box", "sphere", "cylinder", "cone", "plane", "mesh"});
    SceneBody body;
    body.name = value["name"].text();
    if (value.has("pose")) body.pose = pose(value["pose"]);
    const std::string shape = shapeOf(value);
    if (value.has("scale") && shape != "mesh") value.fail("only a mesh has a scale; give the " + shape + " its size");
    setShape(shape, value, body);
    return body;
  }

  void setShape(const std::string& shape, const YamlValue& value, SceneBody& body) {
    std::vector<double> sizes;
    if (shape == "sphere") sizes = {value[shape].number()};
    if (sizesOf(shape) > 1) sizes = value[shape].numbers(sizesOf(shape));
    const Eigen::Vector3d scale = value.has("scale") ? vector(value["scale"]) : Eigen::Vector3d::Ones();
    const std::string uri = shape == "mesh" ? value[shape].text() : "";
    inContext(value.place(), [&] {
      if (shape == "mesh")
        body.shape = meshes_.read(uri, scale, file_);
      else
        collision_hulls::setShape(body, shape, sizes);
    });
  }

  const std::string file_;
  const RunControl& control_;
  MeshLibrary meshes_;
};

}  // namespace

Scene readYamlScene(const std::string& file, const SceneReading& how) {
  return YamlSceneReader(file, how).read();
}

}  // namespace collision_hulls
