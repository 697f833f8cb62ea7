#include "decode/urdf/joint_graph.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>

namespace collision_hulls {
namespace {

std::string link(const std::string& name) {
  return "<link name='" + name + "'/>\n";
}

std::string joint(const std::string& parent, const std::string& child) {
  return "<joint><parent link='" + parent + "'/><child link='" + child + "'/></joint>\n";
}

void check(const std::string& parts) {
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(("<robot>\n" + parts + "</robot>").c_str()), tinyxml2::XML_SUCCESS);
  checkJointGraph(*document.RootElement());
}

TEST(JointGraph, TreesAndWhatUrdfdomExplainsItselfPass) {
  EXPECT_NO_THROW(check(link("a") + link("b") + link("c") + joint("a", "b") + joint("a", "c")));
  EXPECT_NO_THROW(check(link("a") + joint("a", "nowhere"))) << "an unknown link";
  EXPECT_NO_THROW(check(link("a") + link("b"))) << "two roots";
}

TEST(JointGraph, ALoopIsNamedByItsFirstLink) {
  try {
    check(link("a") + link("b") + link("c") + joint("b", "c") + joint("c", "b"));
    FAIL() << "nothing was thrown";
  } catch (const JointGraphError& error) {
    EXPECT_NE(std::string(error.what()).find("'b'"), std::string::npos) << error.what();
    EXPECT_EQ(error.line(), 3);
  }
}

std::string chain(int joints) {
  std::string parts = link("0");
  for (int i = 0; i < joints; ++i) parts += link(std::to_string(i + 1)) + joint(std::to_string(i), std::to_string(i + 1));
  return parts;
}

TEST(JointGraph, AChainMayHaveTwoThousandJoints) {
  EXPECT_NO_THROW(check(chain(2000)));
  EXPECT_THROW(check(chain(2001)), JointGraphError);
}

}  // namespace
}  // namespace collision_hulls
