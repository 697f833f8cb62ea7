#include "storage/names.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(FileName, KeepsWhatIsSafe) {
  EXPECT_EQ(fileName("left_arm-2.v3"), "left_arm-2.v3");
  EXPECT_EQ(fileName("a/b\\c d"), "a_b_c_d");
  EXPECT_EQ(robotFileName("cube.urdf"), "cube");
  EXPECT_EQ(robotFileName("cube.urdf.XACRO"), "cube");
  EXPECT_EQ(robotFileName("cube.v2"), "cube.v2");
  EXPECT_EQ(robotFileName(".urdf"), "_.urdf");
  EXPECT_EQ(fileName(".."), "_..");
  EXPECT_EQ(fileName(""), "_");
  EXPECT_EQ(fileName("\xc3\xa4"), "__");
  EXPECT_LE(fileName(std::string(5000, 'x')).size(), 200u);
}

TEST(PackageName, IsLegal) {
  EXPECT_EQ(packageName("pr2"), "pr2");
  EXPECT_EQ(packageName("UR5 Robot-e"), "ur5_robot_e");
  EXPECT_EQ(packageName("3f_gripper"), "robot_3f_gripper");
  EXPECT_EQ(packageName(""), "robot_");
}

TEST(UniqueNames, AddsANumberToTakenNames) {
  UniqueNames names;
  EXPECT_EQ(names.take("arm"), "arm");
  EXPECT_EQ(names.take("arm"), "arm_2");
  EXPECT_EQ(names.take("arm_2"), "arm_2_2");
  EXPECT_EQ(names.take("ARM"), "ARM_3");  // the same file on case-insensitive systems
}

// With a count from 2 on for each, these take minutes.
TEST(UniqueNames, OfManyThatAreEqual) {
  UniqueNames names;
  for (int i = 0; i < 100'000; ++i) names.take("arm");
  EXPECT_EQ(names.take("Arm"), "Arm_100001");
}

}  // namespace
}  // namespace collision_hulls
