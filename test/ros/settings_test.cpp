#include "ros/preview/settings.h"

#include <gtest/gtest.h>

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
  options.source = Source::kVisual;
  const LinkOptions back = toOptions(toMessage("arm", options));
  EXPECT_EQ(options.action, back.action);
  EXPECT_EQ(options.tolerance.limit, back.tolerance.limit);
  EXPECT_EQ(options.tolerance.share, back.tolerance.share);
  EXPECT_EQ(options.effort, back.effort);
  EXPECT_TRUE(back.fill);
  EXPECT_EQ(3, back.max_hulls);
  EXPECT_EQ(32, back.max_vertices);
  EXPECT_EQ(0.005, back.padding);
  EXPECT_EQ(options.source, back.source);
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
