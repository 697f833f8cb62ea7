#include "collision_hulls/report/options.h"

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
    EXPECT_EQ(length.share, Length::kUnset) << text;
    EXPECT_EQ(length.limit, parseMetres(text, "clearance")) << text;
    return length.limit;
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
  EXPECT_EQ(length.limit, Length::kUnset);
  EXPECT_EQ(length.share, 0.01);
  EXPECT_EQ(length.metres(3), 0.03);
  EXPECT_EQ(length.metres(0), 0);
  EXPECT_EQ(parseLength("5mm").metres(3), 0.005);
  EXPECT_EQ(parseLength("5mm").metres(0), 0.005);
  EXPECT_EQ(parseLength("100 %").share, 1);
}

TEST(ParseLength, SmallerOfALengthAndAShare) {
  for (const char* text : {"1cm,5%", "5%,1cm", " 10 mm , 5 % "}) {
    const Length length = parseLength(text);
    EXPECT_EQ(length.limit, 0.01) << text;
    EXPECT_EQ(length.share, 0.05) << text;
    EXPECT_DOUBLE_EQ(length.metres(0.1), 0.005) << text;
    EXPECT_EQ(length.metres(0.2), 0.01) << text;
    EXPECT_EQ(length.metres(3), 0.01) << text;
    EXPECT_EQ(length.metres(0), 0) << text;
  }
}

TEST(ParseLength, RefusesAndNamesTheValue) {
  for (const char* text : {"",      "mm", "0",       "-1mm",  "5km",    "5mm6",     "5 mm 6", "nan",    "inf",
                           "1e400", "0%", "101%",    "-1%",   "1,5mm",  "1e-400mm", "1,5%",   "5%,1",   "1cm,",
                           ",5%",   ",",  "1cm,2mm", "5%,1%", "1cm,0%", "1cm,101%", "0cm,5%", "1cm;5%", "1cm,5%,2%"}) {
    const std::string message = badOption([&] { parseLength(text); });
    EXPECT_NE(message.find("'" + std::string(text) + "'"), std::string::npos) << message;
    EXPECT_NE(message.find("5mm"), std::string::npos) << message;
    EXPECT_NE(message.find("1cm,5%"), std::string::npos) << message;
  }
}

TEST(ParseMetres, RefusesSharesAndPairs) {
  for (const char* text : {"5%", "1cm,5%", "5%,1cm", "0", "-1cm", "clear", ""}) {
    const std::string message = badOption([&] { parseMetres(text, "--clearance"); });
    EXPECT_EQ(message.rfind("--clearance '" + std::string(text) + "'", 0), 0u) << message;
  }
}

TEST(ParseLength, TextIsReadBack) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-9, 2);
  for (int i = 0; i < 1000; ++i) {
    const double value = std::pow(10, exponent(random));
    EXPECT_EQ(parseLength(toString(lengthOf(value))).limit, value) << "seed 7, draw " << i;
    const double share = std::min(value, 1.0);
    EXPECT_EQ(parseLength(toString({value, share})).limit, value) << "seed 7, draw " << i;
    EXPECT_EQ(parseLength(toString({value, share})).share, share) << "seed 7, draw " << i;
  }
  for (int thousandths = 1; thousandths <= 1000; ++thousandths) {
    const double share = thousandths / 1000.0;
    EXPECT_EQ(parseLength(toString(shareOf(share))).share, share) << share;
    EXPECT_LE(toString(shareOf(share)).size(), 5u) << toString(shareOf(share));
  }
  for (const char* text : {"0.1%", "0.3%", "0.7%", "1.1%", "2.9%", "33.3%", "57%", "1cm,5%", "5mm", "2.5mm,0.3%", "20m"})
    EXPECT_EQ(toString(parseLength(text)), text);
}

TEST(ParseLength, APercentageIsRoundedOnce) {
  EXPECT_EQ(parseLength("0.7%").share, 0.007);
  EXPECT_EQ(parseLength("7e-1 %").share, 0.007);
  EXPECT_EQ(parseLength("0.07e+1%").share, 0.007);
  EXPECT_EQ(parseLength("1e2%").share, 1);
}

