// Support points of a hull, by walking along its edges.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Answers in a few steps where the walk begins near by. Keeps a reference to the hull. Thread safe.
class HullSupport {
 public:
  explicit HullSupport(const ConvexHull& hull);

  /// The vertex furthest along a direction: uphill from vertex `start`, which on a convex surface ends at the summit. Vertices
  /// level with it up to the hull's slack may be missed.
  int furthest(const Eigen::Vector3d& direction, int start) const;

 private:
  const ConvexHull& hull_;
  std::vector<std::size_t> first_;  // by vertex: its first neighbour
  std::vector<int> neighbours_;     // joined to it by a triangle's edge
};

/// The width [m] of a hull across that of its faces where it is least: a ball within is no wider.
double leastWidth(const ConvexHull& hull);

}  // namespace collision_hulls
