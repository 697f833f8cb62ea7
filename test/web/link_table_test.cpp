#include "web/link_table.h"

#include <gtest/gtest.h>

#include "web/pages.h"

namespace collision_hulls {
namespace {

using pages::count;
using pages::row;

TEST(LinkTable, WhatAsksForAttentionComesFirst) {
  ModelReport model;
  model.links = {row("fine"), row("wide", Status::kDegraded), row("left", Status::kKept), row("lost", Status::kFailed)};
  model.links[3].reason = "'lost.stl' ends after facet 3";
  const std::string table = linkTable(model);
  const std::size_t lost = table.find("data-row=\"3\""), wide = table.find("data-row=\"1\""), fine = table.find("data-row=\"0\""),
                    left = table.find("data-row=\"2\"");
  EXPECT_LT(lost, wide);
  EXPECT_LT(wide, fine);
  EXPECT_LT(fine, left);
  EXPECT_LT(left, std::string::npos);
  EXPECT_LT(table.find("&#39;lost.stl&#39; ends after facet 3"), wide) << "with its reason";
}

TEST(LinkTable, LengthsAreInMillimetres) {
  ModelReport model;
  model.links = {row("arm")};
  const std::string table = linkTable(model);
  EXPECT_NE(table.find(">9.80</td><td class=\"number\" data-value=\"9500.000000\">9.50</td>"), std::string::npos) << table;
  EXPECT_NE(table.find(">1,234</td>"), std::string::npos);
  EXPECT_EQ(count(table, "[mm]"), 3u);
}

TEST(LinkTable, WhatIsNotKnownIsNotShown) {
  ModelReport model;
  model.links = {row("lost", Status::kFailed)};
  EXPECT_EQ(count(linkTable(model), "data-value=\"-1\">\xE2\x80\x93<"), 5u);
}

TEST(LinkTable, RegionsStandBelowTheirRow) {
  ModelReport model;
  model.links = {row("hand")};
  model.links[0].regions_given = {halfSpaceRegion({0, 0, 1}, 0, 0.0001)};
  model.links[0].regions_given[0].name = "<mouth>";
  model.links[0].regions = {{0.00009, 0.00008}};
  EXPECT_NE(linkTable(model).find("<div>region &lt;mouth&gt;: protrusion 0.0900 mm, found 0.0800 mm, tolerance 0.100 mm</div>"),
            std::string::npos)
      << linkTable(model);
}

TEST(LinkTable, PrimitivesInPlaceOfHulls) {
  ModelReport model;
  model.links = {row("arm"), row("hand")};
  model.links[0].primitives = 2;
  model.links[1].primitives = 1;
  model.links[1].hulls = 0;
  const std::string table = linkTable(model);
  EXPECT_NE(table.find("data-value=\"4.000000\">2 + 2\xC2\xA0prim."), std::string::npos) << table;
  EXPECT_NE(table.find("data-value=\"1.000000\">1\xC2\xA0prim."), std::string::npos);
}

TEST(LinkTable, ForeignTextIsNoMarkup) {
  ModelReport model;
  model.links = {row("a\"><script>alert('1')</script>")};
  model.links[0].reason = "<img src=x>";
  model.links[0].uri = "package://x/\"'<b>.stl";
  const std::string table = linkTable(model);
  EXPECT_EQ(table.find("<script"), std::string::npos);
  EXPECT_EQ(table.find("<img"), std::string::npos);
  EXPECT_EQ(table.find("<b>"), std::string::npos);
  EXPECT_NE(table.find("title=\"package://x/&quot;&#39;&lt;b&gt;.stl\""), std::string::npos);
}

}  // namespace
}  // namespace collision_hulls
