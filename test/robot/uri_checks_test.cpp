#include "robot/uri_checks.h"

#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

TEST(IsPackageName, LooserThanRep144) {
  for (const char* name : {"arm", "arm_description", "Arm-2", "2f_gripper", "_x", "ur5.1"}) EXPECT_TRUE(isPackageName(name)) << name;
  for (const char* name : {"", "-x", "--help", ".", "..", ".x", "a/b", "a b", "a;b", "a\nb", "$HOME", "a%20b", "\xC3\xA4"})
    EXPECT_FALSE(isPackageName(name)) << name;
}

TEST(CheckStaysWithin, Ways) {
  for (const char* path : {"", "a", "a/../b", "./a", "a/b/../..", "..a"}) EXPECT_NO_THROW(checkStaysWithin("uri", "arm", path)) << path;
  for (const char* path : {"..", "../a", "a/../..", "a/../../arm/a", "/a"})
    expectError(ErrorCode::kOutsideRoots, {"leads out of 'arm'"}, [&] { checkStaysWithin("uri", "arm", path); });
}

}  // namespace
}  // namespace collision_hulls
