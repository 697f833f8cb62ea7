// Tests src/decode/urdf/refusal.cpp through the descriptions that urdfdom refuses.
#include <gtest/gtest.h>

#include "collision_hulls/robot/robot_description.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

constexpr char kJoint[] =
    "<joint name='j' type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/>"
    "<limit lower='0' upper='1' effort='1' velocity='1'/></joint>\n";

// Robot, link 'a', link 'b' and the joint stand in lines 1 to 4.
void expectRefused(const std::vector<std::string>& parts, const std::string& joint, const std::string& more = "") {
  const std::string text = "<robot name='r'>\n<link name='a'/>\n<link name='b'/>\n" + joint + more + "</robot>";
  expectError(ErrorCode::kNotARobot, parts, [&] { parseRobotDescription(text, "a.urdf"); });
}

void expectRefusedWith(const std::string& old_part, const std::string& new_part, const std::vector<std::string>& parts) {
  std::string joint = kJoint;
  joint.replace(joint.find(old_part), old_part.size(), new_part);
  expectRefused(parts, joint);
}

TEST(Refusal, SaysWhatAJointLacks) {
  expectRefusedWith("<limit lower='0' upper='1' effort='1' velocity='1'/>", "", {"'a.urdf', line 4", "[j]", "; give it <limit lower"});
  expectRefused({"line 4", "[j]", "; give it <limit lower", "in metres"},
                "<joint name='j' type='prismatic'><parent link='a'/><child link='b'/></joint>\n");
  expectRefusedWith("</joint>", "<safety_controller k_position='1'/></joint>",
                    {"line 4", "; add k_velocity=\"...\" to its <safety_controller>"});
  expectRefusedWith(" effort='1'", "", {"line 4", "; add effort=\"...\" to its <limit>"});
  expectRefusedWith(" velocity='1'", "", {"line 4", "; add velocity=\"...\" to its <limit>"});
  expectRefusedWith(" type='revolute'", "", {"line 4", "; add type=\"...\": revolute"});
  expectRefusedWith("revolute", "rotary", {"line 4", "[rotary]", "; use revolute, continuous"});
  expectRefusedWith("<parent link='a'/>", "", {"line 4", "; give it <parent link"});
  expectRefusedWith(" name='j'", "", {"line 1", "; give each <joint> a name"});
  expectRefusedWith("<axis", "<mimic/><axis", {"line 4", "; add joint=\"...\" to its <mimic>"});
}

TEST(Refusal, SaysHowNumbersAreWritten) {
  expectRefusedWith("0 0 1", "0,0,1", {"line 4", "[0,0,1]", "; write decimal numbers with spaces"});
  expectRefusedWith("0 0 1", "$(optenv AXIS 0 0 1)", {"line 4", "[$(optenv]", "; $(...) and ${...} are for xacro: write the value"});
  expectRefusedWith("0 0 1", "0 0", {"line 4", "[0 0]", "; write as many numbers"});
  expectRefusedWith("lower='0'", "lower='pi'", {"line 4", "; write a decimal number"});
}

TEST(Refusal, IsPlacedAtTheSecondOfTwo) {
  expectRefused({"line 5", "'b' is not unique", "; rename one"}, kJoint, "<link name='b'/>");
  expectRefused({"line 6", "'j' is not unique", "; rename one"}, kJoint,
                "<link name='c'/>\n<joint name='j' type='fixed'><parent link='a'/><child link='c'/></joint>");
  expectRefused({"line 6", "'white' is not unique; rename one"}, kJoint,
                "<material name='white'><color rgba='1 1 1 1'/></material>\n<material name='white'><color rgba='1 1 1 1'/></material>");
  expectRefused({"line 5", "[a] and [c]", "; connect them"}, kJoint, "<link name='c'/>");
}

TEST(Refusal, NamesLinksThatDoNotExist) {
  expectRefusedWith("link='a'", "link='aa'", {"line 4", "[aa]", "; correct the name, or add the link"});
  expectRefusedWith("link='b'", "link='bb'", {"line 4", "[bb]", "; correct the name, or add the link"});
}

// A joint's name may be a part of the complaint about another.
TEST(Refusal, TakesNamesFromTheirBracketsOnly) {
  expectRefused({"line 4", "[rotary]"}, "<joint name='j' type='rotary'><parent link='a'/><child link='b'/></joint>\n",
                "<link name='c'/><joint name='rotary' type='fixed'><parent link='a'/><child link='c'/></joint>");
}

}  // namespace
}  // namespace collision_hulls
