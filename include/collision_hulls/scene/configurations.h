// Configurations in which a robot is looked at: samples of all that its joints allow, or those of a file.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "collision_hulls/robot/kinematics.h"

namespace collision_hulls {

/// How samples follow each other.
enum class Sampling {
  kEven,        ///< Richtmyer's low-discrepancy sequence: few samples miss little. For searching
  kIndependent  ///< independent of each other: what statistics hold for, such as a rate below 3/N at 95 % after N without a hit
};

/// A sequence of configurations within the variables' limits. The i-th is the same however many are asked for, so that more of them extend
/// a set. Another seed gives another sequence. Immutable, thread safe.
class ConfigurationSequence {
 public:
  explicit ConfigurationSequence(const Kinematics& kinematics, std::uint64_t seed = 1, Sampling sampling = Sampling::kEven);
  Configuration operator()(std::uint64_t index) const;

 private:
  std::vector<JointVariable> variables_;
  std::vector<std::uint64_t> start_, step_;  // of a variable; fractions of 2^64
  Sampling sampling_;
};

struct ConfigurationOptions {
  /// [rad or m] > 0: between one configuration and the next of the same trajectory others are put, evenly, so that no variable moves
  /// further in a step; continuous joints go the shorter way. 0: none are. Rows of a CSV are no trajectory unless `in_order`.
  double max_step = 0;
  bool in_order = false;              ///< the rows of a CSV, and the messages of a file, follow each other in time
  bool refuse_beyond_limits = false;  ///< kBadConfigurations for a value beyond its limits; else counted
  std::size_t most = 10'000'000;      ///< more than that are kTooLarge
};

/// Configurations that were given. Nothing is clamped: values beyond limits are used as they are, and counted.
struct ConfigurationSet {
  std::vector<Configuration> configurations;
  std::size_t given = 0;           ///< before any were put between them
  std::size_t beyond_limits = 0;   ///< values further beyond their limits than 1e-6 of them
  std::vector<std::string> notes;  ///< what the user should know, a line each: the first value beyond limits, mimic joints that differ
                                   ///< from what their master says, joints that stay at rest
};

/// Collects configurations that come as names and positions, from a file, a bag or a topic.
class ConfigurationCollector {
 public:
  explicit ConfigurationCollector(const Kinematics& kinematics, const ConfigurationOptions& options = {});

  /// Names that are missing stay at rest. Positions [rad or m] of mimic joints are compared with what their master says; those of fixed
  /// joints are not looked at. `where` stands in messages: "'a.csv', line 3". Throws kBadConfigurations for a name that the robot
  /// does not have (the message lists its joints) or that stands twice, another number of positions than of names, and values that are
  /// not finite.
  void add(const std::vector<std::string>& names, const std::vector<double>& positions, const std::string& where);

  /// The next one follows no other.
  void endTrajectory();

  ConfigurationSet take();

 private:
  void interpolateTo(const Configuration& next);
  const Kinematics& kinematics_;
  ConfigurationOptions options_;
  ConfigurationSet set_;
  std::map<std::string, double> mimic_differences_;
  bool follows_ = false;
};

/// Reads configurations by the extension and content of a file:
///   .csv    the header names joints, in any order; `rostopic echo -p /joint_states` too: columns field.nameN and field.positionN
///   .yaml   `rostopic echo /joint_states` (sensor_msgs/JointState, documents separated by ---), trajectory_msgs/JointTrajectory
///           (joint_names, points: - positions), or messages that hold the latter (DisplayTrajectory, RobotTrajectory, goals)
/// Throws kFileNotFound, kUnsupportedFormat, kTooLarge, and kBadConfigurations, naming the line, for what cannot be read, for a
/// file without a configuration, and as ConfigurationCollector does.
ConfigurationSet readConfigurations(const std::string& file, const Kinematics& kinematics, const ConfigurationOptions& options = {});

}  // namespace collision_hulls
