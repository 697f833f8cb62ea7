// Chooses a reader by file extension and validates every body in one place, so that readers need not. URDF and single meshes are read here;
// the other formats have files of their own.
#include "collision_hulls/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "base/in_context.h"
#include "base/roots.h"
#include "base/string_parts.h"
#include "base/uri_text.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "scene/reading.h"

namespace collision_hulls {
namespace {

constexpr double kFurthest = 1e6;           // [m] from the origin
constexpr std::size_t kLongestName = 1000;  // [bytes] of a scene and its bodies: messages and reports repeat them
constexpr std::size_t kMostBodies = 100'000;

[[noreturn]] void failBody(const std::string& body, const std::string& reason) {
  throw Error(ErrorCode::kBadScene, "body '" + body + "' " + reason);
}

void checkName(const std::string& name, const std::string& whose) {
  const std::string subject = "the name of " + whose + ", '" + shown(name) + "', ";
  if (name.size() > kLongestName)
    throw Error(ErrorCode::kBadScene, subject + "is longer than " + std::to_string(kLongestName) + " bytes; shorten it");
  if (std::any_of(name.begin(), name.end(), isControl)) throw Error(ErrorCode::kBadScene, subject + "holds a control character; remove it");
}

void checkPlace(const std::string& name, const Eigen::Isometry3d& pose) {
  if (!pose.matrix().allFinite()) failBody(name, "has a pose that is not finite; correct its numbers");
  if (pose.translation().cwiseAbs().maxCoeff() > kFurthest) failBody(name, "is more than 1e6 m from the origin; lengths are in metres");
}

void checkMesh(const std::string& name, const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) failBody(name, "is a mesh without triangles; remove it, or give it triangles");
  const auto count = static_cast<int>(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    for (const int v : t) {
      if (v < 0 || v >= count)
        failBody(name, "has a triangle with vertex " + std::to_string(v) + " of " + std::to_string(count) + "; indices start at 0");
    }
  }
  for (const Eigen::Vector3d& v : mesh.vertices) {
    if (!(v.cwiseAbs().maxCoeff() <= kFurthest))
      failBody(name, "has a vertex that is not finite, or more than 1e6 m from the origin; lengths are in metres");
  }
}

/// The largest shapes are a little larger than kFurthest, as they lie about round ones.
void checkHull(const std::string& name, const ConvexHull& hull) {
  if (hull.vertices.empty()) failBody(name, "is a hull without vertices; remove it, or give it a shape");
  for (const Eigen::Vector3d& v : hull.vertices) {
    if (!(v.cwiseAbs().maxCoeff() <= 2 * kFurthest))
      failBody(name, "has a vertex that is not finite, or more than 2e6 m from its middle; lengths are in metres");
  }
}

void setPrimitive(SceneBody& body, const GeometryElement& element) {
  const Eigen::Vector3d& size = element.size;
  switch (element.kind) {
    case GeometryElement::Kind::kBox: return setShape(body, "box", {size.x(), size.y(), size.z()});
    case GeometryElement::Kind::kSphere: return setShape(body, "sphere", {size.x()});
    default: return setShape(body, "cylinder", {size.x(), size.y()});
  }
}

/// Each element of each link, at its rest pose.
Scene readUrdfScene(const std::string& file, const SceneReading& how) {
  if (isConfined() && lowerExtension(file) == ".xacro")
    throw Error(ErrorCode::kOutsideRoots, "'" + file + "' is a xacro file, which is code, and includes files from any folder; run 'xacro " +
                                              "FILE.xacro > FILE.urdf', and give the .urdf");
  const RobotDescription robot = readRobotDescription(file, how.control, how.package_path);
  MeshLibrary meshes(how);
  Scene scene;
  SceneBuilder builder(scene);
  scene.name = robot.name;
  for (const LinkDescription& link : robot.links) {
    const std::vector<GeometryElement> elements = sourceElements(link, Source::kAuto).elements;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      how.control.check();
      const GeometryElement& element = elements[i];
      if (element.kind == GeometryElement::Kind::kNone) continue;
      const std::string name = elements.size() == 1 ? link.name : link.name + "/" + std::to_string(i + 1);
      inContext("'" + file + "', link '" + link.name + "'", [&] {
        SceneBody body{name, {}, link.pose * element.origin};
        if (!element.fault.empty()) throw Error(ErrorCode::kBadScene, element.fault);
        if (element.kind == GeometryElement::Kind::kMesh) {
          body.shape = meshes.read(element.uri, element.scale, file);
        } else {
          setPrimitive(body, element);
        }
        builder.add(std::move(body));
      });
    }
  }
  scene.files = meshes.files();
  return scene;
}

