// The space that spheres may fill: everything within the tolerance of a solid.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/measure/solid.h"
#include "collision_hulls/primitives/spheres.h"

namespace collision_hulls {

/// T, the points whose distance from S is at most the tolerance, as far as cubes of an octree are proved to lie in it. Immutable, thread
/// safe.
class TolerableSpace {
 public:
  /// `tolerance` [m] > 0; `box` holds the solid, which must outlive this object.
  TolerableSpace(const Solid& solid, const Eigen::AlignedBox3d& box, double tolerance, const RunControl& control);

  /// [m] The radius of a ball about a point that is proved to lie in T; 0 or less: none is.
  double radius(const Eigen::Vector3d& centre) const;

  /// [m] An upper bound on how far a sphere protrudes from S; infinite if it is not proved to lie in T.
  double bound(const Sphere& sphere) const;

  /// [m] An upper bound by the distance of its centre alone: exact beside a wall, and cheap.
  double boundByDistance(const Sphere& sphere) const;

  /// The nearest point of a cube that may lie outside T.
  Eigen::Vector3d nearestOutside(const Eigen::Vector3d& p) const;

  double tolerance() const { return tolerance_; }

 private:
  struct Cell {
    Eigen::Vector3d centre;
    double half = 0;        // side / 2
    double to_surface = 0;  // [m] from the centre
    int triangle = -1;      // the nearest one
    int children = -1;      // first of eight; -1: a leaf
    bool in = false;        // all of it is proved to lie in T
  };
  enum class Place { kIn, kOut, kBoth };
  Place measure(Cell& cell, const Cell& parent) const;
  void divide(double finest, const RunControl& control);
  struct Border {
    double distance = std::numeric_limits<double>::infinity();
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
  };
  /// Ends once a border is known that is no further than `enough` [m].
  void findOutside(int cell, const Eigen::Vector3d& p, double enough, Border& border) const;

  const Solid& solid_;
  double tolerance_;
  std::vector<Cell> cells_;
};

}  // namespace collision_hulls
