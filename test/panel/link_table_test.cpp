#include "panel/link_table.h"

#include <gtest/gtest.h>

#include <fstream>

#include "collision_hulls/config/config.h"
#include "collision_hulls/config/link_decisions.h"
#include "collision_hulls/error.h"
#include "config/link_rule.h"
#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace {

LinkRow row(const std::string& link, std::size_t hulls, double protrusion) {
  LinkRow row;
  row.link = link;
  row.facts.status = "ok";
  row.facts.proved = true;
  row.facts.hulls = hulls;
  row.facts.vertices = 10 * hulls;
  row.facts.protrusion = protrusion;
  row.facts.steps = {0.001, 0.01};
  return row;
}

std::vector<LinkRow> threeLinks() {
  return {row("base", 3, 0.004), row("arm.left", 5, 0.009), row("hand", 1, 0.002)};
}

void setTolerance(LinkOptions& options) {
  options.tolerance = lengthOf(0.003);
}

RegionRule regionFor(const std::string& pattern, double offset = 0) {
  RegionRule region;
  region.pattern = pattern;
  region.shape = RegionHalfSpace{{0, 0, 1}, offset};
  return region;
}

class LinkTableTest : public testing::Test {
 protected:
  LinkTableTest() { table_.take(threeLinks()); }
  std::vector<int> add(const RegionRule& region) {
    return table_.changeRegions([&](std::vector<RegionRule>& all) { all.push_back(region); });
  }
  const LinkRow& at(int index) const { return table_.rows()[static_cast<std::size_t>(index)]; }
  /// A node's answer on a link, with the settings it has now.
  LinkRow cutOf(int index) const {
    LinkRow cut = row(at(index).link, 4, 0.003);
    cut.options = at(index).options;
    cut.facts.proved = false;
    return cut;
  }

  LinkTable table_;
};

TEST_F(LinkTableTest, PrimitivesAreCountedByThemselves) {
  std::vector<LinkRow> rows = threeLinks();
  rows[0].facts.primitives = 2;
  rows[2].facts.primitives = 4;
  table_.take(rows);
  EXPECT_EQ(9u, table_.totals().hulls);
  EXPECT_EQ(6u, table_.totals().primitives);
}

TEST_F(LinkTableTest, TotalsAreSumsAndTheLargestProtrusion) {
  const TableTotals totals = table_.totals();
  EXPECT_EQ(3u, totals.links);
  EXPECT_EQ(9u, totals.hulls);
  EXPECT_EQ(90u, totals.vertices);
  EXPECT_DOUBLE_EQ(0.009, totals.protrusion);
  EXPECT_EQ("arm.left", totals.worst_link);
  EXPECT_EQ(0u, totals.unbuilt);
  EXPECT_EQ(0u, LinkTable().totals().links);
}

TEST_F(LinkTableTest, AChangeLeavesItsLinkUnbuiltWithItsSteps) {
  table_.change({1}, setTolerance);
  EXPECT_EQ("unbuilt", at(1).facts.status);
  EXPECT_EQ(0u, at(1).facts.hulls);
  EXPECT_EQ(2u, at(1).facts.steps.size());
  EXPECT_EQ("ok", at(0).facts.status);
  EXPECT_EQ(1u, table_.totals().unbuilt);
}

TEST_F(LinkTableTest, ASettingThatStaysTheSameLeavesTheHulls) {
  table_.change({1}, [](LinkOptions& options) { options.max_hulls = 0; });
  EXPECT_EQ(5u, at(1).facts.hulls);
}

TEST_F(LinkTableTest, OtherMethodsHaveNoEffort) {
  table_.change({0}, [](LinkOptions& options) { options.effort = Effort::kBest; });
  table_.change({0}, [](LinkOptions& options) { options.method = Method::kHacd; });
  EXPECT_EQ(Effort::kQuick, at(0).options.effort);
}

TEST_F(LinkTableTest, ClosedOpeningsLeaveALinkUnbuiltAndAreSavedAndUndone) {
  table_.change({2}, [](LinkOptions& options) { options.close_openings = 0.05; });
  EXPECT_EQ("unbuilt", at(2).facts.status);
  const Config config = parseConfig(table_.configuration({}), "saved");
  ASSERT_EQ(1u, config.rules.size());
  EXPECT_EQ(0.05, config.rules[0].settings.close_openings);
  table_.undo();
  EXPECT_EQ(0, at(2).options.close_openings);
}

