#include "config/parse_regions.h"

#include <gtest/gtest.h>

#include "collision_hulls/config/config.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

std::vector<RegionRule> regionsIn(const std::string& entries) {
  return parseConfig("regions:\n" + entries, "f.yaml").regions;
}

std::string refusal(const std::string& entry) {
  try {
    regionsIn("  - " + entry);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    return error.what();
  }
  return "accepted: " + entry;
}

TEST(ParseRegions, EverythingTheyMaySay) {
  const std::vector<RegionRule> rules = regionsIn(R"(
  - {link: hand, name: mouth, box: {center: [0, 0.5, 0.08], size: [0.08, 0.2, 0.03], rpy: [0, 0, 1.5]}, keep_clear: true}
  - {link: base.*, half_space: {normal: [0, 0, -2], offset: 0.1}, tolerance: 0}
  - {box: {size: [1, 2, 3]}, tolerance: 2mm}
)");
  ASSERT_EQ(rules.size(), 3u);
  EXPECT_EQ(rules[0].pattern, "hand");
  EXPECT_EQ(rules[0].name, "mouth");
  EXPECT_EQ(rules[0].place, "'f.yaml', line 3");
  EXPECT_EQ(rules[0].tolerance, kRegionSlack);
  const auto& box = std::get<RegionBox>(rules[0].shape);
  EXPECT_EQ(box.center, Eigen::Vector3d(0, 0.5, 0.08));
  EXPECT_EQ(box.size, Eigen::Vector3d(0.08, 0.2, 0.03));
  EXPECT_EQ(box.rpy, Eigen::Vector3d(0, 0, 1.5));
  const auto& half_space = std::get<RegionHalfSpace>(rules[1].shape);
  EXPECT_EQ(half_space.normal, Eigen::Vector3d(0, 0, -2));
  EXPECT_EQ(half_space.offset, 0.1);
  EXPECT_EQ(rules[1].tolerance, kRegionSlack) << "0 means clear";
  EXPECT_EQ(rules[1].name, "2");
  EXPECT_EQ(rules[2].pattern, "");
  EXPECT_EQ(rules[2].tolerance, 0.002);
  EXPECT_EQ(std::get<RegionBox>(rules[2].shape).center, Eigen::Vector3d(0, 0, 0));
}

TEST(ParseRegions, AreWrittenAsTheyWere) {
  Options options;
  options.region_rules = regionsIn(
      "  - {link: \"a|b\", box: {center: [0, 0.1, 1e-7], size: [0.3, 2, 3], rpy: [0, 0, 0.7]}, tolerance: 0.0031}\n"
      "  - {half_space: {normal: [0, 0.6, -0.8], offset: -0.25}, keep_clear: true}");
  const std::string text = configText(options);
  Options back;
  apply(parseConfig(text, "f.yaml"), back);
  EXPECT_EQ(configText(back), text);
  ASSERT_EQ(back.region_rules.size(), 2u);
  EXPECT_EQ(std::get<RegionBox>(back.region_rules[0].shape).center.z(), 1e-7);
  EXPECT_EQ(back.region_rules[0].tolerance, 0.0031);
  EXPECT_EQ(std::get<RegionHalfSpace>(back.region_rules[1].shape).normal.y(), 0.6);
  EXPECT_NE(configText(Options()).find("regions: []\n"), std::string::npos);
}

