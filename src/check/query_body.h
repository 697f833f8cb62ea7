// One body as FCL holds it, asked about together with another one: the narrow phase alone, for callers that know which pairs matter.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// Meshes are FCL's BVH of OBBRSS, a surface without inside, as in MoveIt; hulls are FCL's Convex. Enlarged as fcl_queries.cpp says.
/// Immutable; copies share the body; thread safe.
class QueryBody {
 public:
  explicit QueryBody(const ConvexHull& hull);
  explicit QueryBody(const TriangleMesh& mesh);  ///< triangles without area are left out

  bool empty() const { return !impl_; }  ///< a mesh without any area; such a body touches nothing
  const Eigen::AlignedBox3d& box() const { return box_; }
  std::size_t corners() const { return corners_; }  ///< vertices of a hull; 0 for others

  struct Impl;
  const std::shared_ptr<const Impl>& impl() const { return impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
  Eigen::AlignedBox3d box_;
  std::size_t corners_ = 0;
};

/// Whether they touch; `pose` is the second one's in the first one's frame.
bool touch(const QueryBody& first, const QueryBody& second, const Eigen::Isometry3d& pose);

/// [m] The distance between them, or `limit` where they are no closer than that.
double distanceBelow(double limit, const QueryBody& first, const QueryBody& second, const Eigen::Isometry3d& pose);

/// The box along the axes about a box that a pose places.
Eigen::AlignedBox3d placed(const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& pose);

}  // namespace collision_hulls
