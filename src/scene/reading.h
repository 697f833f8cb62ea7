// Helpers shared by the readers of scenes and configurations.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "collision_hulls/scene/scene.h"

namespace collision_hulls {

/// What readers of text take for blank.
constexpr std::string_view kBlanks = " \t\r\n\f\v";

/// Throws kBadConfigurations. `where`: a file, and a line or document of it.
[[noreturn]] void failConfigurations(const std::string& where, const std::string& reason);

/// The normalized quaternion. Throws kBadScene if its length is not about 1, so that it is no rotation.
Eigen::Quaterniond checkedQuaternion(double x, double y, double z, double w);

/// How readScene() was told to read.
struct SceneReading {
  const PackageFinder& find_package;
  const MeshLimits& limits;
  const RunControl& control;
  std::vector<std::string> package_path = {};  ///< see readRobotDescription()
};

/// Meshes by URI, each file read once.
class MeshLibrary {
 public:
  /// `whose`: what the meshes are of, for messages.
  explicit MeshLibrary(const SceneReading& how, std::string whose = "this scene") : how_(how), whose_(std::move(whose)) {}
  /// Relative URIs are resolved against the folder of `base` (a file). Throws the errors of resolveUri(), readMesh() and scaled(),
  /// and kTooLarge where all meshes together have more triangles than one may have.
  TriangleMesh read(const std::string& uri, const Eigen::Vector3d& scale, const std::string& base);
  /// Counts triangles that were read elsewhere, from `path`. Throws that kTooLarge, too.
  void count(std::size_t triangles, const std::string& path);
  std::vector<std::string> files() const;
  /// Whether all meshes together have more triangles than one may have.
  bool isFull() const { return triangles_ > how_.limits.max_triangles; }

 private:
  const SceneReading& how_;
  const std::string whose_;
  std::map<std::string, TriangleMesh> by_path_;
  std::size_t triangles_ = 0;  // of all that were returned
};

/// readScene(), as it was told to read.
Scene readSceneFile(const std::string& file, const SceneReading& how);

// One reader per format; see readScene(). They may return an empty scene, which the caller judges.
Scene readMoveItScene(const std::string& file, const RunControl& control);
Scene readYamlScene(const std::string& file, const SceneReading& how);
Scene readSdfScene(const std::string& file, const SceneReading& how);
Scene readOctomapScene(const std::string& file, const RunControl& control);

}  // namespace collision_hulls
