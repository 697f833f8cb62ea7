#include "collision_hulls/config/config.h"

#include <gtest/gtest.h>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

Options optionsOf(const std::string& text) {
  Options options;
  apply(parseConfig(text, "f.yaml"), options);
  return options;
}

TEST(ApplyConfig, ChangesWhatItNamesAlone) {
  Options options;
  options.max_hulls = 5;
  options.tree = lengthOf(0.001);
  apply(parseConfig("default: {tolerance: 2mm}\noutput: {uri: file}", "f"), options);
  EXPECT_EQ(options.tolerance.limit, 0.002);
  EXPECT_EQ(options.tolerance.share, Length::kUnset);
  EXPECT_EQ(options.max_hulls, 5);
  EXPECT_EQ(options.uri, UriStyle::kFile);
  EXPECT_EQ(options.tree->limit, 0.001);
  apply(parseConfig("default: {tree: none, max_hulls: 0}", "f"), options);
  EXPECT_FALSE(options.tree);
  EXPECT_EQ(options.max_hulls, 0);
}

TEST(ApplyConfig, OnlyNamesItsPlace) {
  EXPECT_EQ(optionsOf("only: a.*").links, "a.*");
  EXPECT_EQ(optionsOf("only: a.*").links_place, "'f.yaml', line 1");
  EXPECT_EQ(optionsOf("only: .*").links, "") << "all, as without it";
}

TEST(ConfigText, SpellsOutTheDefaults) {
  EXPECT_EQ(configText({}),
            "# Settings of the run that wrote this file: --config repeats it, with the same program (and scene).\n"
            "default: {tolerance: \"1cm,5%\", method: certified, effort: quick, fill: false, max_hulls: 0, max_vertices: 64, source: auto, "
            "padding: 0, close_openings: 0, shapes: hulls, "
            "tree: none}\n"
            "only: \".*\"\n"
            "links: {}\n"
            "regions: []\n"
            "models: {}\n"
            "output: {format: stl, uri: package, rebase: false, segments: false, package_name: \"\"}\n"
            "seed: 1\n");
}

TEST(ConfigText, SharesComeBackExactly) {
  for (int thousandths = 1; thousandths <= 1000; ++thousandths) {
    Options options;
    options.tolerance = shareOf(thousandths / 1000.0);
    EXPECT_EQ(optionsOf(configText(options)).tolerance, options.tolerance) << thousandths;
  }
}

TEST(ConfigText, ReadsBackAsTheSame) {
  const std::vector<std::string> texts = {
      "", "default: {tolerance: 3%, method: hacd, max_hulls: 4, max_vertices: 0, source: visual}\noutput: {segments: true, format: dae}",
      "default: {tree: 1mm, fill: true, effort: best}\nseed: 18446744073709551615",
      "links: {a: keep, b: remove, c: {action: decompose}, \"d\\\\.\\\"*\": {tolerance: \"1mm,2%\", source: collision, effort: best}}",
      "models: {planning: \"1cm,5%\", contact: 123.456um}\nonly: \"x|y\"\noutput: {uri: relative, rebase: true, package_name: a_b}"};
  for (const std::string& text : texts) {
    const Options options = optionsOf(text);
    const std::string written = configText(options);
    EXPECT_EQ(configText(optionsOf(written)), written) << text;
    EXPECT_EQ(optionsOf(written).links, options.links);
    ASSERT_EQ(optionsOf(written).rules.size(), options.rules.size());
    for (std::size_t i = 0; i < options.rules.size(); ++i) EXPECT_EQ(optionsOf(written).rules[i].pattern, options.rules[i].pattern);
  }
}

TEST(OverridingNotes, NameWhatTheCommandLineReplaces) {
  const Config config = parseConfig("default: {tolerance: 1mm, max_hulls: 3}\nonly: a\nmodels: {m: 1cm}", "f.yaml");
  EXPECT_EQ(overridingNotes(config, {}), std::vector<std::string>());
  EXPECT_EQ(overridingNotes(config, {"effort", "jobs"}), std::vector<std::string>());
  EXPECT_EQ(overridingNotes(config, {"tolerance", "links", "model", "profile"}),
            (std::vector<std::string>{"--links counts in place of 'only' in 'f.yaml'", "--model counts in place of 'models' in 'f.yaml'",
                                      "--profile counts in place of 'max_hulls' in 'f.yaml'"}));
  EXPECT_EQ(overridingNotes(config, {"max-hulls"}), std::vector<std::string>{"--max-hulls counts in place of 'max_hulls' in 'f.yaml'"});
  EXPECT_EQ(overridingNotes(config, {"tolerance"}), std::vector<std::string>()) << "each model has its own";
}

TEST(OverridingNotes, NameShapesHoweverTheyAreGiven) {
  const auto notes = [](const std::string& text, const std::set<std::string>& given) {
    return overridingNotes(parseConfig("default: {" + text + "}", "f.yaml"), given);
  };
  const auto counts = [](const std::string& option, const std::string& key) {
    return std::vector<std::string>{"--" + option + " counts in place of '" + key + "' in 'f.yaml'"};
  };
  EXPECT_EQ(notes("shape: box", {"shapes"}), counts("shapes", "shape"));
  EXPECT_EQ(notes("shape: box", {"spheres"}), counts("spheres", "shape"));
  EXPECT_EQ(notes("shapes: mixed", {"spheres"}), counts("spheres", "shapes"));
  EXPECT_EQ(notes("shapes: mixed", {"shapes", "spheres"}), counts("shapes", "shapes"));
}

}  // namespace
}  // namespace collision_hulls
