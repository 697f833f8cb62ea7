#include "xml/xml_values.h"

#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

/// The values of `a`, each with its path, as they are asked for.
std::vector<std::string> asked(const std::string& text) {
  std::vector<std::string> all;
  withNewValues(text, "'f'", "a", [&](const std::string& path, const std::string& value) {
    all.push_back(path + "=" + value);
    return std::nullopt;
  });
  return all;
}

std::string with(const std::string& text, const std::string& value) {
  return withNewValues(text, "'f'", "a", [&](const std::string&, const std::string&) { return std::optional(value); });
}

TEST(WithNewValues, AsksForEachInOrder) {
  const std::string text = "<r a='0'><s a=\"1&amp;&#50;\"><t b='a=\"x\"' a = '2'/></s><t/><s><u a=''/></s></r>";
  EXPECT_EQ(asked(text), (std::vector<std::string>{"r=0", "r/s=1&2", "r/s/t=2", "r/s/u="}));
}

TEST(WithNewValues, AllElseStaysByteForByte) {
  const std::string head = "\xEF\xBB\xBF<?xml version='1.0'?>\r\n<!DOCTYPE r [<!ELEMENT r ANY>]><!-- <r a='no'/> --><r\t b='a' ";
  const std::string middle = "  ><![CDATA[<s a='no'/>]]><?p a='no'?> &lt;s a='no'/> <x:s  c='>' ", tail = " /></r >\n<!-- a='no' -->\n";
  EXPECT_EQ(with(head + "a = '&quot;'" + middle + "a=\"\"" + tail, "n"), head + "a = 'n'" + middle + "a=\"n\"" + tail);
  EXPECT_EQ(withNewValues(head + middle + tail, "'f'", "a", [](const auto&, const auto&) { return std::nullopt; }), head + middle + tail);
}

TEST(WithNewValues, EscapesInEitherQuotes) {
  const std::string odd = "<&>\"'\t\n\xC3\xA9%20";
  for (const char* text : {"<r a='x' b=\"y\"/>", "<r a=\"x\" b='y'/>"}) {
    const std::string written = with(text, odd);
    EXPECT_EQ(asked(written), std::vector<std::string>{"r=" + odd}) << written;
    EXPECT_EQ(with(written, "x"), text);
  }
}

TEST(WithNewValues, RefusesWhatIsNoXml) {
  expectError(ErrorCode::kNotXml, {"'f'", "line 2"}, [] { with("<r>\n<s></r>", "x"); });
}

}  // namespace
}  // namespace collision_hulls
