// What the readers of scenes share.
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "collision_hulls/scene/scene.h"

namespace collision_hulls {

/// The number that a word is, with a point whatever the locale; false where it is none, or not finite.
bool parseNumber(std::string_view word, double& value);

/// Throws the errors of `action` with "label: " before their text.
void inContext(const std::string& label, const std::function<void()>& action);

/// A rotation by roll, pitch and yaw about fixed axes, as in URDF and SDF.
Eigen::Quaterniond fromRollPitchYaw(const Eigen::Vector3d& rpy);

/// Of unit length. Throws kBadScene for one that is not of about unit length, which no rotation is.
Eigen::Quaterniond checkedQuaternion(double x, double y, double z, double w);

/// Meshes by URI, each file read once.
class MeshLibrary {
 public:
  explicit MeshLibrary(const PackageFinder& find_package) : find_package_(find_package) {}
  /// Relative URIs are relative to the folder of `base` (a file). Throws the errors of resolveUri(), readMesh() and scaled().
  TriangleMesh read(const std::string& uri, const Eigen::Vector3d& scale, const std::string& base);

 private:
  const PackageFinder& find_package_;
  std::map<std::string, TriangleMesh> by_path_;
};

// One reader for each kind of file; see readScene(). They leave an empty scene to the caller.
Scene readMoveItScene(const std::string& file);
Scene readYamlScene(const std::string& file, const PackageFinder& find_package);
Scene readSdfScene(const std::string& file, const PackageFinder& find_package);
Scene readOctomapScene(const std::string& file);

}  // namespace collision_hulls
