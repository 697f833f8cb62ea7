// How far a body moves while the joints before it stay within a box of values.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "collision_hulls/robot/kinematics.h"
#include "scene/convex_gap.h"

namespace collision_hulls {

/// A joint within a box.
struct BoxedJoint {
  const ChainJoint* joint = nullptr;
  std::size_t variable = 0;  ///< that moves it, by any numbering
  double middle = 0;         ///< [rad or m] the joint's value in the box's middle
  double way = 0;            ///< [rad or m] how far it is from there at most
};

/// A body at the middle of a box.
///
/// To get from there to any other place in the box joint by joint, the last one first, moves a point about each joint's axis from where it
/// was in the middle; joints before it move that way rigidly. So movements add up, and each is
///   - no longer than the chord of the joint's angle at the point's distance from the axis;
///   - along a direction n: what the joint itself does along n, at most sin(angle) |tangent . n| + (1 - cos(angle)) (inward . n), and
///     as the joints before it may turn n by an angle w, 2 sin(w / 2) of the chord more.
class BoxedBody {
 public:
  /// `points` in the frame that the last joint moves; joints those nearest to the root first.
  BoxedBody(const PointMatrix& points, std::vector<BoxedJoint> joints);

  const PointMatrix& points() const { return points_; }  ///< at the middle, in the frame that the first joint's origin is in

  /// [m] The furthest that a point is from there. Adds to each variable's share of it.
  double movement(std::vector<double>& of_variables) const;

  /// [m] The furthest along a direction (of unit length, in the frame of points()); never more than movement().
  double movementAlong(const Eigen::Vector3d& direction, std::vector<double>& of_variables) const;

 private:
  struct Step {
    BoxedJoint at;
    PointMatrix points;         // in the joint's frame
    Eigen::RowVectorXd chords;  // of the points
  };
  template <class MovesOf>
  double sum(std::vector<double>& of_variables, const MovesOf& moves_of) const;

  std::vector<Step> steps_;  // as the joints
  PointMatrix points_;
};

}  // namespace collision_hulls
