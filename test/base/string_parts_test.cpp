#include "base/string_parts.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(Trimmed, CutsBothEndsOnly) {
  EXPECT_EQ(trimmed(" \ta b\n", " \t\n"), "a b");
  EXPECT_EQ(trimmed("xxaxbx", "x"), "axb");
  EXPECT_EQ(trimmed(" \n", " \n"), "");
  EXPECT_EQ(trimmed("", " "), "");
}

TEST(LowerExtension, IsThatOfTheFile) {
  EXPECT_EQ(lowerExtension("a/b.STL"), ".stl");
  EXPECT_EQ(lowerExtension("arm.urdf.Xacro"), ".xacro");
  EXPECT_EQ(lowerExtension("v1.2/mesh"), "");
}

}  // namespace
}  // namespace collision_hulls
