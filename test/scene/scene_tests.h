// Helpers shared by the tests of scenes.
#pragma once

#include <string>

#include "collision_hulls/robot/kinematics.h"
#include "collision_hulls/scene/scene.h"
#include "robot/robot_tests.h"

namespace collision_hulls {

inline PackageFinder noPackages() {
  return [](const std::string&) { return std::nullopt; };
}

inline Scene sceneOf(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  return readScene(folder.write(name, text), noPackages());
}

/// A body's bounding box in the scene's frame.
inline Eigen::AlignedBox3d boxOf(const SceneBody& body) {
  const TriangleMesh mesh =
      std::holds_alternative<ConvexHull>(body.shape) ? surface(std::get<ConvexHull>(body.shape)) : std::get<TriangleMesh>(body.shape);
  return boundingBox(transformed(mesh, body.pose));
}

inline void expectBox(const SceneBody& body, const Eigen::Vector3d& low, const Eigen::Vector3d& high, double within = 1e-9) {
  const Eigen::AlignedBox3d box = boxOf(body);
  EXPECT_LT((box.min() - low).norm(), within) << body.name << " from " << box.min().transpose();
  EXPECT_LT((box.max() - high).norm(), within) << body.name << " to " << box.max().transpose();
}

/// A triangle with legs of one metre in the plane z = 0.
constexpr char kTriangleObj[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

}  // namespace collision_hulls
