// Where a link can be, joint by joint: convex bodies that hold all places to which the last joints of its chain take it.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/robot/kinematics.h"
#include "scene/convex_gap.h"

namespace collision_hulls {

/// Between which a joint moves [rad or m].
struct JointRange {
  double lower = 0, upper = 0;
};
JointRange rangeOf(const ChainJoint& joint, const std::vector<JointVariable>& variables);

/// Points whose hull holds all places of the hull of `points` when a joint moves over a range; in the frame that the joint's origin is in.
std::vector<Eigen::Vector3d> swept(const std::vector<Eigen::Vector3d>& points, const ChainJoint& joint, const JointRange& range);

/// For k from 0 to the number of joints: what holds the link for all values of the joints after the k-th, in the frame that the k-th moves;
/// for 0 in the root link's. The last is the link itself. Empty for a hull without vertices.
std::vector<PointMatrix> sweeps(const ConvexHull& hull, const Chain& chain, const std::vector<JointVariable>& variables);

}  // namespace collision_hulls