TEST(ParseLength, TextIsShort) {
  EXPECT_EQ(toString(shareOf(0.01)), "1%");
  EXPECT_EQ(toString(lengthOf(0.005)), "5mm");
  EXPECT_EQ(toString(lengthOf(0.254)), "254mm");
  EXPECT_EQ(toString(parseLength("5%,10mm")), "1cm,5%");
  EXPECT_EQ(toString(Options{}.tolerance), "1cm,5%");
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
  EXPECT_TRUE(has(message([](Options& o) { o.tolerance = lengthOf(0); }), "tolerance '0m'"));
  EXPECT_TRUE(has(message([](Options& o) { o.tolerance = lengthOf(std::numeric_limits<double>::quiet_NaN()); }), "tolerance"));
  EXPECT_TRUE(has(message([](Options& o) { o.tolerance = shareOf(1.5); }), "tolerance '150%'"));
  EXPECT_TRUE(has(message([](Options& o) { o.tolerance = {0.01, 0}; }), "tolerance '0%'"));
  EXPECT_TRUE(has(message([](Options& o) { o.tolerance = {}; }), "tolerance 'inf'"));
  EXPECT_TRUE(has(message([](Options& o) { o.max_hulls = -1; }), "max-hulls '-1'"));
  EXPECT_TRUE(has(message([](Options& o) { o.max_vertices = 7; }), "from 8"));
  EXPECT_TRUE(has(message([](Options& o) { o.jobs = 100000; }), "jobs '100000'"));
  EXPECT_TRUE(has(message([](Options& o) { o.links = "(arm"; }), "links '(arm'"));
  EXPECT_TRUE(has(message([](Options& o) { o.scale = 0; }), "scale '0'"));
  EXPECT_TRUE(has(message([](Options& o) { o.scale = std::numeric_limits<double>::infinity(); }), "scale 'inf'"));
}

TEST(CheckOptions, TreeIsFinerForSomeMesh) {
  const auto with = [](const char* tolerance, const char* tree) {
    Options options;
    options.tolerance = parseLength(tolerance);
    options.tree = parseLength(tree);
    return options;
  };
  for (const char* tree : {"1cm,5%", "5mm", "2%", "5mm,2%", "2cm,2%", "5mm,10%"}) EXPECT_NO_THROW(check(with("1cm,5%", tree))) << tree;
  EXPECT_NO_THROW(check(with("1cm", "5%")));
  EXPECT_NO_THROW(check(with("5%", "1cm")));
  EXPECT_NO_THROW(check(with("1cm", "1cm,5%")));
  const auto refused = [&](const char* tolerance, const char* tree) {
    const std::string message = badOption([&] { check(with(tolerance, tree)); });
    EXPECT_NE(message.find("tree '" + std::string(tree) + "'"), std::string::npos) << message;
    EXPECT_NE(message.find(tolerance), std::string::npos) << message;
  };
  refused("1cm,5%", "2cm,10%");
  refused("1cm,5%", "10%");
  refused("1cm,5%", "2cm");
  refused("1%", "2%");
  refused("1cm", "2cm");
}

TEST(CheckOptions, MetresThatWereMeantAsMillimetres) {
  Options options;
  options.tolerance = parseLength("1m");
  EXPECT_NO_THROW(check(options));
  options.tolerance = parseLength("5");
  EXPECT_NE(badOption([&] { check(options); }).find("tolerance '5m' is more than 1 m"), std::string::npos);
  EXPECT_NE(badOption([&] { check(options); }).find("did you mean 5mm?"), std::string::npos);
  options.tolerance = parseLength("20m,5%");
  EXPECT_NE(badOption([&] { check(options); }).find("did you mean 2cm?"), std::string::npos);
  options.tolerance = parseLength("100%");
  options.tree = parseLength("2");
  EXPECT_NE(badOption([&] { check(options); }).find("tree '2m'"), std::string::npos);
}

