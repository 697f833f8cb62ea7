#include "xml/xml_spans.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

std::string spanOf(const std::string& text, const XmlElement& element) {
  return text.substr(element.begin, element.end - element.begin);
}

std::vector<std::string> spans(const std::string& text) {
  std::vector<std::string> found;
  for (const XmlElement& element : scanXml(text).elements) found.push_back(spanOf(text, element));
  return found;
}

using Texts = std::vector<std::string>;

TEST(XmlSpans, FindElementsInDocumentOrder) {
  EXPECT_EQ(spans("<a><b x='1'/><c>text</c></a>"), (Texts{"<a><b x='1'/><c>text</c></a>", "<b x='1'/>", "<c>text</c>"}));
}

TEST(XmlSpans, SkipCommentsCdataAndInstructions) {
  EXPECT_EQ(spans("<a><!-- <b/> --><![CDATA[<c>]]><?php <d/> ?><e/></a>"),
            (Texts{"<a><!-- <b/> --><![CDATA[<c>]]><?php <d/> ?><e/></a>", "<e/>"}));
}

TEST(XmlSpans, TellWhereInstructionsStand) {
  const std::vector<XmlSpan> instructions = scanXml("<?xml?><!-- <?no?> --><a><?p q?></a>").instructions;
  ASSERT_EQ(instructions.size(), 2u);
  EXPECT_EQ(instructions[0].end, 7u);
  EXPECT_EQ(instructions[1].begin, 25u);
  EXPECT_EQ(instructions[1].end, 32u);
}

TEST(XmlSpans, SkipPrologWithInternalSubset) {
  const std::string prolog = "\xEF\xBB\xBF<?xml version='1.0'?>\n<!-- <x/> -->\n<!DOCTYPE r [ <!ENTITY e \"]>\"> <!-- ' ]> --> ]>\n";
  EXPECT_EQ(spans(prolog + "<r/>\n<!-- end -->\n"), Texts{"<r/>"});
}

TEST(XmlSpans, KnowBothKindsOfQuotes) {
  EXPECT_EQ(spans("<a x='>\"' y=\"/>'\" ><b\tz = '1'\r\n/></a >"),
            (Texts{"<a x='>\"' y=\"/>'\" ><b\tz = '1'\r\n/></a >", "<b\tz = '1'\r\n/>"}));
}

TEST(XmlSpans, TellWhereTheStartTagEnds) {
  const std::vector<XmlElement> elements = scanXml("<a x='>'><b/></a>").elements;
  EXPECT_EQ(elements[0].tag_end, 9u);
  EXPECT_FALSE(elements[0].self_closing);
  EXPECT_EQ(elements[1].tag_end, 13u);
  EXPECT_TRUE(elements[1].self_closing);
}

TEST(XmlSpans, ChildrenAreNotDescendants) {
  const std::vector<XmlElement> elements = scanXml("<a><b><b/></b><n:b/><c><b/></c><b/></a>").elements;
  EXPECT_EQ(childrenNamed(elements, 0, "b"), (std::vector<std::size_t>{1, 6}));
  EXPECT_EQ(childrenNamed(elements, 2, "b"), std::vector<std::size_t>{});
}

TEST(XmlSpans, DeepNestingIsNoRecursion) {
  constexpr std::size_t kDepth = 200000;
  std::string text;
  for (std::size_t i = 0; i < kDepth; ++i) text += "<a>";
  for (std::size_t i = 0; i < kDepth; ++i) text += "</a>";
  EXPECT_EQ(scanXml(text).elements.size(), kDepth);
}

struct Malformed {
  const char* text;
  std::size_t offset;
  const char* reason;
};

class XmlSpansMalformed : public testing::TestWithParam<Malformed> {};

TEST_P(XmlSpansMalformed, SaysWhereAndWhy) {
  try {
    scanXml(GetParam().text);
    FAIL() << "accepted " << GetParam().text;
  } catch (const XmlSyntaxError& error) {
    EXPECT_EQ(error.offset(), GetParam().offset);
    EXPECT_NE(std::string(error.what()).find(GetParam().reason), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Texts, XmlSpansMalformed,
                         testing::Values(Malformed{"", 0, "it is empty"}, Malformed{" \n", 0, "it is empty"},
                                         Malformed{" <!-- -->", 0, "no element"}, Malformed{"solid stl", 0, "outside the root"},
                                         Malformed{"<a/> b", 5, "outside the root"}, Malformed{"<a/><b/>", 4, "second root element, <b>"},
                                         Malformed{"<a>", 0, "<a> is never closed"}, Malformed{"<a>\n<b></a>", 7, "<b> of line 2"},
                                         Malformed{"</a>", 0, "closes nothing"}, Malformed{"<a><", 3, "not followed by a name"},
                                         Malformed{"<a><1", 3, "never closed"}, Malformed{"<a b='1", 3, "quotes"},
                                         Malformed{"<a b=1>", 3, "not in quotes"}, Malformed{"<a b>", 3, "no value"},
                                         Malformed{"<a b='1' c='1' b='2'/>", 15, "attribute 'b' of <a> appears twice; remove one"},
                                         Malformed{"<a <b/>", 3, "no place"}, Malformed{"<a b='1'/", 8, "no place"},
                                         Malformed{"<a ", 0, "never closed"}, Malformed{"<a><!-- ", 3, "a comment is never closed"},
                                         Malformed{"<!-->", 0, "a comment"}, Malformed{"<a><![CDATA[ ]]", 3, "CDATA"},
                                         Malformed{"<?xml ", 0, "instruction"}, Malformed{"<!DOCTYPE a [ > ", 0, "document type"},
                                         Malformed{"<a></a", 3, "</a> is never closed"}));

TEST(XmlSpans, AttributeValues) {
  const std::string text = "<mesh  scale = '1 = 2'\n file=\"a\" filename=\"it's.stl\" empty=''/>";
  const XmlElement mesh = scanXml(text).elements.at(0);
  const auto value = [&](const char* name) -> std::optional<std::string> {
    const auto span = attributeValue(text, mesh, name);
    return span ? std::optional(text.substr(span->begin, span->end - span->begin)) : std::nullopt;
  };
  EXPECT_EQ(value("filename"), "it's.stl");
  EXPECT_EQ(value("scale"), "1 = 2");
  EXPECT_EQ(value("empty"), "");
  EXPECT_EQ(value("name"), std::nullopt);
}

TEST(XmlSpans, LinesCountFromOne) {
  EXPECT_EQ(lineOf("a\nb\r\nc", 0), 1u);
  EXPECT_EQ(lineOf("a\nb\r\nc", 2), 2u);
  EXPECT_EQ(lineOf("a\nb\r\nc", 5), 3u);
}

TEST(ScanXml, RefusesMoreAttributesThanAnyElementHas) {
  const auto withAttributes = [](int count) {
    std::string tag = "<robot>\n<link";
    for (int i = 0; i < count; ++i) tag += " a" + std::to_string(i) + "='x'";
    return tag + "/></robot>";
  };
  EXPECT_EQ(scanXml(withAttributes(1000)).elements.size(), 2u);
  EXPECT_THROW(scanXml(withAttributes(1001)), XmlSyntaxError);
}

}  // namespace
}  // namespace collision_hulls
