// A tree of boxes over points, so that a plane is compared with few of them.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

class PointTree {
 public:
  explicit PointTree(std::vector<Eigen::Vector3d> points);

  /// Whether a point lies further than `margin` [m] beyond the plane.
  bool anyBeyond(const HalfSpace& plane, double margin) const { return anyBeyond(0, 0, points_.size(), plane, margin); }

 private:
  // A node holds the points [first, last) and splits them into halves; the children of node i are 2 i + 1 and 2 i + 2.
  void build(std::size_t node, std::size_t first, std::size_t last);
  bool anyBeyond(std::size_t node, std::size_t first, std::size_t last, const HalfSpace& plane, double margin) const;

  std::vector<Eigen::Vector3d> points_;
  std::vector<Eigen::AlignedBox3d> boxes_;
};

}  // namespace collision_hulls
