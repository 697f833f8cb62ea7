// One body as FCL holds it, and queries on two of them: the narrow phase alone, for callers that
// know which pairs matter.
//
// For example:
//
//     const QueryBody one(hull), two(mesh);
//     const bool hit = touch(one, two, pose);
//     const double gap = distanceBelow(0.1, one, two, pose);  // [m], 0.1 if further apart
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// A shape about the middle of its frame, of a kind that FCL has built in; a cylinder's axis is z.
/// Contact queries are exact. FCL 0.7's distances are not: for boxes they are off by up to a half
/// if faces or middles line up, for spheres in contact with a mesh they are above 0. Use a hull for
/// distances.
struct QueryShape {
  enum class Kind { kBox, kSphere, kCylinder } kind = Kind::kBox;
  /// [m] > 0; box: sides; sphere: radius, -, -; cylinder: radius, length, -
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
};

/// Meshes are FCL's BVH of OBBRSS, a surface without an inside, as in MoveIt; hulls are FCL's
/// Convex. All are enlarged 1,024 times for FCL, whose thresholds are absolute. Immutable; copies
/// share the body.
class QueryBody {
 public:
  explicit QueryBody(const ConvexHull& hull);  ///< empty if the hull has no vertices
  /// `origin`: the shape's frame in the body's
  QueryBody(const QueryShape& shape, const Eigen::Isometry3d& origin);
  /// leaves out triangles without area; throws kInternal where FCL refuses the mesh, kCancelled
  explicit QueryBody(const TriangleMesh& mesh, const RunControl& control = {});

  /// true for a mesh without any area and a hull without vertices; such a body touches nothing
  bool empty() const { return !impl_; }
  const Eigen::AlignedBox3d& box() const { return box_; }  ///< [m] in the body's frame
  std::size_t corners() const { return corners_; }  ///< vertices of a hull; 0 for other bodies

  struct Impl;
  const std::shared_ptr<const Impl>& impl() const { return impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
  Eigen::AlignedBox3d box_;
  std::size_t corners_ = 0;
};

// The two queries throw kInternal where FCL throws, with its message. No pair of hulls in
// doc/results/fcl.csv made it do so in these settings.

/// Whether two bodies touch; `pose` is the second one's in the first one's frame.
bool touch(const QueryBody& first, const QueryBody& second, const Eigen::Isometry3d& pose);

/// [m] The distance between two bodies, or `limit` if they are no closer than that.
double distanceBelow(double limit, const QueryBody& first, const QueryBody& second,
                     const Eigen::Isometry3d& pose);

/// [m] The axis-aligned box around a box at a pose.
Eigen::AlignedBox3d placed(const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& pose);

/// Whether two boxes are disjoint; `pose` is the second one's in the first one's frame. If only a
/// pair of edges separates them, by less than a millionth of their size, they count as meeting.
bool apart(const Eigen::AlignedBox3d& first, const Eigen::AlignedBox3d& second,
           const Eigen::Isometry3d& pose);

}  // namespace collision_hulls
