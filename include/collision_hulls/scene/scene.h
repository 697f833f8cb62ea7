// What stands around a robot: static bodies, read from the formats in which scenes are kept.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <variant>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// A static body. Boxes, spheres, cylinders and cones are convex hulls; round ones of a polyhedron that circumscribes them, no more than
/// kRoundness of their radius further out. Meshes are surfaces without an inside, as planners take them.
struct SceneBody {
  static constexpr double kRoundness = 1e-3;

  std::string name;  ///< unique in its scene
  std::variant<ConvexHull, TriangleMesh> shape;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< of the shape's frame in the scene's
};

/// The scene's frame is that of the robot's root link. Lengths in metres.
struct Scene {
  std::string name;
  std::vector<SceneBody> bodies;
};

}  // namespace collision_hulls
