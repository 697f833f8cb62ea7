// Descriptions: what they say, where their elements stand, and their rewriting.
#include "collision_hulls/robot/robot_description.h"
#include "fuzz/target.h"

namespace collision_hulls::fuzz {
namespace {

void takeUrdf(const std::string& bytes) {
  const RobotDescription robot = parseRobotDescription(bytes, "input.urdf");
  GeometryElement box;
  box.kind = GeometryElement::Kind::kBox;
  box.size = {1, 2, 3};
  std::map<std::string, LinkCollisions> collisions;
  for (const LinkDescription& link : robot.links) collisions[link.name] = {{{"new", box}}, false};
  const RobotDescription rewritten = parseRobotDescription(rewriteCollisions(robot, collisions), "rewritten.urdf");
  expect(rewritten.links.size() == robot.links.size(), "the rewritten description has the same links");
  for (const LinkDescription& link : rewritten.links) expect(link.collisions.size() == 1, "each link has the new element and no other");
}

const Registered kUrdf("urdf", takeUrdf);

}  // namespace
}  // namespace collision_hulls::fuzz
