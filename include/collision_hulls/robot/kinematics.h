// Forward kinematics: where the links of a robot are when its joints have given values.
//
// For example:
//
//     const Kinematics kinematics(robot);
//     const Configuration bent = kinematics.configuration({{"elbow", 0.5}});  // [rad]
//     const Eigen::Isometry3d hand = kinematics.poses(bent).back();           // of the last link
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// A joint that can be set by itself. Limits in rad or m; -pi and pi for a continuous one.
struct JointVariable {
  std::string name;
  double lower = 0, upper = 0;
  bool continuous = false;  ///< turns all the way round
};

/// Whether a value [rad or m] is within the limits, or beyond them by no more than 1e-6 of their
/// size, which decimal text may have rounded away. NaN is not.
bool withinLimits(const JointVariable& variable, double value);

/// For messages: "joint 'elbow' at 3.000000 is beyond its limits, -1.000000 to 1.000000".
std::string beyondLimits(const JointVariable& variable, double value);

/// A joint of the robot by its name, and what moves it.
struct NamedJoint {
  std::string name;
  int variable = -1;  ///< index in Kinematics::variables(); -1: none moves it
  /// it stands at multiplier * variable + offset [rad or m]; 1 and 0 for the variable's own
  double multiplier = 1, offset = 0;
};

/// A value [rad or m] for each variable, in the order of Kinematics::variables().
using Configuration = std::vector<double>;

/// A joint that moves, on the way from the root to a link.
struct ChainJoint {
  /// about its axis; else slides along it
  bool turns = true;
  /// of its frame in that which the joint before it moves, or the root link's
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< of unit length, in its frame
  /// that moves it, index in Kinematics::variables()
  std::size_t variable = 0;
  /// it stands at multiplier * variable + offset [rad or m]
  double multiplier = 1, offset = 0;
};

/// Whether all of this is equal. Such joints move what hangs on them alike if those before them do.
bool equalJoints(const ChainJoint& a, const ChainJoint& b);

/// The joints that move a link, those nearest to the root first.
struct Chain {
  std::vector<ChainJoint> joints;
  /// of the link in the frame that the last joint moves, or the root link's
  Eigen::Isometry3d end = Eigen::Isometry3d::Identity();
};

/// The tree of a robot's joints. Revolute, continuous and prismatic joints that mimic no other are
/// variables; a mimic joint follows multiplier * value + offset of its master, through any number
/// of masters and without regard to its own limits, as in robot_state_publisher. Floating and
/// planar joints, which place a robot in the world, stay at their origin; so do those that slide to
/// a limit further than 1e6 m away. Immutable. The indices of links are those of
/// RobotDescription::links, and have to be below links().
class Kinematics {
 public:
  /// Throws kNotARobot for a mimic joint whose master is not there or cannot move, for mimic joints
  /// that follow one another in a circle, for an origin that is no pose or further than 1e6 m away,
  /// for a mimic joint that slides as far or turns without end, and for more than a million links
  /// below floating or planar joints (a link counts for each of these). Also for what only a
  /// description made by hand has: two links or joints of one name, a link that two joints lead to,
  /// joints in a circle or with children before parents, limits that are crossed or not finite, and
  /// an axis of a moving joint that is not of unit length.
  explicit Kinematics(const RobotDescription& robot);

  const std::vector<JointVariable>& variables() const { return variables_; }

  std::size_t links() const { return links_; }  ///< how many the robot has

  /// All joints of the robot, parents before children.
  std::vector<NamedJoint> joints() const;

  /// All variables at zero, or at the limit that is nearest to it.
  Configuration rest() const;

  /// rest() with the values of the named variables. Throws kBadOption for a name that is no
  /// variable, a value that is not finite, and one that is beyond its limits by more than 1e-6 of
  /// them; a continuous joint has none.
  Configuration configuration(const std::map<std::string, double>& values) const;

  /// Each variable between its limits, from numbers in [0, 1).
  Configuration sample(const std::function<double()>& uniform) const;

  /// Throws kBadOption for a configuration of another size, or with a value that is not finite.
  void check(const Configuration& configuration) const;

  /// The links' poses in the root link's frame, in the order of RobotDescription::links. Throws as
  /// check().
  std::vector<Eigen::Isometry3d> poses(const Configuration& configuration) const;

  /// How the joints move a link (index).
  Chain chain(std::size_t link) const;

  /// Whether collision checks leave a pair of links (indices) out: those that never move against
  /// each other, as only fixed joints are between them, and those that touch by design, as one
  /// joint joins them. At that joint, a link without geometry stands for the link that is fixed to
  /// it, if there is just one. A mast that is fixed to the base is not adjacent to the arm's first
  /// link.
  bool adjacent(std::size_t link, std::size_t other) const;

  /// Whether every place that two links (indices) can have against each other is that of some
  /// values of the variables within their limits. Not so across a floating or planar joint, nor
  /// across one that mimics a continuous joint at another pace, as its place depends on the turns
  /// made before.
  bool settled(std::size_t link, std::size_t other) const;

  /// The same for a link against the world in which the root link stands. Floating and planar
  /// joints count as fixed at their origin.
  bool settled(std::size_t link) const;

  /// A sentence for each joint that does not move as one might expect: without room between its
  /// limits, or not settled.
  std::vector<std::string> notes() const;

 private:
  struct Joint {
    JointDescription description;
    std::size_t parent = 0, child = 0;  // links
    int variable = -1;                  // -1: none moves it
    double multiplier = 1, offset = 0;  // of the variable's value
    bool paced = false;                 // mimics a continuous joint at another pace
  };
  void check(const JointDescription& joint) const;
  std::vector<Joint> joints_;  // parents before children
  std::vector<JointVariable> variables_;
  std::size_t links_ = 0;
  void findEnds(const std::vector<LinkDescription>& links);
  // per link: its parent, itself for the root; the first of those that fixed joints join to it; and
  // the link with geometry that touches what a joint joins to it: itself, or of a link without
  // geometry the one that is fixed to it
  std::vector<std::size_t> parent_, body_, end_;
  // per link: the joints on the way from the root that are floating, planar or paced
  std::vector<std::vector<std::size_t>> unsettled_;
};

/// The motion of a joint's child against the joint's origin at a value [rad or m]; none for joints
/// that are no variables.
Eigen::Isometry3d motion(const JointDescription& joint, double value);
Eigen::Isometry3d motion(const ChainJoint& joint, double value);

/// Zero, or the limit of the joint that is nearest to it.
double restValue(const JointDescription& joint);

}  // namespace collision_hulls
