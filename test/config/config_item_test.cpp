#include "config/config_item.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

YamlValue yaml(const std::string& text) {
  return YamlValue::parse(text, "f.yaml", ErrorCode::kBadOption);
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ConfigItem, EachKindOfValueIsNamed) {
  const auto refused = [](const std::string& text) {
    return refusal([&] { ConfigItem{yaml("a: " + text).entries().front().second, "size"}.text("a number"); });
  };
  EXPECT_EQ(refused("{b: 1}"), "'f.yaml', line 1: size is a map: use a number");
  EXPECT_EQ(refused("[1]"), "'f.yaml', line 1: size is a list: use a number");
  EXPECT_EQ(refused(""), "'f.yaml', line 1: size is nothing: use a number");
  EXPECT_EQ(refused("3"), "accepted");
  EXPECT_NE(refused("\"\\e[2J\"").find("control character"), std::string::npos);
}

TEST(ConfigItem, AMapGoesToItsReaders) {
  std::string seen;
  const ConfigReaders readers = {{"one", [&](const ConfigItem& item) { seen += item.name + "=" + item.text("") + ";"; }},
                                 {"two", [&](const ConfigItem& item) { seen += item.name + "=" + item.text("") + ";"; }}};
  readMap({yaml("two: 2\none: 1"), "this"}, readers, "a map");
  EXPECT_EQ(seen, "two of this=2;one of this=1;");
  EXPECT_NE(refusal([&] {
              readMap({yaml("twoo: 2"), "this"}, readers, "");
            }).find("'twoo' is not known in this: use one of one, two"),
            std::string::npos);
  EXPECT_EQ(refusal([&] {
              readMap({yaml("three: 3"), "this"}, readers, "", [](const std::string& key) { return "; " + key + " stands elsewhere"; });
            }),
            "'f.yaml', line 1: 'three' is not known in this: use one of one, two; three stands elsewhere");
  EXPECT_NE(refusal([&] { readMap({yaml("one: 1\none: 2"), "this"}, readers, ""); }).find("already in line 1"), std::string::npos);
}

TEST(ConfigItem, LongTextsAreCut) {
  EXPECT_EQ(shortQuoted("abc"), "'abc'");
  EXPECT_LT(shortQuoted(std::string(1000, 'x')).size(), 80u);
}

}  // namespace
}  // namespace collision_hulls
