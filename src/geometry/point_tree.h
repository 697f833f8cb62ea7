// A tree of boxes over points, so that a plane, or another point, is compared with few of them.
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

class PointTree {
 public:
  explicit PointTree(std::vector<Eigen::Vector3d> points);

  /// Whether a point lies further than `margin` [m] beyond the plane.
  bool anyBeyond(const HalfSpace& plane, double margin) const { return anyBeyond(0, 0, points_.size(), plane, margin); }

  /// The nearest point, nearer than `limit` [m], of those that are accepted, by its place in the order in which points were given. Asks
  /// about `most` points at most, near ones first; nullopt: none of them.
  std::optional<std::size_t> nearest(const Eigen::Vector3d& p, double limit, std::size_t most,
                                     const std::function<bool(std::size_t)>& accepts) const;

 private:
  // A node holds the points [first, last) and splits them into halves; the children of node i are 2 i + 1 and 2 i + 2.
  void build(std::size_t node, std::size_t first, std::size_t last);
  bool anyBeyond(std::size_t node, std::size_t first, std::size_t last, const HalfSpace& plane, double margin) const;
  struct Search;
  void nearest(std::size_t node, std::size_t first, std::size_t last, Search& search) const;

  std::vector<std::size_t> order_;  // of the points as given
  std::vector<Eigen::Vector3d> points_;
  std::vector<Eigen::AlignedBox3d> boxes_;
};

}  // namespace collision_hulls
