// A body of a scene, prepared for distance queries.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_hulls/scene/scene.h"
#include "reach/convex_gap.h"

namespace collision_hulls {

/// In the scene's frame: one convex body, or a tree of boxes over a mesh's triangles. Immutable, thread safe.
class Obstacle {
 public:
  explicit Obstacle(const SceneBody& body);

  /// The gap to a convex body in the scene's frame; stops as convexGap() does, for a mesh once the bounds differ by less than 2e-3 of the
  /// distance.
  Gap gapTo(const Eigen::Ref<const PointMatrix>& points, double enough) const;

  double size() const { return size_; }  ///< [m] largest absolute coordinate, from which rounding is estimated

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    Eigen::Index first = 0, count = 0;  // leaf: columns of corners_; inner: children at first, first + 1, and count 0
  };
  void build(const std::vector<PointMatrix>& triangles, std::vector<std::size_t>& order, std::size_t node, std::size_t first,
             std::size_t count);
  Gap gapToTriangles(const Node& leaf, const Eigen::Ref<const PointMatrix>& points, double enough) const;

  PointMatrix corners_;  // of the convex body, or of triangles, three each
  std::vector<Node> nodes_;
  double size_ = 0;
};

}  // namespace collision_hulls
