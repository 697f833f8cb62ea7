#include "base/uri_text.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

/// The message of a refusal, which is empty if there is none.
std::string refusal(const std::string& uri) {
  try {
    checkCharacters(uri);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kFileNotFound) << error.what();
    return error.what();
  }
  return "";
}

TEST(CheckCharacters, EveryControlCharacterRawAndEncoded) {
  for (int c = 0; c < 256; ++c) {
    char code[4];
    std::snprintf(code, sizeof code, "%%%02x", static_cast<unsigned>(c));
    for (const std::string& text : {std::string("a") + static_cast<char>(c), std::string("a") + code}) {
      if (c < 0x20 || c == 0x7F) {
        EXPECT_NE(refusal(text).find("control character"), std::string::npos) << c;
      } else {
        EXPECT_EQ(refusal(text), "");
      }
    }
  }
}

TEST(CheckCharacters, Length) {
  EXPECT_EQ(refusal(std::string(4096, 'a')), "");
  EXPECT_NE(refusal(std::string(4097, 'a')).find("4097 bytes"), std::string::npos);
}

TEST(Shown, IsShortAndPrintable) {
  EXPECT_EQ(shown("a\nb\x7F"), "a?b?");
  EXPECT_EQ(shown(std::string(300, 'a')), std::string(100, 'a') + "... (300 bytes) ..." + std::string(100, 'a'));
}

TEST(PercentDecoded, Once) {
  EXPECT_EQ(percentDecoded("a%20b%2525%"), "a b%25%");
  EXPECT_EQ(percentDecoded("%zz%4"), "%zz%4");
}

TEST(LeadsOut, Ways) {
  for (const char* path : {"", "a", "a/../b", "./a", "a/b/../..", "..a"}) EXPECT_FALSE(leadsOut(path)) << path;
  for (const char* path : {"..", "../a", "a/../..", "a/../../b/a", "/a", "//a"}) EXPECT_TRUE(leadsOut(path)) << path;
}

}  // namespace
}  // namespace collision_hulls
