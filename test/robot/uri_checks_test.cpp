#include "robot/uri_checks.h"

#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

TEST(IsPackageName, LooserThanRep144) {
  for (const char* name : {"arm", "arm_description", "Arm-2", "2f_gripper", "_x", "ur5.1"}) EXPECT_TRUE(isPackageName(name)) << name;
  for (const char* name : {"", "-x", "--help", ".", "..", ".x", "a/b", "a b", "a;b", "a\nb", "$HOME", "a%20b", "\xC3\xA4"})
    EXPECT_FALSE(isPackageName(name)) << name;
}

TEST(CheckCharacters, EveryControlCharacterRawAndEncoded) {
  for (int c = 0; c < 256; ++c) {
    char code[4];
    std::snprintf(code, sizeof code, "%%%02x", static_cast<unsigned>(c));
    for (const std::string& text : {std::string("a") + static_cast<char>(c), std::string("a") + code}) {
      if (c < 0x20 || c == 0x7F) {
        expectError(ErrorCode::kFileNotFound, {"control character"}, [&] { checkCharacters(text); });
      } else {
        EXPECT_NO_THROW(checkCharacters(text)) << c;
      }
    }
  }
}

TEST(CheckCharacters, Length) {
  EXPECT_NO_THROW(checkCharacters(std::string(4096, 'a')));
  expectError(ErrorCode::kFileNotFound, {"4097 bytes"}, [] { checkCharacters(std::string(4097, 'a')); });
}

TEST(CheckStaysWithin, Ways) {
  for (const char* path : {"", "a", "a/../b", "./a", "a/b/../..", "..a"}) EXPECT_NO_THROW(checkStaysWithin("uri", "arm", path)) << path;
  for (const char* path : {"..", "../a", "a/../..", "a/../../arm/a", "/a"})
    expectError(ErrorCode::kOutsideRoots, {"leads out of 'arm'"}, [&] { checkStaysWithin("uri", "arm", path); });
}

TEST(Shown, IsShortAndPrintable) {
  EXPECT_EQ(shown("a\nb\x7F"), "a?b?");
  EXPECT_EQ(shown(std::string(300, 'a')), std::string(100, 'a') + "... (300 bytes) ..." + std::string(100, 'a'));
}

TEST(PercentDecoded, Once) {
  EXPECT_EQ(percentDecoded("a%20b%2525%"), "a b%25%");
  EXPECT_EQ(percentDecoded("%zz%4"), "%zz%4");
}

}  // namespace
}  // namespace collision_hulls
