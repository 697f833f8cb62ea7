#include "xml/xml_tree.h"

#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

TEST(XmlTree, ElementsWithTheirLines) {
  const XmlNode root = parseXml("<?xml version='1.0'?>\n<!-- c -->\n<a x='1&amp;2'>\n  <b> some text </b><c/>\n<b/></a>", "'f'");
  EXPECT_EQ(root.name, "a");
  EXPECT_EQ(root.line, 3u);
  EXPECT_EQ(root.attribute("x"), "1&2");
  EXPECT_EQ(root.attribute("y"), "");
  ASSERT_EQ(root.childrenNamed("b").size(), 2u);
  EXPECT_EQ(root.childrenNamed("b")[1]->line, 5u);
  ASSERT_TRUE(root.child("b"));
  EXPECT_EQ(root.child("b")->text, "some text");
  EXPECT_EQ(root.child("d"), nullptr);
}

TEST(XmlTree, NamesFileAndLine) {
  expectError(ErrorCode::kNotXml, {"'f'", "line 2"}, [] { parseXml("<a>\n<b></a>", "'f'"); });
  expectError(ErrorCode::kNotXml, {"'f'"}, [] { parseXml("", "'f'"); });
}

TEST(XmlTree, EntitiesDoNotGrow) {
  std::string text = "<!DOCTYPE a [<!ENTITY e0 'ha'>";
  for (int i = 1; i < 30; ++i) {
    const std::string before = "&e" + std::to_string(i - 1) + ";";
    text += "<!ENTITY e" + std::to_string(i) + " '" + before + before + "'>";
  }
  EXPECT_LT(parseXml(text + "]><a>&e29;</a>", "'f'").text.size(), 10u);
}

TEST(XmlTree, NestingIsBounded) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  for (int i = 0; i < 100000; ++i) deep += "</a>";
  expectError(ErrorCode::kNotXml, {"'f'", "nest"}, [&] { parseXml(deep, "'f'"); });
}

TEST(XmlTree, EscapedTextReadsBack) {
  const std::string text = "a<b> & \"c\"";
  EXPECT_EQ(parseXml("<a x=\"" + xmlEscaped(text) + "\"/>", "'f'").attribute("x"), text);
}

}  // namespace
}  // namespace collision_hulls
