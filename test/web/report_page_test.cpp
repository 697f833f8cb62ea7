// test/scripts/report_page opens pages in a browser. Also tests what cmake/web_page.cmake writes.
#include "web/report_page.h"

#include <gtest/gtest.h>

#include "web/page_files.h"
#include "web/pages.h"

namespace collision_hulls {
namespace {

using pages::count;
using pages::row;
using pages::Sample;

TEST(ReportPage, HasAllOfItsParts) {
  Sample sample;
  sample.report.notes = {"a folder stood in for a package"};
  const std::string page = reportPage(sample.content(), "");
  for (const char* part : {"<h1>robot</h1>", "2,468 triangles in 2 meshes", "id=\"slider\"", "data-row=\"1\"",
                           "a folder stood in for a package", "id=\"view-data\">{", "id=\"geometry\">AAAA", "robot.urdf"})
    EXPECT_EQ(count(page, part), 1u) << part;
}

TEST(ReportPage, StyleAndScriptAreThoseOfTheFolder) {
  const std::string page = reportPage(Sample().content(), "");
  EXPECT_NE(page.find(pageStyle()), std::string::npos);
  EXPECT_NE(page.find(pageScript()), std::string::npos);
  for (const char* part : {"function readData()", "class Camera", "class CanvasView", "class ThreeView", "class Page"})
    EXPECT_EQ(count(pageScript(), part), 1u) << part;
}

TEST(ReportPage, ScriptsEndWhereTheyShould) {
  const std::string hostile = "</script><script>alert('1')</script>\"'<!--";
  Sample sample({row(hostile), row("hand", Status::kFailed)});
  sample.report.links[0].uri = sample.report.links[1].reason = sample.report.input_path = hostile;
  sample.report.notes = sample.report.validation.remarks = {hostile};
  sample.report.model = hostile;
  FitReport fit;
  fit.scene = hostile;
  fit.links = {{hostile, 1, "", hostile, false}};
  sample.report.scene = fit;
  PageContent content = sample.content();
  content.title = hostile;
  content.models.push_back(content.models[0]);
  const std::string page = reportPage(content, "var THREE;");
  EXPECT_EQ(count(page, "</script"), 4u);
  EXPECT_EQ(count(page, "<script"), 4u);
  EXPECT_EQ(count(page, "<!--"), 0u);
  EXPECT_EQ(count(page, "alert('1')</"), 0u);
}

TEST(ReportPage, AsksTheNetworkForNothing) {
  const std::string page = reportPage(Sample().content(), "");
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  for (const char* part : {"src=\"", "href=\"", "@import", "url(", "fetch("}) EXPECT_EQ(count(page, part), 0u) << part;
}

TEST(ReportPage, TheSameBytesAgain) {
  const Sample sample;
  EXPECT_EQ(reportPage(sample.content(), "var THREE;"), reportPage(sample.content(), "var THREE;"));
}

TEST(ReportPage, ThreeJsComesWithItsLicence) {
  const Sample sample;
  EXPECT_EQ(count(reportPage(sample.content(), "var THREE;"), "Permission is hereby granted"), 1u);
  EXPECT_EQ(count(reportPage(sample.content(), ""), "Permission is hereby granted"), 0u);
}

TEST(ReportPage, TheFootersToleranceIsThatOfOtherLinksAndOfEachModel) {
  Sample sample;
  EXPECT_EQ(count(reportPage(sample.content(), ""), "<p>tolerance 1cm,5%, method"), 1u);
  LinkRule rule{"hand", {}, ""};
  rule.settings.method = Method::kHacd;
  sample.report.options.rules = {rule};
  EXPECT_EQ(count(reportPage(sample.content(), ""), "<p>tolerance 1cm,5%, method"), 1u);
  sample.report.options.rules[0].settings.tolerance = lengthOf(0.002);
  EXPECT_EQ(count(reportPage(sample.content(), ""), "<p>tolerance 1cm,5%; some links have their own, see the table, method"), 1u);
  sample.report.options.models = {{"planning", lengthOf(0.01)}, {"contact", lengthOf(0.001)}};
  EXPECT_EQ(count(reportPage(sample.content(), ""), "<p>tolerance planning 1cm, contact 1mm; some links"), 1u);
}

TEST(ReportPage, AChoiceOfSeveralModels) {
  Sample sample;
  EXPECT_EQ(count(reportPage(sample.content(), ""), "<select"), 0u);
  PageContent content = sample.content();
  content.models.push_back(content.models[0]);
  const std::string page = reportPage(content, "");
  EXPECT_EQ(count(page, "<option"), 2u);
  EXPECT_EQ(count(page, "id=\"model-1\" hidden"), 1u);
}

TEST(ReportPage, ACheckboxForRegions) {
  Sample sample;
  EXPECT_EQ(count(reportPage(sample.content(), ""), "id=\"show-regions\""), 0u);
  sample.report.links[1].regions_given = {halfSpaceRegion({0, 0, 1}, 0, 0.001)};
  EXPECT_EQ(count(reportPage(sample.content(), ""), "id=\"show-regions\""), 1u);
}

TEST(ReportPage, ASingleMeshIsNoRobot) {
  Sample sample({row("cup")});
  PageContent content = sample.content();
  content.single_mesh = true;
  EXPECT_EQ(count(reportPage(content, ""), "The robot is at rest"), 0u);
  EXPECT_EQ(count(reportPage(sample.content(), ""), "The robot is at rest"), 1u);
}

}  // namespace
}  // namespace collision_hulls
