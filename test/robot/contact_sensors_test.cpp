#include "robot/contact_sensors.h"

#include <gtest/gtest.h>

#include "xml/xml_spans.h"

namespace collision_hulls {
namespace {

using Names = std::set<std::string>;
using Links = std::vector<std::string>;

std::string sensor(const std::string& name) {
  return "<gazebo><sensor type=\"contact\"><contact><collision>" + name + "</collision></contact></sensor></gazebo>";
}

Names unnamedIn(const std::string& content) {
  return unnamedContacts("<robot>" + content + "</robot>");
}

TEST(ContactSensors, NameCollisionsThatNoElementHas) {
  EXPECT_EQ(unnamedIn(sensor("b_collision") + sensor("\n  a_collision ") + sensor("a_collision")), (Names{"a_collision", "b_collision"}));
  EXPECT_EQ(unnamedIn(sensor("a_0") + "<link name=\"a\"><collision name=\"a_0\"><geometry/></collision></link>" + sensor("b")), Names{"b"});
}

TEST(ContactSensors, AreToldFromCollisionElements) {
  EXPECT_EQ(unnamedIn("<link name=\"a\"><collision> <geometry><box size=\"1 1 1\"/></geometry></collision></link>"), Names());
  EXPECT_EQ(unnamedIn(sensor("") + sensor(" ") + "<collision>a<b/></collision>"), Names());
  EXPECT_THROW(unnamedContacts("<robot><collision>cut"), XmlSyntaxError);
}

// A name as long as a file, for which a regular expression needs as deep a stack, and as many names as fit into one.
TEST(ContactSensors, OfAnyLengthAndNumberAreLookedThrough) {
  EXPECT_EQ(unnamedIn(sensor(std::string(2'000'000, 'a')) + sensor("b")), Names{"b"});
  std::string many;
  for (int i = 0; i < 50'000; ++i) many += "<collision>" + std::to_string(i) + "</collision><a name=\"" + std::to_string(i) + "\"/>";
  EXPECT_EQ(unnamedIn(many), Names());
}

TEST(ContactSensors, CallCollisionsByTheirLinks) {
  EXPECT_EQ(linksOfCollision("finger_collision"), Links{"finger"});
  EXPECT_EQ(linksOfCollision("finger_collision_1"), Links{"finger"});
  EXPECT_EQ(linksOfCollision("arm_fixed_joint_lump__tip_collision_2"), (Links{"arm_fixed_joint_lump__tip", "tip"}));
  EXPECT_EQ(linksOfCollision("the_collision_link_collision"), (Links{"the", "the_collision_link"}));
  EXPECT_EQ(linksOfCollision("finger"), Links());
}

}  // namespace
}  // namespace collision_hulls