TEST_F(LinkTableTest, AnAnswerToEarlierSettingsComesTooLate) {
  LinkRow answer = row("hand", 7, 0.001);
  table_.change({2}, setTolerance);
  EXPECT_FALSE(table_.answer(answer));
  EXPECT_EQ(0u, at(2).facts.hulls);
  setTolerance(answer.options);
  EXPECT_TRUE(table_.answer(answer));
  EXPECT_EQ(7u, at(2).facts.hulls);
}

TEST_F(LinkTableTest, AnAnswerOnAnUnknownLinkIsNone) {
  EXPECT_FALSE(table_.answer(row("tail", 7, 0.001)));
}

TEST_F(LinkTableTest, WhatIsNotBuiltYetOffersTheStepsItDid) {
  LinkRow answer = row("hand", 0, 0);
  answer.facts.status = "unbuilt";
  answer.facts.steps.clear();
  EXPECT_TRUE(table_.answer(answer));
  EXPECT_EQ(2u, at(2).facts.steps.size());
}

TEST_F(LinkTableTest, NewsFromTheNodeKeepWhatIsNotBuiltYet) {
  table_.change({1}, setTolerance);
  table_.take(threeLinks());
  EXPECT_DOUBLE_EQ(0.003, at(1).options.tolerance.limit);
  EXPECT_EQ("unbuilt", at(1).facts.status);
  EXPECT_EQ(3u, at(0).facts.hulls);
}

TEST_F(LinkTableTest, NewsFromTheNodeKeepWhatIsOnlyCut) {
  table_.change({1}, setTolerance);
  ASSERT_TRUE(table_.answer(cutOf(1)));
  table_.take(threeLinks());
  EXPECT_DOUBLE_EQ(0.003, at(1).options.tolerance.limit);
  std::vector<LinkRow> rows = threeLinks();
  rows[1] = cutOf(1);
  table_.take(rows);  // the node knows the cut, too, and has still not built it
  table_.take(threeLinks());
  EXPECT_DOUBLE_EQ(0.003, at(1).options.tolerance.limit);
}

TEST_F(LinkTableTest, NewsFromTheNodeKeepWhatWasUndone) {
  std::vector<LinkRow> built = threeLinks();
  setTolerance(built[1].options);
  table_.change({1}, setTolerance);
  table_.undo();
  ASSERT_TRUE(table_.answer(cutOf(1)));
  table_.take(built);
  EXPECT_DOUBLE_EQ(0.01, at(1).options.tolerance.limit);
}

TEST_F(LinkTableTest, OnceBuiltALinkFollowsTheNode) {
  std::vector<LinkRow> built = threeLinks();
  setTolerance(built[1].options);
  table_.change({1}, setTolerance);
  table_.take(built);
  EXPECT_EQ("ok", at(1).facts.status);
  table_.take(threeLinks());
  EXPECT_DOUBLE_EQ(0.01, at(1).options.tolerance.limit);
}

TEST_F(LinkTableTest, AnotherRobotReplacesAllAndNothingCanBeUndone) {
  table_.change({1}, setTolerance);
  table_.take({row("arm.left", 2, 0.001)});
  EXPECT_EQ(2u, at(0).facts.hulls);
  EXPECT_FALSE(table_.canUndo());
}

TEST_F(LinkTableTest, UndoTakesOneChangeBackAfterTheOther) {
  table_.change({0, 1}, setTolerance);
  table_.change({1}, [](LinkOptions& options) { options.action = Action::kKeep; });
  EXPECT_EQ(std::vector<int>{1}, table_.undo());
  EXPECT_EQ(Action::kDecompose, at(1).options.action);
  EXPECT_DOUBLE_EQ(0.003, at(1).options.tolerance.limit);
  EXPECT_EQ((std::vector<int>{0, 1}), table_.undo());
  EXPECT_DOUBLE_EQ(0.01, at(0).options.tolerance.limit);
  EXPECT_FALSE(table_.canUndo());
  EXPECT_TRUE(table_.undo().empty());
}

