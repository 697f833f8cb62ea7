#include "web/three_js.h"

#include <gtest/gtest.h>

#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;

TEST(ThreeJs, TheTextOfTheFile) {
  const fixtures::TempFolder folder;
  fixtures::write(folder / "three.js", "var THREE = 1 < 2;");
  EXPECT_EQ(threeJs(folder / "three.js"), "var THREE = 1 < 2;");
}

TEST(ThreeJs, NoneWithoutTheFile) {
  const fixtures::TempFolder folder;
  EXPECT_EQ(threeJs(folder / "three.js"), "");
  EXPECT_EQ(threeJs(folder.path()), "");
}

TEST(ThreeJs, NoneThatCannotStandInAScript) {
  const fixtures::TempFolder folder;
  for (const char* text : {"a = '</script>'", "a = '</SCRIPT '", "a = '<!--'", "a = '<Script>'"}) {
    fixtures::write(folder / "three.js", text);
    EXPECT_EQ(threeJs(folder / "three.js"), "") << text;
  }
}

TEST(ThreeJs, NoneThatOthersCanWrite) {
  const fixtures::TempFolder folder;
  fixtures::write(folder / "three.js", "var THREE;");
  fs::permissions(folder / "three.js", fs::perms::others_write, fs::perm_options::add);
  EXPECT_EQ(threeJs(folder / "three.js"), "");
}

TEST(ThreeJsNotice, FitsInAComment) {
  EXPECT_EQ(std::string(threeJsNotice()).find("*/"), std::string::npos);
  EXPECT_NE(std::string(threeJsNotice()).find("Copyright"), std::string::npos);
}

}  // namespace
}  // namespace collision_hulls
