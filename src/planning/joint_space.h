// The joints that a planner moves, and motions between their values.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "collision_hulls/robot/kinematics.h"

namespace collision_hulls {

/// A value [rad or m] for each joint of a JointSpace, in its order.
using JointValues = std::vector<double>;

/// The planned joints of a robot; its other variables stay where they are, and mimic joints follow their masters. Keeps a reference to the
/// kinematics. Immutable, thread safe.
class JointSpace {
 public:
  /// `pattern`: a regular expression that a joint's whole name must match; empty: all. Joints without room between their limits are left
  /// out. `others`: where variables stand that are not planned; those that it does not name are at rest. Throws kBadOption for a pattern
  /// that no movable joint matches, where `others` holds all that it matches, and where Kinematics::configuration() does.
  JointSpace(const Kinematics& kinematics, const std::string& pattern, const std::map<std::string, double>& others = {});

  const std::vector<JointVariable>& joints() const { return joints_; }

  /// Of all variables, from values of the planned ones; and back.
  Configuration configuration(const JointValues& values) const;
  JointValues values(const Configuration& configuration) const;

  /// Whether planned joints move a link (index), or two links against each other. As in MoveIt, planners need not check what they do not.
  bool moves(std::size_t link) const { return !way(link).empty(); }
  bool moves(std::size_t link, std::size_t other) const;

  /// The links' poses in the root link's frame.
  std::vector<Eigen::Isometry3d> poses(const JointValues& values) const { return kinematics_.poses(configuration(values)); }

 private:
  /// The joints that move a link, up to the last planned one.
  std::vector<ChainJoint> way(std::size_t link) const;

  const Kinematics& kinematics_;
  std::vector<JointVariable> joints_;
  std::vector<std::size_t> variables_;  // of the planned joints, indices
  Configuration others_;
};

/// Joint values at `share` of the straight way; continuous joints take the shorter way.
JointValues between(const std::vector<JointVariable>& joints, const JointValues& from, const JointValues& to, double share);

/// The values from the first to the last of a path of straight motions, such that no joint moves further than `step`, a share of its range,
/// from one to the next.
std::vector<JointValues> alongPath(const std::vector<JointVariable>& joints, const std::vector<JointValues>& path, double step);

}  // namespace collision_hulls
