// Where a link can be, joint by joint: convex bodies that enclose all places to which the last joints of its chain take it.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/robot/kinematics.h"
#include "reach/convex_gap.h"

namespace collision_hulls {

/// The range of a joint [rad or m].
struct JointRange {
  double lower = 0, upper = 0;
};
JointRange rangeOf(const ChainJoint& joint, const std::vector<JointVariable>& variables);

/// Points whose hull encloses all places of the hull of `points` as a joint moves over a range, in the frame in which the joint's origin is
/// given.
std::vector<Eigen::Vector3d> swept(const std::vector<Eigen::Vector3d>& points, const ChainJoint& joint, const JointRange& range);

/// For k from 0 to the number of joints: a body that encloses the link for all values of the joints after the k-th, in the frame that the
/// k-th joint moves; for k = 0 in the root link's frame. The last body is the link itself. Bodies are empty for a hull without vertices.
std::vector<PointMatrix> sweeps(const ConvexHull& hull, const Chain& chain, const std::vector<JointVariable>& variables);

}  // namespace collision_hulls
