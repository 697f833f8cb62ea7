#include "mesh/formats/xml_tags.h"

#include <gtest/gtest.h>

#include <string>

namespace collision_hulls {
namespace {

/// "+a" for a tag that opens, "-a" for one that closes, "+-a" for one that does both.
std::string tags(std::string_view text) {
  std::string found;
  for (XmlTag tag; nextTag(&text, &tag);)
    found += std::string(tag.opens ? "+" : "") + (tag.closes ? "-" : "") + std::string(tag.name) + " ";
  return found;
}

TEST(XmlTags, InOrder) {
  EXPECT_EQ(tags("<a><b/>text</a>"), "+a +-b -a ");
}

TEST(XmlTags, NotInCommentsNorCdataNorDeclarations) {
  EXPECT_EQ(tags("<?xml version='1.0'?><!-- <x> --><a><![CDATA[<y>]]></a>"), "+a -a ");
}

TEST(XmlTags, AnIncompleteOneEndsTheText) {
  EXPECT_EQ(tags("<a><b"), "+a ");
  EXPECT_EQ(tags("<!-- never closed <a>"), "");
}

TEST(XmlTags, Attributes) {
  std::string_view text = "<unit meter=\"0.01\" name='centi > meter'/>";
  XmlTag tag;
  ASSERT_TRUE(nextTag(&text, &tag));
  EXPECT_EQ(tag.attribute("meter"), "0.01");
  EXPECT_EQ(tag.attribute("name"), "centi > meter");
  EXPECT_EQ(tag.attribute("metre"), "");
}

}  // namespace
}  // namespace collision_hulls
