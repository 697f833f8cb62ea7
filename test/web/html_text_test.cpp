#include "web/html_text.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(EscapedHtml, NothingBecomesMarkup) {
  EXPECT_EQ(escapedHtml("</script><b onclick='x' id=\"y\">&amp;"),
            "&lt;/script&gt;&lt;b onclick=&#39;x&#39; id=&quot;y&quot;&gt;&amp;amp;");
}

TEST(EscapedHtml, KeepsOtherText) {
  EXPECT_EQ(escapedHtml("Gelenk \xC3\xA4, \t 5 \n"), "Gelenk \xC3\xA4, \t 5 \n");
  EXPECT_EQ(escapedHtml(""), "");
}

TEST(EscapedHtml, ForbiddenCharactersAreShownAsSuch) {
  EXPECT_EQ(escapedHtml(std::string("a\0b\x1b\x7f", 5)),
            "a\xEF\xBF\xBD"
            "b\xEF\xBF\xBD\xEF\xBF\xBD");
}

TEST(ScriptJson, CannotEndTheScript) {
  EXPECT_EQ(scriptJson(R"({"name":"</script><!--<script"})"), R"({"name":"\u003c/script>\u003c!--\u003cscript"})");
  EXPECT_EQ(scriptJson("{}"), "{}");
}

TEST(Grouped, Thousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(26202), "26,202");
  EXPECT_EQ(grouped(1234567), "1,234,567");
}

}  // namespace
}  // namespace collision_hulls
