// Solids and hulls for the tests of the check and decompose rooms.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/measure/solid.h"
#include "collision_hulls/mesh/repair.h"
#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace test_shapes {

inline Solid solidOf(const TriangleMesh& mesh) {
  return Solid(repair(mesh));
}

/// Whether a summit of the distance within a ball is ruled out.
inline bool withoutSummit(const Solid& solid, const Eigen::Vector3d& p, double radius) {
  return !solid.mayHoldSummit(p, solid.distanceToSurface(p), radius);
}

/// Without rotation.
inline std::vector<Eigen::Isometry3d> posesAt(const std::vector<Eigen::Vector3d>& places) {
  std::vector<Eigen::Isometry3d> poses;
  for (const Eigen::Vector3d& place : places) poses.push_back(Eigen::Isometry3d(Eigen::Translation3d(place)));
  return poses;
}

inline ConvexHull boxHull(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  const Eigen::Vector3d sides = high - low;
  return convexHull(moved(box(sides.x(), sides.y(), sides.z()), low).vertices);
}

inline ConvexHull hullOf(const TriangleMesh& mesh) {
  return convexHull(mesh.vertices);
}

/// Squares about the z axis with half sides `rings[i].x()` at heights `rings[i].y()`, joined by walls and closed at both ends.
inline TriangleMesh squareVessel(const std::vector<Eigen::Vector2d>& rings) {
  const auto corner = [&](std::size_t ring, std::size_t k) {
    const double half = rings[ring].x(), x = k == 1 || k == 2 ? half : -half, y = k >= 2 ? half : -half;
    return Eigen::Vector3d(x, y, rings[ring].y());
  };
  const std::size_t last = rings.size() - 1;
  MeshBuilder builder;
  builder.quad(corner(0, 0), corner(0, 3), corner(0, 2), corner(0, 1));
  for (std::size_t i = 0; i < last; ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t l = (k + 1) % 4;
      builder.quad(corner(i, k), corner(i, l), corner(i + 1, l), corner(i + 1, k));
    }
  builder.quad(corner(last, 0), corner(last, 1), corner(last, 2), corner(last, 3));
  return builder.mesh();
}

/// A block of 3 x 3 x 3 about the z axis, standing on z = 0, with a hollow of 2 x 2 x 2 and a neck, 2 * neck wide, to the top. The middle
/// of the hollow, at distance 1, is further from the block than anything on the surface of its hull.
inline TriangleMesh flask(double neck = 0.2, int n = 1) {
  return subdivided(squareVessel({{1.5, 0}, {1.5, 3}, {neck, 3}, {neck, 2.5}, {1, 2.5}, {1, 0.5}}), n);
}

/// A flask beside 20 plates of its height and width, 1.8 apart: in the long hull of all, the middle of the flask's hollow, at distance 1,
/// is one place among thousands that are nearly as far.
inline TriangleMesh flaskBesidePlates() {
  std::vector<TriangleMesh> parts{flask()};
  for (int i = 0; i < 20; ++i) parts.push_back(moved(box(0.2, 3, 3), {3.3 + 2 * i, -1.5, 0}));
  return merged(parts);
}

/// A box [0, 1]^3 with a window [0.5 - half, 0.5 + half]^2 in its top: an open surface.
inline TriangleMesh boxWithWindow(double half = 0.2) {
  TriangleMesh shell = squareVessel({{0.5, 0}, {0.5, 1}, {half, 1}});
  shell.triangles.resize(shell.triangles.size() - 2);
  return moved(shell, {0.5, 0.5, 0});
}

struct OpenMesh {
  TriangleMesh mesh;
  double ball;  // surely inside there is a ball larger than this
};

/// Boxes with a window, and a ball full of holes.
inline std::vector<OpenMesh> openMeshes() {
  std::vector<OpenMesh> meshes;
  for (const double half : {0.05, 0.1, 0.2}) meshes.push_back({boxWithWindow(half), 0.15});
  TriangleMesh ball = sphere(0.5, 8);
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < ball.triangles.size(); ++t)
    if (t % 20 != 0) kept.push_back(ball.triangles[t]);
  ball.triangles = kept;
  meshes.push_back({ball, 0.03});
  return meshes;
}

inline Eigen::Vector3d inHull(const ConvexHull& hull, RandomPoints& random) {
  const Eigen::AlignedBox3d box = boundingBox(hull);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d p = random.inBox(box);
    if (planeDistance(hull, p) <= 0) return p;
  }
  return random.on(surface(hull));
}

}  // namespace test_shapes
}  // namespace collision_hulls