Scene readMeshScene(const std::string& file, const SceneReading& how) {
  Scene scene;
  scene.name = std::filesystem::path(file).stem().string();
  addBody(scene, {scene.name.empty() ? "mesh" : scene.name, readMesh(file, how.limits, how.control).mesh});
  return scene;
}

std::optional<Scene> readByExtension(const std::string& file, const SceneReading& how) {
  const std::string extension = lowerExtension(file);
  if (extension == ".scene") return readMoveItScene(file, how.control);
  if (extension == ".urdf" || extension == ".xacro") return readUrdfScene(file, how);
  if (extension == ".sdf" || extension == ".world") return readSdfScene(file, how);
  if (extension == ".bt" || extension == ".ot") return readOctomapScene(file, how.control);
  if (extension == ".yaml" || extension == ".yml") return readYamlScene(file, how);
  if (isMeshFile(file)) return readMeshScene(file, how);
  return std::nullopt;
}

}  // namespace

SceneBuilder::SceneBuilder(Scene& scene) : scene_(scene) {
  for (const SceneBody& body : scene.bodies) names_.insert(body.name);
}

void SceneBuilder::add(SceneBody body) {
  if (body.name.empty()) throw Error(ErrorCode::kBadScene, "a body has no name; give it one");
  checkName(body.name, "a body");
  checkPlace(body.name, body.pose);
  if (const auto* mesh = std::get_if<TriangleMesh>(&body.shape)) checkMesh(body.name, *mesh);
  if (const auto* hull = std::get_if<ConvexHull>(&body.shape)) checkHull(body.name, *hull);
  if (!names_.insert(body.name).second) failBody(body.name, "appears twice in the scene; rename one of them");
  if (scene_.bodies.size() == kMostBodies)
    throw Error(ErrorCode::kTooLarge, "the scene has more than " + std::to_string(kMostBodies) +
                                          " bodies; leave out those that the robot cannot reach, or join them into meshes");
  scene_.bodies.push_back(std::move(body));
}

void addBody(Scene& scene, SceneBody body) {
  SceneBuilder(scene).add(std::move(body));
}

Scene readSceneFile(const std::string& file, const SceneReading& how) {
  std::optional<Scene> scene = readByExtension(file, how);
  std::error_code none;
  if (!scene && std::filesystem::is_directory(file, none))
    throw Error(ErrorCode::kUnsupportedFormat, "'" + file + "' is a folder; give a scene file in it");
  if (!scene) {
    throw Error(ErrorCode::kUnsupportedFormat,
                "'" + file + "': unknown scene format; supported are .scene (MoveIt), .urdf, .xacro, .sdf, .world, .yaml, .bt and .ot " +
                    "(OctoMap), and mesh files (" + listed(meshExtensions(), " ") + ")");
  }
  if (scene->name.empty()) scene->name = std::filesystem::path(file).stem().string();
  inContext("'" + file + "'", [&] { checkName(scene->name, "the scene"); });
  const std::string extension = lowerExtension(file);
  if (scene->bodies.empty() && extension != ".yaml" && extension != ".yml") {
    throw Error(ErrorCode::kBadScene,
                "'" + file + "' is a scene without geometry; if it should be empty, give a .yaml file with " + "the line 'bodies: []'");
  }
  return std::move(*scene);
}

Scene readScene(const std::string& file, const PackageFinder& find_package, const MeshLimits& limits, const RunControl& control,
                const std::vector<std::string>& package_path) {
  return readSceneFile(file, {find_package, limits, control, package_path});
}

}  // namespace collision_hulls
