#include "config/link_rule.h"

#include <gtest/gtest.h>

#include "collision_hulls/config/link_decisions.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {
namespace {

/// What a rule alone makes of the links a.b and axb.
LinkOptions decided(const LinkRule& rule, const std::string& link) {
  Options options;
  options.rules = {rule};
  RobotDescription robot;
  robot.links.resize(2);
  robot.links[0].name = "a.b";
  robot.links[1].name = "axb";
  return *LinkDecisions(options, robot).of(link);
}

TEST(LinkRule, ANameIsNoExpression) {
  LinkOptions options;
  options.tolerance = lengthOf(0.002);
  const LinkRule rule = ruleFor("a.b", options);
  EXPECT_DOUBLE_EQ(0.002, decided(rule, "a.b").tolerance.limit);
  EXPECT_DOUBLE_EQ(0.01, decided(rule, "axb").tolerance.limit);
  EXPECT_EQ("a\\.b|c\\+", expressionFor({"a.b", "c+"}));
}

TEST(LinkRule, WhatDoesNotMatterIsLeftOut) {
  LinkOptions options;
  options.effort = Effort::kBest;
  options.method = Method::kBoundingBox;
  EXPECT_FALSE(ruleFor("a.b", options).settings.effort);
  EXPECT_EQ(Method::kBoundingBox, decided(ruleFor("a.b", options), "a.b").method);
  options.action = Action::kKeep;
  EXPECT_FALSE(ruleFor("a.b", options).settings.method);
  EXPECT_EQ(Action::kKeep, decided(ruleFor("a.b", options), "a.b").action);
}

TEST(LinkRule, OnlyWhatDiffersIsSaid) {
  LinkOptions options;
  EXPECT_FALSE(hasSettings(differingRuleFor("a.b", options, LinkOptions())));
  options.max_hulls = 3;
  const LinkRule rule = differingRuleFor("a.b", options, LinkOptions());
  EXPECT_TRUE(hasSettings(rule));
  EXPECT_EQ(3, rule.settings.max_hulls);
  EXPECT_FALSE(rule.settings.tolerance);
  options.action = Action::kRemove;
  EXPECT_EQ(Action::kRemove, differingRuleFor("a.b", options, LinkOptions()).settings.action);
}

}  // namespace
}  // namespace collision_hulls
