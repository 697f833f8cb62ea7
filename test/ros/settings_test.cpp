#include "ros/preview/settings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

TEST(Settings, ComeBackAsTheyWere) {
  LinkOptions options;
  options.action = Action::kKeep;
  options.tolerance = {0.002, 0.03};
  options.effort = Effort::kBest;
  options.fill = true;
  options.max_hulls = 3;
  options.max_vertices = 32;
  options.padding = 0.005;
  options.close_openings = 0.05;
  options.source = Source::kVisual;
  options.regions = {boxRegion({0.1, 0.2, 0.3}, Eigen::Isometry3d(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized())), 0.002),
                     halfSpaceRegion({0, 0, -1}, 0.1, 0.001)};
  options.regions[0].name = "mouth";
  const LinkOptions back = toOptions(toMessage("arm", options));
  EXPECT_EQ(options.action, back.action);
  EXPECT_EQ(options.tolerance.limit, back.tolerance.limit);
  EXPECT_EQ(options.tolerance.share, back.tolerance.share);
  EXPECT_EQ(options.effort, back.effort);
  EXPECT_TRUE(back.fill);
  EXPECT_EQ(3, back.max_hulls);
  EXPECT_EQ(32, back.max_vertices);
  EXPECT_EQ(0.005, back.padding);
  EXPECT_EQ(0.05, back.close_openings);
  EXPECT_EQ(options.source, back.source);
  EXPECT_TRUE(equal(options.regions, back.regions)) << "to the last bit";
  EXPECT_EQ("mouth", back.regions[0].name);
}

TEST(Settings, EmptyTextsAreTheDefaults) {
  const LinkOptions options = toOptions(LinkChoice());
  EXPECT_EQ(Action::kDecompose, options.action);
  EXPECT_DOUBLE_EQ(0.01, options.tolerance.limit);
  EXPECT_EQ(Method::kCertified, options.method);
}

TEST(Settings, AnotherMethodHasNoEffort) {
  LinkChoice choice;
  choice.method = "hacd";
  choice.effort = "best";
  EXPECT_EQ(Effort::kQuick, toOptions(choice).effort);
}

TEST(Settings, AWrongValueIsNamedWithItsLink) {
  const auto message = [](void (*spoil)(LinkChoice&)) -> std::string {
    LinkChoice choice;
    choice.link = "arm";
    spoil(choice);
    try {
      toOptions(choice);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(std::string::npos, message([](LinkChoice& choice) { choice.method = "best"; }).find("link 'arm': method 'best'"));
  EXPECT_NE(std::string::npos, message([](LinkChoice& choice) { choice.tolerance = "seven"; }).find("link 'arm': tolerance 'seven'"));
  EXPECT_NE("", message([](LinkChoice& choice) { choice.max_vertices = 3; }));
  const auto region = [](LinkChoice& choice) -> LinkRegion& {
    choice.regions.resize(1);
    choice.regions[0].name = "mouth";
    choice.regions[0].sides = {0, 0, 1, 0};
    choice.regions[0].tolerance = 0.001;
    return choice.regions[0];
  };
  static const auto of = region;
  EXPECT_EQ("", message([](LinkChoice& choice) { of(choice); }));
  EXPECT_NE(std::string::npos,
            message([](LinkChoice& choice) { of(choice).sides.pop_back(); }).find("link 'arm': region 'mouth' has 3 numbers"));
  EXPECT_NE("", message([](LinkChoice& choice) { of(choice).sides[3] = NAN; }));
  EXPECT_NE("", message([](LinkChoice& choice) { of(choice).tolerance = 0; }));
}

TEST(Settings, ContradictionsNameTheLink) {
  LinkChoice choice;
  choice.link = "arm";
  choice.shapes = "spheres";
  choice.padding = "1cm";
  try {
    toOptions(choice);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("link 'arm': shapes 'spheres' contradicts padding '1cm'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace collision_hulls
