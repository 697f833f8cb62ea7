// Disabled pairs of an SRDF.
#include "collision_hulls/scene/srdf.h"

#include "fuzz/target.h"

namespace collision_hulls::fuzz {
namespace {

void takeSrdf(const std::string& bytes) {
  static const RobotDescription robot = parseRobotDescription(
      "<robot name='r'><link name='a'/><link name='b'/><link name='c'/>"
      "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint>"
      "<joint name='k' type='fixed'><parent link='a'/><child link='c'/></joint>"
      "</robot>");
  const DisabledPairs read = parseDisabledPairs(bytes, robot, "input.srdf");
  const DisabledPairs again = parseDisabledPairs(srdfFragment(robot.name, read.pairs), robot);
  expect(again.pairs.size() == read.pairs.size(), "what is written is read back");
}

const Registered kSrdf("srdf", takeSrdf);

}  // namespace
}  // namespace collision_hulls::fuzz
