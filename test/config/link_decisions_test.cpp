#include "collision_hulls/config/link_decisions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "collision_hulls/config/config.h"
#include "collision_hulls/error.h"
#include "counted_looks.h"

namespace collision_hulls {
namespace {

RobotDescription robot() {
  RobotDescription robot;
  robot.name = "panda";
  for (const char* name : {"panda_link0", "panda_link1", "panda_hand", "left_finger", "camera_mount"}) {
    LinkDescription link;
    link.name = name;
    robot.links.push_back(link);
  }
  return robot;
}

Options optionsOf(const std::string& text) {
  Options options;
  apply(parseConfig(text, "f.yaml"), options);
  return options;
}

LinkDecisions decisions(const std::string& text) {
  return {optionsOf(text), robot()};
}

std::string refusal(const std::string& text) {
  try {
    decisions(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    return error.what();
  }
  return "accepted";
}

TEST(LinkDecisions, DefaultsWhereNothingElseIsSaid) {
  const LinkDecisions all = decisions("default: {tolerance: 2mm, max_vertices: 32}");
  for (const LinkDescription& link : robot().links) {
    EXPECT_EQ(all.of(link.name)->tolerance.limit, 0.002);
    EXPECT_EQ(all.of(link.name)->max_vertices, 32);
  }
  EXPECT_EQ(all.of("no such link"), nullptr);
}

TEST(LinkDecisions, TheLastMatchCountsFieldByField) {
  const LinkDecisions all = decisions(R"(
links:
  "panda_.*": {tolerance: 3cm, max_hulls: 2}
  "panda_hand|.*finger": {tolerance: 2mm}
  "panda_link1": {max_hulls: 7, source: visual}
)");
  EXPECT_EQ(all.of("panda_link0")->tolerance.limit, 0.03);
  EXPECT_EQ(all.of("panda_link0")->max_hulls, 2);
  EXPECT_EQ(all.of("panda_hand")->tolerance.limit, 0.002);
  EXPECT_EQ(all.of("panda_hand")->max_hulls, 2) << "from the first rule";
  EXPECT_EQ(all.of("left_finger")->max_hulls, 0);
  EXPECT_EQ(all.of("panda_link1")->max_hulls, 7);
  EXPECT_EQ(all.of("panda_link1")->tolerance.limit, 0.03);
  EXPECT_EQ(all.of("panda_link1")->source, Source::kVisual);
  EXPECT_EQ(all.of("camera_mount")->tolerance.limit, 0.01);
}

TEST(LinkDecisions, NamesAndExpressionsKeepTheirOrder) {
  const LinkDecisions all = decisions(R"(
links:
  "panda_hand": {max_hulls: 2, tolerance: 1mm}
  ".*": {max_hulls: 3}
  "panda_link0|panda_hand": {tolerance: 2mm}
  "panda_link.": {max_hulls: 4}
)");
  EXPECT_EQ(all.of("panda_hand")->max_hulls, 3);
  EXPECT_EQ(all.of("panda_hand")->tolerance.limit, 0.002);
  EXPECT_EQ(all.of("panda_link0")->max_hulls, 4);
  EXPECT_EQ(all.of("panda_link0")->tolerance.limit, 0.002);
}

/// A robot of many links, and a rule for each.
std::pair<RobotDescription, Options> manyRules(const std::string& suffix) {
  RobotDescription robot;
  Options options;
  for (int i = 0; i < 100; ++i) {
    LinkDescription link;
    link.name = "link" + std::to_string(i);
    robot.links.push_back(link);
    options.rules.push_back({link.name + suffix, {}, ""});
    options.rules.back().settings.max_hulls = i;
  }
  return {robot, options};
}

TEST(LinkDecisions, RulesForNamesAreLookedUp) {
  const auto [robot, options] = manyRules("|none");
  const CountedLooks looks;
  const LinkDecisions all(options, robot, looks.control());
  EXPECT_EQ(looks.count(), robot.links.size()) << "one for each link, whatever the number of rules";
  EXPECT_EQ(all.of("link99")->max_hulls, 99);
}

TEST(LinkDecisions, ACancelWaitsForOneExpression) {
  const auto [robot, options] = manyRules("[a-z]*");
  for (const std::size_t at : {5, 5'100, 12'000})
    EXPECT_EQ(looksAfterCancel(
                  at, [&, robot = &robot, options = &options](const RunControl& control) { modelDecisions(*options, *robot, control); }),
              1u);
}

TEST(LinkDecisions, NamesThatAreLongHaveNoSuggestion) {
  RobotDescription robot;
  robot.links.resize(1);
  robot.links.front().name = std::string(61, 'a');
  const auto message = [&](std::size_t length) {
    Options options;
    options.links = std::string(length, 'a');
    try {
      const LinkDecisions all(options, robot);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message(60).find("did you mean"), std::string::npos);
  EXPECT_NE(message(62).find("matches no link"), std::string::npos);
  EXPECT_EQ(message(62).find("did you mean"), std::string::npos);
}

TEST(LinkDecisions, ExpressionsMatchWholeNames) {
  const LinkDecisions all = decisions("links: {panda_link.: {tolerance: 1mm}, \"(left|right)_finger\": keep, \"(?!panda).*\": remove}");
  EXPECT_EQ(all.of("panda_link1")->tolerance.limit, 0.001);
  EXPECT_EQ(all.of("panda_hand")->tolerance.limit, 0.01);
  EXPECT_EQ(all.of("left_finger")->action, Action::kRemove) << "the last that matches";
  EXPECT_NE(refusal("links: {panda: keep}").find("matches no link"), std::string::npos);
}

TEST(LinkDecisions, ExceptionsFromABroaderRule) {
  const LinkDecisions all =
      decisions("links: {.*: {tolerance: 1mm}, panda_link0: keep, camera_.*: remove, camera_mount: {action: decompose}}");
  EXPECT_EQ(all.of("panda_link0")->action, Action::kKeep);
  EXPECT_EQ(all.of("camera_mount")->action, Action::kDecompose);
  EXPECT_EQ(all.of("camera_mount")->tolerance.limit, 0.001);
}

TEST(LinkDecisions, ContradictionsBetweenRules) {
  EXPECT_EQ(refusal("links:\n  panda_.*: keep\n  panda_link.: {tolerance: 1mm}"),
            "'f.yaml', line 3: tolerance of links 'panda_link.' holds for link 'panda_link0', which is kept by 'f.yaml', line 2: the last "
            "rule counts, so move that rule below this one, or add action: decompose here");
  EXPECT_NE(refusal("links: {.*mount: remove, .*: {max_hulls: 1}}").find("link 'camera_mount', which is removed by"), std::string::npos);
  EXPECT_NE(refusal("links:\n  panda_hand: {method: acd}\n  panda_.*: {effort: best}").find("which has method 'acd' from 'f.yaml', line 2"),
            std::string::npos);
  EXPECT_NE(refusal("default: {method: hacd}\nlinks: {panda_hand: {effort: instant}}").find("has method 'hacd', and only 'certified'"),
            std::string::npos);
  EXPECT_NE(refusal("default: {method: hacd}\nlinks: {panda_hand: {fill: true}}").find("which has method 'hacd', and only 'certified'"),
            std::string::npos);
  for (const char* const setting : {"fill: true", "padding: 3mm", "method: hacd"}) {
    const std::string message = refusal(std::string("default: {shapes: spheres}\nlinks:\n  panda_hand: {") + setting + "}");
    EXPECT_EQ(message.find("'f.yaml', line 3: link 'panda_hand': shapes 'spheres' contradicts"), 0u) << message;
  }
  EXPECT_EQ(refusal("links: {.*: {effort: best, fill: true}, panda_hand: {method: acd}}"), "accepted");
  EXPECT_EQ(refusal("default: {method: hacd}\nlinks: {panda_hand: {method: certified, fill: true}}"), "accepted");
}

TEST(LinkDecisions, AnExpressionThatMatchesNothing) {
  const std::string message = refusal("links:\n  camera_mount: keep\n  panda_hnad: keep");
  EXPECT_EQ(message,
            "'f.yaml', line 3: links 'panda_hnad' matches no link of robot 'panda' (the expression has to match the whole name). Its links "
            "are panda_link0, panda_link1, panda_hand, left_finger, camera_mount; did you mean 'panda_hand'?");
  EXPECT_NE(refusal("links: {camera_*: keep}").find("; did you mean 'camera_.*'?"), std::string::npos);
  EXPECT_NE(refusal("only: left_*").find("; did you mean 'left_.*'?"), std::string::npos);
  EXPECT_EQ(refusal("links: {camera_moun*t: keep}"), "accepted") << "a star that repeats a letter, and matches";
  EXPECT_EQ(refusal("only: nothing").substr(0, 54), "'f.yaml', line 1: only 'nothing' matches no link of ro");
  Options options;
  options.links = "nothing";
  EXPECT_THROW(LinkDecisions(options, robot()), Error);
}

TEST(LinkDecisions, OnlyLeavesTheOthersAlone) {
  const LinkDecisions all = decisions("only: panda_.*\nlinks: {.*: {tolerance: 1mm}, camera_mount: remove}");
  EXPECT_EQ(all.of("camera_mount"), nullptr);
  EXPECT_EQ(all.of("panda_hand")->tolerance.limit, 0.001);
}

TEST(LinkDecisions, WhatAMethodIgnoresHasItsDefault) {
  const LinkDecisions all = decisions(
      "default: {tree: 1mm, fill: true, effort: best, max_hulls: 9}\nlinks: {panda_hand: {method: hacd}, panda_link0: {method: "
      "single_hull}}");
  EXPECT_EQ(all.of("panda_link1")->effort, Effort::kBest);
  for (const char* link : {"panda_hand", "panda_link0"}) {
    EXPECT_EQ(all.of(link)->effort, Effort::kQuick);
    EXPECT_FALSE(all.of(link)->fill);
    EXPECT_FALSE(all.of(link)->tree);
  }
  EXPECT_EQ(all.of("panda_hand")->max_hulls, 9);
  EXPECT_EQ(all.of("panda_link0")->max_hulls, 0);
}

TEST(LinkDecisions, RegionsOfALink) {
  const LinkDecisions all = decisions(R"(
default: {tree: 1mm}
regions:
  - {link: "panda_hand|.*finger", name: mouth, box: {size: [1, 2, 3]}, keep_clear: true}
  - {link: panda_hand, half_space: {normal: [0, 0, 2], offset: 1}, tolerance: 5mm}
)");
  ASSERT_EQ(all.of("panda_hand")->regions.size(), 2u);
  EXPECT_EQ(all.of("panda_hand")->regions[0].name, "mouth");
  EXPECT_EQ(all.of("panda_hand")->regions[0].sides.size(), 6u);
  EXPECT_EQ(all.of("panda_hand")->regions[1].tolerance, 0.005);
  EXPECT_EQ(all.of("panda_hand")->regions[1].sides[0].offset, -0.5);
  EXPECT_EQ(all.of("left_finger")->regions.size(), 1u);
  EXPECT_TRUE(all.of("panda_link0")->regions.empty());
  EXPECT_TRUE(all.of("panda_link0")->tree);
  EXPECT_FALSE(all.of("panda_hand")->tree) << "a tree knows nothing of regions";
}

TEST(LinkDecisions, ARegionWithoutALinkIsProposedOneWithAMesh) {
  RobotDescription robot;
  robot.links.resize(3);
  for (std::size_t i = 0; i < 3; ++i) robot.links[i].name = std::string(1, static_cast<char>('a' + i));
  robot.links[1].collisions.resize(1);
  robot.links[1].collisions[0].kind = GeometryElement::Kind::kBox;
  robot.links[2].visuals.resize(1);
  robot.links[2].visuals[0].kind = GeometryElement::Kind::kMesh;
  Options options;
  options.region_rules.resize(1);
  options.region_rules[0].shape = RegionHalfSpace{{0, 0, 1}, 0};
  try {
    LinkDecisions(options, robot, {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("as in link: c"), std::string::npos) << error.what();
  }
}

TEST(LinkDecisions, RegionsThatCannotHold) {
  const std::string shape = ", box: {size: [1, 1, 1]}, keep_clear: true}";
  const auto expect = [&](const std::string& text, const std::vector<const char*>& parts) {
    const std::string message = refusal(text);
    for (const char* const part : parts) EXPECT_NE(message.find(part), std::string::npos) << message << "\nlacks: " << part;
  };
  expect("regions:\n  - {link: gripper" + shape, {"line 2", "region '1': its link 'gripper' matches no link of robot 'panda'"});
  expect("regions: [{name: a" + shape + "]", {"line 1", "region 'a' names no link of robot 'panda'", "link: panda_link0"});
  expect("links: {panda_hand: keep}\nregions:\n  - {link: panda_.*" + shape,
         {"line 3", "region '1' holds for link 'panda_hand', which is kept by 'f.yaml', line 1", "leave one of them out"});
  expect("default: {padding: 2cm}\nregions:\n  - {link: panda_hand" + shape, {"line 3", "whose hulls are padded by 2cm", "padding: 0"});
  expect("default: {shapes: box}\nregions:\n  - {link: panda_hand" + shape, {"line 3: link 'panda_hand': shapes 'box' contradicts region"});
  expect("links: {panda_hand: remove}\nregions:\n  - {link: panda_hand" + shape, {"which is removed by"});
}

TEST(LinkDecisions, RegionsAreCountedOnceForEachElement) {
  const Options options = optionsOf("regions: [{name: floor, link: .*, box: {size: [1, 1, 1]}, keep_clear: true}]");
  RobotDescription large = robot();
  large.links[0].visuals.resize(50'000), large.links[0].collisions.resize(49'996);
  EXPECT_EQ(LinkDecisions(options, large).of("camera_mount")->regions.size(), 1u) << "100,000 uses, with those of links without elements";
  large.links[0].visuals.emplace_back();
  try {
    LinkDecisions(options, large);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("region 'floor' of link 'camera_mount', regions are used 100001 times"), std::string::npos)
        << error.what();
  }
}

TEST(LinkDecisions, ARegionAsItsRuleSays) {
  RegionRule rule;
  rule.name = "r";
  rule.tolerance = 0.002;
  rule.shape = RegionBox{{1, 2, 3}, {2, 4, 6}, {0, 0, M_PI / 2}};  // turned by 90 degrees: 4 along x, 2 along y
  const Region region = regionOf(rule);
  const auto inside = [&](const Eigen::Vector3d& p) {
    return std::all_of(region.sides.begin(), region.sides.end(), [&](const HalfSpace& side) { return side.distance(p) < 0; });
  };
  EXPECT_EQ(region.name, "r");
  EXPECT_EQ(region.tolerance, 0.002);
  EXPECT_TRUE(inside({2.9, 2.9, 5.9}));
  EXPECT_FALSE(inside({3.1, 2, 3}));
  EXPECT_FALSE(inside({1, 3.1, 3}));
  EXPECT_FALSE(inside({1, 2, 6.1}));
}

TEST(LinkDecisions, KnowsTheFirstLinkOfAnotherMethod) {
  const LinkDecisions all = decisions("links:\n  camera_mount: {method: acd}\n  panda_hand: {method: bounding_box}");
  EXPECT_EQ(all.firstOfOtherMethod(), "panda_hand");
  EXPECT_EQ(all.otherMethodPlace(), "'f.yaml', line 3");
  EXPECT_EQ(decisions("").firstOfOtherMethod(), "");
  EXPECT_EQ(decisions("links: {panda_hand: {method: acd}, panda_.*: keep}").firstOfOtherMethod(), "") << "it is kept";
}

TEST(ModelDecisions, OneWithoutModels) {
  const std::vector<LinkDecisions> models = modelDecisions(optionsOf("default: {tolerance: 3mm}"), robot());
  ASSERT_EQ(models.size(), 1u);
  EXPECT_EQ(models[0].of("panda_hand")->tolerance.limit, 0.003);
  EXPECT_FALSE(models[0].of("panda_hand")->tree);
}

TEST(ModelDecisions, EachModelHasItsTolerance) {
  const std::vector<LinkDecisions> models =
      modelDecisions(optionsOf("models: {planning: \"1cm,5%\", contact: 2mm}\nlinks: {panda_hand: {tolerance: 1mm}}"), robot());
  ASSERT_EQ(models.size(), 2u);
  EXPECT_EQ(toString(models[0].of("panda_link1")->tolerance), "1cm,5%");
  EXPECT_EQ(toString(models[1].of("panda_link1")->tolerance), "2mm");
  for (const LinkDecisions& model : models) EXPECT_EQ(model.of("panda_hand")->tolerance.limit, 0.001) << "a rule holds in all models";
  const LinkDecisions first = firstModelDecisions(optionsOf("models: {planning: 5mm, contact: 2mm}"), robot());
  EXPECT_EQ(toString(first.of("panda_link1")->tolerance), "5mm");
}

}  // namespace
}  // namespace collision_hulls
