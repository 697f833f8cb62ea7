// FCL's distance queries in settings found to be safe, with exceptions and NaN turned into values.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// The largest error of a distance, as a share of the bodies' size, that counts as FCL's rounding rather than a fault.
constexpr double kFclTolerance = 1e-6;

/// One answer of FCL.
struct FclAnswer {
  enum class Status { kDistance, kException, kNan };
  Status status = Status::kDistance;
  double distance = 0;                                  ///< 0: in contact or overlapping
  Eigen::Vector3d on_first = Eigen::Vector3d::Zero();   ///< nearest points, only between separated hulls
  Eigen::Vector3d on_second = Eigen::Vector3d::Zero();  ///< in the frame of the first body
  double microseconds = 0;                              ///< duration of FCL's call
  std::string error;                                    ///< the text of an exception
};

/// A mesh as in FCL and MoveIt: a tree of triangles, a surface without an inside. Triangles must have an area: for a line or a point FCL's
/// answers are wrong, as it fits no box to it. Immutable, thread safe.
class FclMesh {
 public:
  /// Throws kCancelled.
  explicit FclMesh(const TriangleMesh& mesh, const RunControl& control = {});
  ~FclMesh();
  FclMesh(FclMesh&&) noexcept;
  bool empty() const;  ///< no triangles; distance queries on such a mesh are not allowed

  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

/// A hull as FCL's Convex. FCL trusts it to be convex; if its triangles are not closed, FCL searches all vertices instead of walking along
/// edges. Immutable, thread safe.
class FclHull {
 public:
  explicit FclHull(const ConvexHull& hull);
  ~FclHull();
  FclHull(FclHull&&) noexcept;

  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

// The distance from the first body to a point, or to a second body at `pose` in the first one's frame. For a sphere, query its centre.
// FCL's tolerances are absolute: bodies should be about one unit in size.
FclAnswer fclDistance(const FclMesh& mesh, const Eigen::Vector3d& point);
FclAnswer fclDistance(const FclHull& hull, const Eigen::Vector3d& point);
FclAnswer fclDistance(const FclMesh& mesh, const FclMesh& other, const Eigen::Isometry3d& pose);
FclAnswer fclDistance(const FclHull& hull, const FclHull& other, const Eigen::Isometry3d& pose);

}  // namespace collision_hulls
