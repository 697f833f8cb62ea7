// How fast the winding number may change away from the surface. Its gradient there depends on the rim alone, like the magnetic field of a
// current (Biot-Savart).
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_hulls/control.h"
#include "measure/rim.h"

namespace collision_hulls {

/// A tree over the edges of a rim, for lemma 6 of doc/certified.md. It holds no reference to the mesh.
class RimField {
 public:
  RimField(const std::vector<Eigen::Vector3d>& vertices, const Rim& rim, const RunControl& control);

  /// What a point sees of the rim.
  struct Seen {
    double distance = 0;  ///< [m] none of it is nearer
    double strength = 0;  ///< [1/m] bounds the gradient's norm, (1/4 pi) times the integral of dl / |p - l|^2
    /// A length [m] that no path from the point is shorter than along which the winding number changes by `margin` > 0, if it does not
    /// cross the surface. Infinite without a rim.
    double way(double margin) const;
  };
  Seen from(const Eigen::Vector3d& p) const;

 private:
  /// A leaf is an edge.
  struct Node {
    Eigen::AlignedBox3d box;
    double length = 0;            // [m] of the edges in it
    double squared_diagonal = 0;  // [m^2] of the box
    int children = -1;            // the first of two; -1: a leaf
    Eigen::Vector3d a, b;         // the edge of a leaf
  };
  std::vector<Node> nodes_;  // the first is the root; none without a rim
};

}  // namespace collision_hulls
