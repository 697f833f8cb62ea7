// A summit of the distance whose place and height are known.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {
namespace test_shapes {

/// The faces of an octahedron about the origin, drawn back so far from its edges that they enclose nothing. The origin is a summit, at this
/// distance from all of them, and the distance falls as fast as it can on the way to their middles.
inline TriangleMesh octahedronOfSheets(double distance) {
  std::vector<Eigen::Vector3d> corners;
  for (int k = 0; k < 6; ++k) corners.emplace_back((k % 2 ? 1 : -1) * std::sqrt(3.0) * distance * Eigen::Vector3d::Unit(k / 2));
  const TriangleMesh whole = surface(convexHull(corners));
  TriangleMesh faces;
  for (int t = 0; t < 8; ++t) {
    const Eigen::Vector3d middle = (whole.corner(t, 0) + whole.corner(t, 1) + whole.corner(t, 2)) / 3;
    for (int k = 0; k < 3; ++k) faces.vertices.push_back(middle + 0.9 * (whole.corner(t, k) - middle));
    faces.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return faces;
}

}  // namespace test_shapes
}  // namespace collision_hulls
