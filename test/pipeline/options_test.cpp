#include "collision_hulls/pipeline/options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

template <typename F>
std::string badOption(F&& act) {
  try {
    act();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kBadOption);
    return e.what();
  }
  ADD_FAILURE() << "nothing thrown";
  return "";
}

TEST(ParseLength, Units) {
  const auto metres = [](const std::string& text) {
    const Length length = parseLength(text);
    EXPECT_FALSE(length.relative) << text;
    return length.value;
  };
  EXPECT_EQ(metres("0.005"), 0.005);
  EXPECT_EQ(metres("5mm"), 0.005);
  EXPECT_EQ(metres("0.5 cm"), 0.005);
  EXPECT_EQ(metres(" 5e-3m "), 0.005);
  EXPECT_EQ(metres("200um"), 0.0002);
  EXPECT_EQ(metres("10in"), 0.254);
  EXPECT_EQ(metres("2"), 2);
}

TEST(ParseLength, ShareOfTheDiagonal) {
  const Length length = parseLength("1%");
  EXPECT_TRUE(length.relative);
  EXPECT_EQ(length.value, 0.01);
  EXPECT_EQ(length.metres(3), 0.03);
  EXPECT_EQ(parseLength("5mm").metres(3), 0.005);
  EXPECT_EQ(parseLength("100 %").value, 1);
}

TEST(ParseLength, RefusesAndNamesTheValue) {
  for (const char* text :
       {"", "mm", "0", "-1mm", "5km", "5mm6", "5 mm 6", "nan", "inf", "1e400", "0%", "101%", "-1%", "1,5mm", "1e-400mm"}) {
    const std::string message = badOption([&] { parseLength(text); });
    EXPECT_NE(message.find("'" + std::string(text) + "'"), std::string::npos) << message;
    EXPECT_NE(message.find("5mm"), std::string::npos) << message;
  }
}

TEST(ParseLength, TextIsReadBack) {
  EXPECT_EQ(toString({0.01, true}), "1%");
  EXPECT_EQ(toString({0.005, false}), "0.005m");
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-9, 2);
  for (int i = 0; i < 1000; ++i) {
    const double value = std::pow(10, exponent(random));
    EXPECT_EQ(parseLength(toString({value, false})).value, value) << "seed 7, draw " << i;
  }
  for (const char* text : {"0.1%", "0.3%", "0.7%", "1.1%", "2.9%", "33.3%", "57%"}) EXPECT_EQ(toString(parseLength(text)), text);
}

TEST(CheckOptions, DefaultsAreInRange) {
  EXPECT_NO_THROW(check(Options{}));
}

TEST(CheckOptions, NamesOptionValueAndRange) {
  const auto message = [](const auto& change) {
    Options options;
    change(options);
    return badOption([&] { check(options); });
  };
  const auto has = [](const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has(message([](Options& o) { o.tolerance = {0, false}; }), "tolerance"));
  EXPECT_TRUE(has(message([](Options& o) { o.tolerance = {std::numeric_limits<double>::quiet_NaN(), false}; }), "tolerance"));
  EXPECT_TRUE(has(message([](Options& o) { o.tolerance = {1.5, true}; }), "150.0"));
  EXPECT_TRUE(has(message([](Options& o) { o.max_hulls = -1; }), "max-hulls '-1'"));
  EXPECT_TRUE(has(message([](Options& o) { o.max_vertices = 7; }), "from 8"));
  EXPECT_TRUE(has(message([](Options& o) { o.jobs = 100000; }), "jobs '100000'"));
  EXPECT_TRUE(has(message([](Options& o) { o.links = "(arm"; }), "links '(arm'"));
}

TEST(Profiles, SetCaps) {
  Options options;
  options.max_vertices = 0;
  options.max_hulls = 7;
  applyProfile("moveit", options);
  EXPECT_EQ(options.max_vertices, 64);
  EXPECT_EQ(options.max_hulls, 0);
  applyProfile("physx", options);
  EXPECT_EQ(options.max_vertices, 64);
  EXPECT_EQ(options.max_hulls, 64);
  EXPECT_NE(badOption([&] { applyProfile("havok", options); }).find("'havok'"), std::string::npos);
}

TEST(UriStyles, Names) {
  EXPECT_EQ(uriStyleNamed("package"), UriStyle::kPackage);
  EXPECT_EQ(uriStyleNamed("file"), UriStyle::kFile);
  EXPECT_EQ(uriStyleNamed("relative"), UriStyle::kRelative);
  EXPECT_FALSE(uriStyleNamed("http"));
}

}  // namespace
}  // namespace collision_hulls
