// A frame in which an element is at the origin and about one unit in size.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_hulls/check/validate.h"

namespace collision_hulls {

/// FCL's tolerances are absolute; in this frame they are shares of the element's size. The scale is a power of two, so only the shift is
/// rounded.
class UnitFrame {
 public:
  /// The pair must have finite coordinates, and triangles or hulls.
  explicit UnitFrame(const ValidationPair& pair);

  double rounding() const { return rounding_; }  ///< of our own distances, in units, unless there are slivers
  double units(double metres) const { return metres * scale_; }
  double metres(double units) const { return units / scale_; }
  Eigen::Vector3d metres(const Eigen::Vector3d& p) const { return p / scale_ + centre_; }
  Eigen::Vector3d units(const Eigen::Vector3d& p) const { return (p - centre_) * scale_; }
  TriangleMesh units(TriangleMesh mesh) const;
  ConvexHull units(ConvexHull hull) const;
  std::vector<ConvexHull> units(std::vector<ConvexHull> hulls) const;
  std::vector<Sphere> units(std::vector<Sphere> spheres) const;

 private:
  Eigen::Vector3d centre_;
  double scale_ = 1, rounding_ = 0;
};

}  // namespace collision_hulls
