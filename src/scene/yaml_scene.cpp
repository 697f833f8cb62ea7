// Reads the YAML format that readScene() documents. Unknown and duplicate keys are errors, so that a typing error is never ignored.
#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

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

const std::set<std::string> kShapes{"box", "sphere", "cylinder", "cone", "plane", "mesh", "scene"};
constexpr std::size_t kDeepestScene = 20, kMostScenes = 1000;

void expectKeys(const YamlValue& map, const std::set<std::string>& known) {
  std::set<std::string> seen;
  for (const std::string& key : map.keys()) {
    if (!known.count(key) && key.rfind("frame", 0) == 0)
      map.fail("'" + shown(key) + "' is not known here: all poses of a scene are in the frame of the robot's root link; remove it. To " +
               "move a whole scene, name its file in another one: {name: cell, scene: cell.yaml, pose: {xyz: [1, 0, 0]}}");
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
              "; shapes are box, sphere, cylinder, cone, plane, mesh, and scene for all bodies of another file");
  }
  return found.front();
}

bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code none;
  return std::filesystem::equivalent(a, b, none);
}

/// A file, and where its bodies go.
struct PlacedFile {
  std::string path;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::string prefix = {};               // of the bodies' names
  std::vector<std::string> within = {};  // the files that it is a part of
};

class YamlSceneReader {
 public:
  explicit YamlSceneReader(const SceneReading& how) : how_(how), meshes_(how) {}

  Scene read(const std::string& path) {
    scene_.name = addAll({path});
    const std::vector<std::string> meshes = meshes_.files();
    scene_.files.insert(scene_.files.end(), meshes.begin(), meshes.end());
    return std::move(scene_);
  }

 private:
  /// Returns the name that the file gives its scene, or "".
  std::string addAll(const PlacedFile& file) {
    const std::string text = readTextFile(file.path, ".yaml file", how_.control);
    const YamlValue root = YamlValue::parse(text, file.path, ErrorCode::kBadScene, 1, how_.control);
    if (root.isMap()) expectKeys(root, {"name", "bodies"});
    if (!root.has("bodies")) root.fail("a scene needs a list 'bodies:'; an empty scene has 'bodies: []'");
    std::size_t number = 0;
    for (const YamlValue& value : root["bodies"].items()) {
      how_.control.check();
      add(value.called(labelOf(value, ++number)), file);
    }
    return root.has("name") ? root["name"].text() : "";
  }

  void add(const YamlValue& value, const PlacedFile& file) {
    expectKeys(value, {"name", "pose", "scale", "box", "sphere", "cylinder", "cone", "plane", "mesh", "scene"});
    const std::string name = value["name"].text();
    if (name.empty()) value.fail("a body has no name; give it one");
    SceneBody body;
    body.name = file.prefix + name;
    body.pose = file.pose;
    if (value.has("pose")) body.pose = file.pose * pose(value["pose"]);
    const std::string shape = shapeOf(value);
    if (value.has("scale") && shape == "scene") value.fail("a scene has no scale; remove it, and scale the meshes in that file");
    if (value.has("scale") && shape != "mesh") value.fail("only a mesh has a scale; give the " + shape + " its size");
    if (shape == "scene") {
      addScene(value, file, body);
      return;
    }
    setShape(shape, value, file.path, body);
    inContext(value.where(), [&] { builder_.add(std::move(body)); });
  }

  /// All bodies of another file, as "name/their name". `whole` has that name and their pose.
  void addScene(const YamlValue& value, const PlacedFile& file, const SceneBody& whole) {
    if (file.within.size() == kDeepestScene) value.fail("scenes nest deeper than 20; join some");
    if (++scenes_ > kMostScenes) value.fail("more than 1,000 scenes within scenes; join some");
    inContext(value.place(), [&] {
      PlacedFile inner{resolveUri(value["scene"].text(), file.path, how_.find_package), whole.pose, whole.name + "/", file.within};
      inner.within.push_back(file.path);
      if (std::any_of(inner.within.begin(), inner.within.end(), [&](const std::string& outer) { return isSameFile(outer, inner.path); }))
        throw Error(ErrorCode::kBadScene, "'" + inner.path + "' contains itself that way; remove this");
      const std::string extension = lowerExtension(inner.path);
      scene_.files.push_back(inner.path);
      if (extension == ".yaml" || extension == ".yml")
        addAll(inner);
      else
        addOther(inner);
    });
  }

  void addOther(const PlacedFile& file) {
    Scene scene = readSceneFile(file.path, how_);
    scene_.files.insert(scene_.files.end(), scene.files.begin(), scene.files.end());
    for (SceneBody& body : scene.bodies) {
      body.name = file.prefix + body.name;
      body.pose = file.pose * body.pose;
      if (const auto* mesh = std::get_if<TriangleMesh>(&body.shape)) meshes_.count(mesh->triangles.size(), file.path);
      builder_.add(std::move(body));
    }
  }

  void setShape(const std::string& shape, const YamlValue& value, const std::string& file, SceneBody& body) {
    std::vector<double> sizes;
    if (shape == "sphere") sizes = {value[shape].number()};
    if (sizesOf(shape) > 1) sizes = value[shape].numbers(sizesOf(shape));
    const Eigen::Vector3d scale = value.has("scale") ? vector(value["scale"]) : Eigen::Vector3d::Ones();
    const std::string uri = shape == "mesh" ? value[shape].text() : "";
    inContext(value.place(), [&] {
      if (shape == "mesh")
        body.shape = meshes_.read(uri, scale, file);
      else
        collision_hulls::setShape(body, shape, sizes);
    });
  }

  const SceneReading& how_;
  MeshLibrary meshes_;
  Scene scene_;
  SceneBuilder builder_{scene_};
  std::size_t scenes_ = 0;  // within scenes
};

}  // namespace

Scene readYamlScene(const std::string& file, const SceneReading& how) {
  return YamlSceneReader(how).read(file);
}

}  // namespace collision_hulls
