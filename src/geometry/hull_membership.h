// Whether points lie in the convex hull of others, without building that hull.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace collision_hulls {

/// Takes some passes over the points for each question, which is far less than their hull takes. Not thread safe.
class HullMembership {
 public:
  /// At least one point.
  explicit HullMembership(const std::vector<Eigen::Vector3d>& points);

  /// True: p lies in the convex hull of the points, up to rounding. False: it does not, or so near to the surface that rounding might
  /// decide; always where the points are coplanar.
  bool holds(const Eigen::Vector3d& p);

 private:
  /// The point that is furthest in a direction, less p.
  Eigen::Vector3d furthest(const Eigen::Vector3d& direction, const Eigen::Vector3d& p);

  Eigen::Matrix<double, Eigen::Dynamic, 3> points_;  // less middle_
  Eigen::VectorXd heights_;
  Eigen::Vector3d middle_, low_, high_;
  double size_ = 0;  // [m]
};

}  // namespace collision_hulls
