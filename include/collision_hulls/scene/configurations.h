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
  /// [rad or m] > 0: between a configuration and the one that follows it others are put, evenly, so that no variable moves further in a
  /// step; continuous joints go the shorter way. The rows of a CSV follow each other, and the messages of a file. 0: none are put.
  double max_step = 0;
  bool refuse_beyond_limits = false;  ///< kBadConfigurations for a value beyond its limits; else it is used, and counted
  std::size_t most = 10'000'000;      ///< more configurations than that are kTooLarge
};

/// Configurations that were given. Nothing is clamped. What is proved for all that the limits allow (see reach.h) says nothing about values
/// beyond them.
struct ConfigurationSet {
  std::vector<Configuration> configurations;
  std::size_t given = 0;           ///< before others were put between them
  std::size_t beyond_limits = 0;   ///< values further beyond their limits than 1e-6 of them; continuous joints have none
  std::vector<std::string> notes;  ///< what the user should know, a line each: the first value beyond limits, mimic joints that are not
                                   ///< where their master says, joints that no name ever named
};

/// Collects configurations that come as names and positions, from a file, a bag or a topic. Keeps a reference to the kinematics.
class ConfigurationCollector {
 public:
  /// Throws kBadOption for a step that is negative or not finite.
  explicit ConfigurationCollector(const Kinematics& kinematics, const ConfigurationOptions& options = {});

  /// Joints that are not named stay where they were, at rest in the beginning: several publishers may share a topic. Positions [rad or m]
  /// of mimic joints are compared with what their master says, those of joints that do not move are not looked at. `where` stands in
  /// messages: "'a.csv', line 3". Throws kBadConfigurations for a name that the robot does not have (the message lists its joints) or that
  /// stands twice, another number of positions than of names, and values that are not finite.
  void add(const std::vector<std::string>& names, const std::vector<double>& positions, const std::string& where);

  /// The next configuration does not follow the last one.
  void endTrajectory() { follows_ = false; }

  /// What was collected; the collector is empty then.
  ConfigurationSet take();

 private:
  struct Difference {
    double largest = 0;
    std::string where;
  };
  void put(const NamedJoint& joint, double position, const std::string& where);
  void compareMimics(const std::vector<std::string>& names, const std::vector<double>& positions, const std::string& where);
  void append(const Configuration& next);

  const Kinematics& kinematics_;
  const ConfigurationOptions options_;
  std::map<std::string, NamedJoint> joints_;
  Configuration current_;
  std::vector<char> named_;  // of a variable: whether a name ever named it
  std::string first_beyond_;
  std::map<std::string, Difference> differences_;  // of mimic joints
  ConfigurationSet set_;
  bool follows_ = false;
};

/// Reads configurations from a file:
///
///   .csv          the first line names joints, in any order, the others hold their positions; a column `time` or `stamp` is passed over.
///                 Or `rostopic echo -p` of sensor_msgs/JointState. Parted by commas, semicolons or tabs; lines that begin with # are
///                 comments
///   .yaml .yml    `rostopic echo`, documents parted by `---`: sensor_msgs/JointState (name, position), trajectory_msgs/JointTrajectory
///                 (joint_names, points with positions), and messages that hold such, as MoveIt's RobotTrajectory and DisplayTrajectory
///
/// Throws kFileNotFound, kUnsupportedFormat, kTooLarge, and kBadConfigurations, naming the line, for what cannot be read, for a
/// file without a configuration, and as ConfigurationCollector does.
ConfigurationSet readConfigurations(const std::string& file, const Kinematics& kinematics, const ConfigurationOptions& options = {});

}  // namespace collision_hulls
