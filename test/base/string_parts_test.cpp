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

TEST(Shortened, KeepsStartAndEndAndSaysTheLength) {
  EXPECT_EQ(shortened(std::string(200, 'a')), std::string(200, 'a'));
  EXPECT_EQ(shortened("abcdefghij", 9), "abcd... (10 bytes) ...ghij");
  EXPECT_EQ(shortened("", 0), "");
}

TEST(Shortened, CutsNoCharacter) {
  const std::string text = "ab\xE2\x82\xACxyz\xE2\x82\xAC";  // ab, a euro, xyz, a euro
  EXPECT_EQ(shortened(text, 6), "ab... (11 bytes) ...\xE2\x82\xAC");
  EXPECT_EQ(shortened(text, 4), "ab... (11 bytes) ...");
  EXPECT_EQ(shortened(std::string(20, '\x80'), 10), "\x80\x80... (20 bytes) ...\x80\x80");
}

TEST(Listed, PutsAWordBetweenTwo) {
  EXPECT_EQ(listed(std::vector<std::string>{"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(listed(std::vector<std::string>{"a", "b"}, " and "), "a and b");
  EXPECT_EQ(listed(std::vector<std::string>{"a"}), "a");
  EXPECT_EQ(listed(std::vector<std::string>{}), "");
  EXPECT_EQ(listedFirst(std::vector<std::string>{"a", "b"}, 2), "a, b");
  EXPECT_EQ(listedFirst(std::vector<std::string>{"a", "b", "c", "d"}, 2), "a, b and 2 more");
}

TEST(LastPart, IsWhatStandsBehindTheLastSlash) {
  EXPECT_EQ(lastPart("package://arm/meshes/base.dae"), "base.dae");
  EXPECT_EQ(lastPart("base.dae"), "base.dae");
  EXPECT_EQ(lastPart("meshes/"), "");
}

TEST(LowerExtension, IsThatOfTheFile) {
  EXPECT_EQ(lowerExtension("a/b.STL"), ".stl");
  EXPECT_EQ(lowerExtension("arm.urdf.Xacro"), ".xacro");
  EXPECT_EQ(lowerExtension("v1.2/mesh"), "");
}

}  // namespace
}  // namespace collision_hulls