TEST(ParseRegions, EveryWayToGetThemWrong) {
  const std::string box = "box: {size: [1, 1, 1]}", clear = "keep_clear: true";
  struct Wrong {
    std::string entry;
    std::vector<const char*> parts;
  };
  const std::vector<Wrong> all = {
      {"mouth", {"line 2", "region 1 is 'mouth'", "use a map such as {link"}},
      {"{boxx: 1}", {"'boxx' is not known in region 1", "did you mean 'box'?"}},
      {"{" + clear + "}", {"neither box nor half_space"}},
      {"{" + box + "}", {"neither keep_clear: true nor tolerance"}},
      {"{" + box + ", half_space: {normal: [0, 0, 1]}, " + clear + "}", {"both box and half_space"}},
      {"{" + box + ", " + clear + ", tolerance: 1mm}", {"both keep_clear and tolerance"}},
      {"{" + box + ", keep_clear: false}", {"keep_clear of region 1 is 'false'", "a tolerance in its place"}},
      {"{" + box + ", keep_clear: yes}", {"keep_clear of region 1 is 'yes'", "true or false"}},
      {"{" + box + ", tolerance: 5%}", {"region 1: tolerance '5%' is invalid"}},
      {"{" + box + ", tolerance: -1mm}", {"region 1: tolerance '-1mm' is invalid"}},
      {"{" + box + ", tolerance: 2m}", {"line 2: region 1: tolerance '2m' is more than 1 m"}},
      {"{" + box + ", tolerance: 2}", {"line 2: region 1: tolerance '2' is more than 1 m", "did you mean 2mm?"}},
      {"{" + box + ", tolerance: [1]}", {"tolerance of region 1 is a list"}},
      {"{box: {center: [0, 0, 0]}, " + clear + "}", {"box of region 1 has no size", "size: ["}},
      {"{box: {size: [1, 1]}, " + clear + "}", {"size of box of region 1 has 2 entries: use a list of three numbers"}},
      {"{box: {size: [1, 1, big]}, " + clear + "}",
       {"line 2: region 1: an entry of its box's size is 'big': use a finite number of metres"}},
      {"{box: {size: [1, 1, 1], rpy: [0, 0, 90]}, " + clear + "}",
       {"line 2", "rpy of box of region 1 is [0, 0, 90], more than a whole turn: give radians"}},
      {"{box: {size: [1, 1, 1], rpy: [0, 0, up]}, " + clear + "}", {"is 'up': use a number of radians, as in 1.57"}},
      {"{box: {size: [1, 1, [1]]}, " + clear + "}", {"region 1: an entry of its box's size is a list"}},
      {"{box: {size: [1, -1, 1]}, " + clear + "}", {"line 2: region 1: a region's box has the size [1, -1, 1] m"}},
      {"{box: [1, 1, 1], " + clear + "}", {"box of region 1 is a list", "center"}},
      {"{half_space: {offset: 1}, " + clear + "}", {"half_space of region 1 has no normal"}},
      {"{half_space: {normal: [0, 0, up]}, " + clear + "}", {"region 1: an entry of its half-space's normal is 'up'"}},
      {"{half_space: {normal: [0, 0, 0]}, " + clear + "}", {"the normal needs a direction"}},
      {"{half_space: {normal: [0, 0, 1], offset: [1]}, " + clear + "}", {"line 2", "offset of half_space of region 1 is a list"}},
      {"{half_space: {normal: [0, 0, 1], offset: nan}, " + clear + "}",
       {"offset of half_space of region 1 is 'nan': use a finite number of metres, as in 0.1"}},
      {"{link: \"(\", " + box + ", " + clear + "}", {"line 2: region 1: its link '(' is invalid"}},
      {"{link: [a], " + box + ", " + clear + "}", {"link of region 1 is a list"}},
      {"{name: a, " + box + ", " + clear + "}\n  - {name: a, " + box + ", " + clear + "}", {"line 3", "'a'", "line 2", "rename"}},
      {"{name: \"2\", " + box + ", " + clear + "}\n  - {" + box + ", " + clear + "}", {"line 3", "'2'"}}};
  for (const Wrong& wrong : all) {
    const std::string message = refusal(wrong.entry);
    EXPECT_NE(message.find("'f.yaml', line"), std::string::npos) << message;
    for (const char* const part : wrong.parts) EXPECT_NE(message.find(part), std::string::npos) << message << "\nlacks: " << part;
  }
}

TEST(ParseRegions, AListOfAtMostAThousand) {
  std::string many;
  for (int i = 0; i < 1001; ++i) many += "  - {box: {size: [1, 1, 1]}, keep_clear: true}\n";
  try {
    regionsIn(many);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("there are 1001 regions; at most 1000"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace collision_hulls