TEST_F(LinkTableTest, AWholeMoveOfTheSliderIsUndoneAtOnce) {
  table_.change({0}, setTolerance);
  table_.change(
      {0}, [](LinkOptions& options) { options.tolerance = lengthOf(0.005); }, true);
  table_.undo();
  EXPECT_DOUBLE_EQ(0.01, at(0).options.tolerance.limit);
}

TEST_F(LinkTableTest, TheConfigurationHasOnlyWhatDiffersFromTheDefaults) {
  table_.change({1}, setTolerance);
  table_.change({2}, [](LinkOptions& options) { options.action = Action::kKeep; });
  const Config config = parseConfig(table_.configuration(lengthOf(0.001)), "saved");
  ASSERT_EQ(2u, config.rules.size());
  EXPECT_EQ("arm\\.left", config.rules[0].pattern);  // not every link with some character there
  EXPECT_DOUBLE_EQ(0.003, config.rules[0].settings.tolerance->limit);
  EXPECT_FALSE(config.rules[0].settings.max_hulls);
  EXPECT_EQ(Action::kKeep, config.rules[1].settings.action);
  EXPECT_DOUBLE_EQ(0.001, (*config.tree)->limit);
}

TEST_F(LinkTableTest, ALoadedConfigurationBringsTheSettingsBack) {
  table_.change({0}, setTolerance);
  table_.change({1}, [](LinkOptions& options) { options.method = Method::kBoundingBox; });
  table_.change({2}, [](LinkOptions& options) { options.action = Action::kRemove; });
  const fixtures::TempFolder folder;
  const std::string file = fixtures::write(folder / "saved.yaml", table_.configuration(lengthOf(0.001)));
  LinkTable other;
  other.take(threeLinks());
  const std::optional<Length> tree = other.load(file);
  ASSERT_TRUE(tree);
  EXPECT_DOUBLE_EQ(0.001, tree->limit);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(equalSettings(at(i).options, other.rows()[static_cast<std::size_t>(i)].options)) << i;
  EXPECT_EQ(3u, other.totals().unbuilt);
  EXPECT_EQ(3u, other.undo().size());
}

TEST_F(LinkTableTest, ABadConfigurationChangesNothing) {
  EXPECT_THROW(table_.loadText("links: {tail: keep}", "bad.yaml"), Error);
  EXPECT_THROW(table_.loadText("links: {base: keep", "bad.yaml"), Error);
  EXPECT_EQ(9u, table_.totals().hulls);
  EXPECT_FALSE(table_.canUndo());
}

TEST_F(LinkTableTest, LinksThatTheConfigurationLeavesAloneStay) {
  table_.loadText("default: {tolerance: 2mm, tree: 1mm}\nonly: hand", "some.yaml");
  EXPECT_DOUBLE_EQ(0.002, at(2).options.tolerance.limit);
  EXPECT_EQ("ok", at(0).facts.status);
}

TEST_F(LinkTableTest, ARegionLeavesTheLinksItHoldsForUnbuilt) {
  EXPECT_EQ((std::vector<int>{0, 2}), add(regionFor("base|hand")));
  EXPECT_EQ("unbuilt", at(0).facts.status);
  EXPECT_EQ("ok", at(1).facts.status);
  EXPECT_EQ(1u, at(2).options.regions.size());
  EXPECT_EQ(std::vector<int>{0}, table_.regionsOf("hand"));
  EXPECT_TRUE(table_.regionsOf("arm.left").empty());
  EXPECT_EQ((std::vector<int>{0, 2}), table_.linksOf(table_.regions()[0]));
}

TEST_F(LinkTableTest, AnAnswerWithOtherRegionsComesTooLate) {
  add(regionFor("hand"));
  LinkRow answer = row("hand", 7, 0.001);
  EXPECT_FALSE(table_.answer(answer));
  answer.options.regions = at(2).options.regions;
  EXPECT_TRUE(table_.answer(answer));
  EXPECT_EQ(7u, at(2).facts.hulls);
}

TEST_F(LinkTableTest, RegionsAreNamedByFreeNumbers) {
  RegionRule named = regionFor("hand");
  named.name = "2";
  add(named);
  add(regionFor("hand", 0.1));
  add(regionFor("hand", 0.2));
  EXPECT_EQ("1", table_.regions()[1].name);
  EXPECT_EQ("3", table_.regions()[2].name);
}

