// How far a body moves while the joints that move it stay within a box of values.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "collision_hulls/robot/kinematics.h"
#include "reach/convex_gap.h"

namespace collision_hulls {

/// A joint within a box.
struct BoxedJoint {
  const ChainJoint* joint = nullptr;
  std::size_t variable = 0;  ///< that moves it, in any numbering
  double middle = 0;         ///< [rad or m] the joint's value at the box's middle
  double way = 0;            ///< [rad or m] largest deviation from there
};

/// A body at the middle of a box.
///
/// Move from the middle to any other configuration in the box one joint at a time, the first joint first. Each joint then carries a point
/// about its axis starting from where the point is at the middle, and the joints before it carry that displacement along rigidly. So the
/// displacements add up, and each is
///   - no longer than the chord of the joint's angle at the point's distance from the axis;
///   - along a direction n, no more than what the joint itself does along n, sin(angle) |tangent . n| + (1 - cos(angle)) (inward . n),
///     plus 2 sin(w / 2) of the chord, since the joints before it may turn n by an angle w.
class BoxedBody {
 public:
  /// `points` in the frame that the last joint moves; joints in order from the root.
  BoxedBody(const PointMatrix& points, std::vector<BoxedJoint> joints);

  const PointMatrix& points() const { return points_; }  ///< at the middle, in the frame in which the first joint's origin is given

  /// [m] Largest distance of any point from there. Adds each variable's share of it to `of_variables`.
  double movement(std::vector<double>& of_variables) const;

  /// [m] Largest movement along a direction (of unit length, in the frame of points()); never more than movement().
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