TEST(ParseTolerance, QuotesWhatWasTyped) {
  EXPECT_EQ(parseTolerance("100cm").limit, 1);
  EXPECT_EQ(parseTolerance("1%").share, 0.01);
  const auto refused = [](const std::string& text) { return badOption([&] { parseTolerance(text); }); };
  EXPECT_EQ(refused("5").rfind("tolerance '5' is more than 1 m", 0), 0u) << refused("5");
  EXPECT_NE(refused("5").find(": a number without a unit is in metres; did you mean 5mm?"), std::string::npos) << refused("5");
  EXPECT_NE(refused("5m").find("a mesh; did you mean 5mm?"), std::string::npos) << refused("5m");
  EXPECT_NE(badOption([] { parsePadding("2", "padding"); }).find("padding '2' is more than 1 m"), std::string::npos);
}

TEST(Profiles, SetBothCaps) {
  struct {
    const char* profile;
    int max_hulls, max_vertices;
  } const expected[] = {{"fcl", 0, 32}, {"moveit", 0, 42}, {"bullet", 0, 42}, {"physx", 0, 32}, {"gazebo", 16, 64}};
  for (const auto& caps : expected) {
    Options options;
    options.max_vertices = 100;
    options.max_hulls = 7;
    applyProfile(caps.profile, options);
    EXPECT_EQ(options.max_hulls, caps.max_hulls) << caps.profile;
    EXPECT_EQ(options.max_vertices, caps.max_vertices) << caps.profile;
    EXPECT_NO_THROW(check(options)) << caps.profile;
    const bool as_default = options.max_hulls == Options{}.max_hulls && options.max_vertices == Options{}.max_vertices;
    EXPECT_FALSE(as_default) << caps.profile << " changes nothing";
  }
}

TEST(Profiles, UnknownOneIsNamed) {
  Options options;
  const std::string message = badOption([&] { applyProfile("havok", options); });
  for (const char* part : {"'havok'", "fcl", "moveit", "bullet", "physx", "gazebo"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(UriStyles, Names) {
  EXPECT_EQ(uriStyleNamed("package"), UriStyle::kPackage);
  EXPECT_EQ(uriStyleNamed("file"), UriStyle::kFile);
  EXPECT_EQ(uriStyleNamed("relative"), UriStyle::kRelative);
  EXPECT_FALSE(uriStyleNamed("http"));
}

TEST(ParseSeconds, Units) {
  const std::pair<const char*, double> times[] = {{"5s", 5}, {"5", 5}, {"500ms", 0.5}, {"2min", 120}, {"1.5 h", 5400}, {"0", 0}};
  for (const auto& [text, seconds] : times) EXPECT_DOUBLE_EQ(parseSeconds(text, "--time-limit"), seconds) << text;
  for (const char* wrong : {"", "s", "-1s", "5m", "5s later", "inf", "nan", "1e400s"})
    EXPECT_NE(badOption([&] { parseSeconds(wrong, "--time-limit"); }).find("--time-limit '" + std::string(wrong) + "'"), std::string::npos)
        << wrong;
}

TEST(CheckOptions, TimeLimitIsRefusedWhereItWouldBeIgnored) {
  const auto message = [](const auto& change) {
    Options options;
    options.time_limit = 5;
    change(options);
    return badOption([&] { check(options); });
  };
  EXPECT_NE(message([](Options& o) { o.method = Method::kHacd; }).find("time-limit '5 s' contradicts method 'hacd'"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.tree = parseLength("1mm"); }).find("tree '1mm'"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.shapes = Shapes::kSpheres; }).find("shapes 'spheres'"), std::string::npos);
  EXPECT_NE(message([](Options& o) { o.time_limit = -1; }).find("time-limit '-1 s'"), std::string::npos);
  Options mixed;
  mixed.time_limit = 5;
  mixed.shapes = Shapes::kMixed;
  EXPECT_NO_THROW(check(mixed));
}

}  // namespace
}  // namespace collision_hulls