TEST_F(LinkTableTest, AWrongRegionChangesNothing) {
  add(regionFor("hand"));
  RegionRule flat = regionFor("base");
  flat.shape = RegionBox{};
  EXPECT_THROW(add(flat), Error);
  RegionRule same_name = regionFor("base");
  same_name.name = "1";
  EXPECT_THROW(add(same_name), Error);
  EXPECT_EQ(1u, table_.regions().size());
  EXPECT_EQ("ok", at(0).facts.status);
}

TEST_F(LinkTableTest, ANewNameLeavesTheHulls) {
  add(regionFor("hand"));
  LinkRow answer = row("hand", 7, 0.001);
  answer.options.regions = at(2).options.regions;
  table_.answer(answer);
  EXPECT_TRUE(table_.changeRegions([](std::vector<RegionRule>& all) { all[0].name = "mouth"; }).empty());
  EXPECT_EQ(7u, at(2).facts.hulls);
  EXPECT_NE(std::string::npos, table_.configuration({}).find("mouth"));
}

TEST_F(LinkTableTest, UndoTakesRegionsBackAndAWholeDragAtOnce) {
  add(regionFor("hand"));
  for (const double offset : {0.1, 0.2})
    table_.changeRegions([&](std::vector<RegionRule>& all) { all[0].shape = RegionHalfSpace{{0, 0, 1}, offset}; }, offset > 0.15);
  EXPECT_EQ(std::vector<int>{2}, table_.undo());
  EXPECT_EQ(0, std::get<RegionHalfSpace>(table_.regions()[0].shape).offset);
  EXPECT_EQ(std::vector<int>{2}, table_.undo());
  EXPECT_TRUE(table_.regions().empty());
  EXPECT_TRUE(at(2).options.regions.empty());
  EXPECT_FALSE(table_.canUndo());
}

TEST_F(LinkTableTest, TheNodesRegionsCountUntilOwnOnesDo) {
  std::vector<LinkRow> rows = threeLinks();
  rows[2].options.regions = {regionOf(regionFor("hand", 0.1))};
  table_.take(rows, {regionFor("hand", 0.1)});
  EXPECT_EQ("ok", at(2).facts.status);
  table_.changeRegions([](std::vector<RegionRule>& all) { all.clear(); });
  EXPECT_EQ("unbuilt", at(2).facts.status);
  table_.take(rows, {regionFor("hand", 0.1)});
  EXPECT_TRUE(table_.regions().empty());
  EXPECT_EQ("unbuilt", at(2).facts.status);
  table_.take(threeLinks());
  EXPECT_EQ("ok", at(2).facts.status) << "built without the region";
}

TEST_F(LinkTableTest, RegionsAreSavedAndLoaded) {
  RegionRule box = regionFor("hand");
  box.shape = RegionBox{{0, 0, 0.08}, {0.08, 0.2, 0.03}, {0, 0.5, 0}};
  box.tolerance = 0.002;
  add(box);
  add(regionFor("base", 0.01));
  LinkTable other;
  other.take(threeLinks());
  other.loadText(table_.configuration({}), "saved");
  ASSERT_EQ(2u, other.regions().size());
  EXPECT_EQ(Eigen::Vector3d(0, 0.5, 0), std::get<RegionBox>(other.regions()[0].shape).rpy);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(equalSettings(at(i).options, other.rows()[static_cast<std::size_t>(i)].options)) << i;
  EXPECT_EQ(2u, other.totals().unbuilt);
}

TEST_F(LinkTableTest, WhatIsNotBuiltYetIsWhereItWas) {
  std::vector<LinkRow> rows = threeLinks();
  rows[2].facts.around.extend(Eigen::Vector3d(1, 2, 3));
  table_.take(rows);
  add(regionFor("hand"));
  EXPECT_FALSE(at(2).facts.around.isEmpty());
  LinkRow answer = row("hand", 0, 0);
  answer.options = at(2).options;
  answer.facts.status = "unbuilt";
  table_.answer(answer);
  EXPECT_FALSE(at(2).facts.around.isEmpty());
}

}  // namespace
}  // namespace collision_hulls
