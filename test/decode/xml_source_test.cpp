#include "decode/xml_source.h"

#include <tinyxml2.h>

#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

XmlSource source(std::string_view text) {
  XmlSource result;
  result.text = text;
  result.label = "'arm.urdf'";
  return result;
}

TEST(LoadRoot, CountsLinesFromTheTopOfTheText) {
  XmlSource subject = source("<?xml version='1.0'?>\n<!-- a\ncomment -->\n<robot>\n  <link/>\n</robot>\n");
  tinyxml2::XMLDocument document;
  loadRoot(subject, document);
  ASSERT_STREQ(document.RootElement()->Name(), "robot");
  EXPECT_EQ(subject.root_line, 4u);
  EXPECT_EQ(subject.lineFromRoot(document.RootElement()->FirstChildElement()->GetLineNum()), 5u);
}

TEST(LoadRoot, RefusesWhatIsNotWellFormed) {
  for (const char* text : {"", "no xml", "<robot>", "<a></b>", "<a/><b/>"}) {
    XmlSource subject = source(text);
    tinyxml2::XMLDocument document;
    expectError(ErrorCode::kNotXml, {"arm.urdf"}, [&] { loadRoot(subject, document); });
  }
}

TEST(XmlSource, ErrorsNameTheLine) {
  expectError(ErrorCode::kNotARobot, {"'arm.urdf'", "line 3", "no links"}, [] { source("").failAt(ErrorCode::kNotARobot, 3, "no links"); });
}

}  // namespace
}  // namespace collision_hulls
