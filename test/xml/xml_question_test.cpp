#include "xml/xml_question.h"

#include <gtest/gtest.h>

#include "collision_hulls/error.h"
#include "decode/decode_xml.h"
#include "geometry/bytes.h"

namespace collision_hulls {
namespace {

/// A tree as text, so that two can be compared.
std::string written(const XmlNode& node) {
  std::string text = "<" + node.name + ":" + std::to_string(node.line);
  for (const auto& [key, value] : node.attributes) text += " " + key + "=" + value;
  text += ">" + node.text;
  for (const XmlNode& child : node.children) text += written(child);
  return text + "</>";
}

/// An element of an answer.
std::string element(std::uint32_t depth) {
  return toBytes(depth, std::uint64_t{1}, std::string("a"), std::string(), std::uint64_t{0});
}

TEST(XmlQuestion, SameAsInThisProcess) {
  const std::string text = "<a x='1' y='&lt;'>t\n<b><c/>u</b><b/>\n<d z=''><e><f/></e></d></a>";
  EXPECT_EQ(written(parseXml(text, "x")), written(decodeXml(text, "x")));
  EXPECT_EQ(written(decodeXml(text, "x")), "<a:1 x=1 y=<>t<b:2><c:2></></><b:2></><d:3 z=><e:3><f:3></></></></>");
}

TEST(XmlQuestion, ErrorsComeBack) {
  try {
    parseXml("<a>\n<b></a>", "'x.xml'");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNotXml);
    EXPECT_NE(std::string(error.what()).find("'x.xml', line 2"), std::string::npos) << error.what();
  }
}

TEST(XmlQuestion, CancelledAtOnce) {
  RunControl control;
  control.cancel();
  EXPECT_THROW(parseXml("<a/>", "x", control), Error);
}

TEST(XmlQuestion, AnAnswerThatIsNoTree) {
  const std::uint64_t two = 2, three = 3;
  EXPECT_EQ(xmlIn(toBytes(three) + element(0) + element(1) + element(2)).children.at(0).children.size(), 1u);
  for (const std::string& answer :
       {toBytes(std::uint64_t{0}), toBytes(two) + element(1) + element(1), toBytes(two) + element(0) + element(0),
        toBytes(two) + element(0) + element(2), toBytes(two) + element(0), std::string()})
    EXPECT_THROW(xmlIn(answer), ByteFault);
}

TEST(XmlQuestion, DepthTakesNoStack) {
  std::string answer = toBytes(std::uint64_t{1000000});
  for (std::uint32_t i = 0; i < 1000000; ++i) answer += element(i);
  EXPECT_THROW(xmlIn(answer), ByteFault);
}

}  // namespace
}  // namespace collision_hulls
