#include "panel/link_table.h"

#include <gtest/gtest.h>

#include <fstream>

#include "collision_hulls/config/config.h"
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

class LinkTableTest : public testing::Test {
 protected:
  LinkTableTest() { table_.take(threeLinks()); }
  const LinkRow& at(int index) const { return table_.rows()[static_cast<std::size_t>(index)]; }

  LinkTable table_;
};

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

}  // namespace
}  // namespace collision_hulls
