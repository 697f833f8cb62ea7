// Lists of configurations. The first byte chooses the format: CSV or YAML.
#include "collision_hulls/scene/configurations.h"

#include <cmath>

#include "fuzz/target.h"

namespace collision_hulls::fuzz {
namespace {

void takeConfigurations(const std::string& input) {
  static const RobotDescription robot = parseRobotDescription(
      "<robot name='r'><link name='a'/><link name='b'/><link name='c'/>"
      "<joint name='j' type='revolute'><parent link='a'/><child link='b'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint>"
      "<joint name='k' type='continuous'><parent link='b'/><child link='c'/></joint></robot>");
  static const Kinematics kinematics(robot);
  std::string bytes = input;
  const std::string extension = firstOf(bytes) % 2 == 0 ? ".csv" : ".yaml";
  ConfigurationOptions options;
  options.max_step = 0.5;
  options.most = 10'000;
  for (const Configuration& each : readConfigurations(fileOf(bytes, extension), kinematics, options).configurations)
    for (const double value : each) expect(std::isfinite(value), "positions are finite");
}

const Registered kConfigurations("configurations", takeConfigurations);

}  // namespace
}  // namespace collision_hulls::fuzz
