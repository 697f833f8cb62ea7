// Robot configurations: samples from the joints' whole ranges, or configurations read from a file.
//
// For example:
//
//     const ConfigurationSequence sample(kinematics);
//     for (std::uint64_t i = 0; i < 1000; ++i) kinematics.poses(sample(i));
//     const ConfigurationSet path = readConfigurations("path.csv", kinematics);
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/robot/kinematics.h"

namespace collision_hulls {

/// How samples are distributed.
enum class Sampling {
  /// Richtmyer's low-discrepancy sequence, which leaves only small gaps; for searching
  kEven,
  /// statistically independent; for statistics, such as a rate below 3/N at 95 % confidence after N
  /// samples without a hit
  kIndependent
};

/// A sequence of configurations within the joint limits. The i-th configuration does not depend on
/// how many are drawn, so a longer run extends a shorter one. Each seed gives another sequence.
/// Immutable.
class ConfigurationSequence {
 public:
  explicit ConfigurationSequence(const Kinematics& kinematics, std::uint64_t seed = 1,
                                 Sampling sampling = Sampling::kEven);
  Configuration operator()(std::uint64_t index) const;

 private:
  std::vector<JointVariable> variables_;
  std::vector<std::uint64_t> start_, step_;  // of a variable; fractions of 2^64
  Sampling sampling_;
};

struct ConfigurationOptions {
  /// [rad or m] If > 0, interpolates evenly between consecutive configurations so that no variable
  /// moves further in one step; continuous joints take the shorter way. The rows of a CSV are
  /// consecutive, and so are the messages of a file. 0: no interpolation.
  double max_step = 0;
  /// a value beyond its limits throws kBadConfigurations; otherwise it is used and counted
  bool refuse_beyond_limits = false;
  /// more configurations throw kTooLarge, and so do more than 50 million values in all of them
  std::size_t most = 10'000'000;
};

/// Configurations given by the user. None is clamped. Proofs for all values within the limits (see
/// reach.h) say nothing about values beyond them.
struct ConfigurationSet {
  std::vector<Configuration> configurations;
  std::size_t given = 0;  ///< before interpolation
  /// values beyond their limits by more than 1e-6 of the limits' size; continuous joints have none
  std::size_t beyond_limits = 0;
  /// for the user, one line each: the first value beyond its limits, mimic joints that deviate from
  /// their masters, joints never named, messages without positions, transforms that were ignored
  std::vector<std::string> notes;
};

/// Collects configurations that arrive as names and positions: from a file, a bag or a topic.
/// Refers to the kinematics, which must outlive it.
class ConfigurationCollector {
 public:
  /// Throws kBadOption for a step that is negative or not finite.
  explicit ConfigurationCollector(const Kinematics& kinematics,
                                  const ConfigurationOptions& options = {});

  /// Joints that are not named keep their last position, which is the rest position at first:
  /// several publishers may share a topic. Positions [rad or m] of mimic joints are compared with
  /// those that their masters imply; positions of fixed joints are ignored. Names without any
  /// position, as in messages of velocities or efforts alone, are passed over with a note. `where`
  /// appears in messages: "'a.csv', line 3". Throws kBadConfigurations for a name that the robot
  /// does not have (the message lists its joints) or that appears twice, for a number of positions
  /// that differs from the number of names, for values that are not finite, and for those that put
  /// a joint, or one that mimics it, further than 1e9 rad or m from zero; kTooLarge, see
  /// ConfigurationOptions; kCancelled.
  void add(const std::vector<std::string>& names, const std::vector<double>& positions,
           const std::string& where, const RunControl& control = {});

  /// Throws kBadConfigurations for a name that the robot does not have, and for one that appears
  /// twice: as add() does, where names come before any position.
  void expectJoints(const std::vector<std::string>& names, const std::string& where) const;

  /// Ends a trajectory: nothing is interpolated between its last configuration and the next one
  /// added.
  void endTrajectory() { follows_ = false; }

  /// Returns what was collected and empties the collector.
  ConfigurationSet take();

 private:
  struct Difference {
    double largest = 0;
    std::string where;
  };
  void put(const NamedJoint& joint, double position, const std::string& where);
  void compareMimics(const std::vector<std::string>& names, const std::vector<double>& positions,
                     const std::string& where);
  void append(const Configuration& next, const std::string& where, const RunControl& control);

  const Kinematics& kinematics_;
  const ConfigurationOptions options_;
  std::map<std::string, NamedJoint> joints_;
  Configuration current_;
  std::vector<char> named_;  // per variable: whether it was ever named
  std::string first_beyond_;
  std::size_t without_positions_ = 0;  // messages
  std::string first_without_;
  std::map<std::string, Difference> differences_;  // of mimic joints
  ConfigurationSet set_;
  bool follows_ = false;
};

/// Reads configurations from a file:
///
///   .csv          the first line names the joints, in any order, and each further line holds their
///                 positions; a column `time` or `stamp` is ignored. Or the output of `rostopic
///                 echo -p` for sensor_msgs/JointState. Separated by commas, semicolons or tabs;
///                 lines that start with # are comments
///   .yaml .yml    the output of `rostopic echo`, documents separated by `---`:
///                 sensor_msgs/JointState (name, position), trajectory_msgs/JointTrajectory
///                 (joint_names, points with positions), and messages that contain these, such as
///                 MoveIt's RobotTrajectory and DisplayTrajectory
///
/// Throws kFileNotFound, kUnsupportedFormat and kTooLarge; kBadConfigurations, naming the line, for
/// text that cannot be read, for a file without a configuration, and wherever
/// ConfigurationCollector throws it. YAML is parsed in another process, as meshes are: also throws
/// kReaderFailed, kOutOfMemory, kOutOfTime, kCancelled.
ConfigurationSet readConfigurations(const std::string& file, const Kinematics& kinematics,
                                    const ConfigurationOptions& options = {},
                                    const RunControl& control = {});

}  // namespace collision_hulls
