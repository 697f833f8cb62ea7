// One body as FCL holds it, asked about together with another one: the narrow phase alone, for callers that know which pairs matter.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// A shape about the middle of its frame that FCL knows as such; a cylinder's axis is z. Whether it touches is exact. FCL 0.7's distances
/// are not: those of boxes are off by up to a half where faces or middles line up, those of spheres in contact with a mesh above 0. Ask a
/// hull.
struct QueryShape {
  enum class Kind { kBox, kSphere, kCylinder } kind = Kind::kBox;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< [m] > 0; box: sides; sphere: radius, -, -; cylinder: radius, length, -
};

/// Meshes are FCL's BVH of OBBRSS, a surface without inside, as in MoveIt; hulls are FCL's Convex. FCL has them enlarged 1,024 times, since
/// its thresholds are absolute. Immutable; copies share the body; thread safe.
class QueryBody {
 public:
  explicit QueryBody(const ConvexHull& hull);
  QueryBody(const QueryShape& shape, const Eigen::Isometry3d& origin);  ///< `origin`: of the shape's frame in the body's
  explicit QueryBody(const TriangleMesh& mesh);                         ///< triangles without area are left out

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

/// Whether boxes do not meet; `pose` is the second one's in the first one's frame. Boxes that only edges part by less than a millionth of
/// their size count as meeting.
bool apart(const Eigen::AlignedBox3d& first, const Eigen::AlignedBox3d& second, const Eigen::Isometry3d& pose);

}  // namespace collision_hulls
