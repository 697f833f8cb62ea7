// The smallest ball around points.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_hulls/control.h"

namespace collision_hulls {

struct Ball {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double squared_radius = -1;  // -1: empty
};

/// By Welzl's algorithm (1991) with move to front; of points in a plane or on a line, the centre lies in it, too. Holds all points but for
/// rounding. Throws kCancelled.
Ball smallestBall(std::vector<Eigen::Vector3d> points, const RunControl& control = {});

}  // namespace collision_hulls
