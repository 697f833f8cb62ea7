#include <gtest/gtest.h>

#include "collision_hulls/config/config.h"
#include "collision_hulls/error.h"
#include "counted_looks.h"

namespace collision_hulls {
namespace {

// The example of doc/configuration.md, with something of everything.
constexpr const char* kPanda = R"(# panda_hulls.yaml
default: {tolerance: "1cm,5%", source: auto}
links:
  "panda_hand|.*finger": {tolerance: 2mm, effort: best}
  panda_link0: {tolerance: 3cm, max_hulls: 2}
  panda_link3: keep
  panda_link5: {method: bounding_box}
  camera_.*: remove
models: {planning: "1cm,5%", contact: 0.002}
output: {format: obj, uri: relative, rebase: true, segments: false, package_name: panda_hulls}
seed: 7
only: "(panda|camera)_.*"
)";

TEST(ParseConfig, EverythingItMaySay) {
  const Config config = parseConfig(kPanda, "panda.yaml");
  EXPECT_EQ(toString(config.defaults.tolerance.value()), "1cm,5%");
  EXPECT_EQ(config.defaults.source, Source::kAuto);
  EXPECT_FALSE(config.defaults.method);
  ASSERT_EQ(config.rules.size(), 5u);
  EXPECT_EQ(config.rules[0].pattern, "panda_hand|.*finger");
  EXPECT_EQ(config.rules[0].place, "'panda.yaml', line 4");
  EXPECT_EQ(config.rules[0].settings.effort, Effort::kBest);
  EXPECT_EQ(config.rules[1].settings.max_hulls, 2);
  EXPECT_EQ(config.rules[2].settings.action, Action::kKeep);
  EXPECT_EQ(config.rules[3].settings.method, Method::kBoundingBox);
  EXPECT_EQ(config.rules[4].settings.action, Action::kRemove);
  ASSERT_EQ(config.models.size(), 2u);
  EXPECT_EQ(config.models[1].name, "contact");
  EXPECT_EQ(config.models[1].tolerance.limit, 0.002);
  EXPECT_EQ(config.format, MeshFormat::kObj);
  EXPECT_EQ(config.uri, UriStyle::kRelative);
  EXPECT_EQ(config.rebase, true);
  EXPECT_EQ(config.segments, false);
  EXPECT_EQ(config.package_name, "panda_hulls");
  EXPECT_EQ(config.seed, 7u);
  EXPECT_EQ(config.only, "(panda|camera)_.*");
  EXPECT_EQ(config.named, (std::set<std::string>{"tolerance", "source", "model", "format", "uri", "rebase", "segments", "package-name",
                                                 "seed", "links"}));
}

TEST(ParseConfig, NothingAtAll) {
  for (const char* text : {"", "# a comment\n", "{}", "---\n"}) {
    const Config config = parseConfig(text, "f");
    EXPECT_TRUE(config.rules.empty() && config.models.empty() && config.named.empty()) << text;
  }
}

TEST(ParseConfig, AWordOrAMap) {
  EXPECT_EQ(parseConfig("links: {a: keep}", "f").rules[0].settings.action, Action::kKeep);
  EXPECT_EQ(parseConfig("links: {a: {action: keep}}", "f").rules[0].settings.action, Action::kKeep);
  EXPECT_EQ(parseConfig("links: {a: decompose}", "f").rules[0].settings.action, Action::kDecompose);
}

TEST(ParseConfig, AliasesAreWhatTheyStandFor) {
  const Config config = parseConfig("links: {a: &fine {tolerance: 2mm}, b: *fine}", "f");
  EXPECT_EQ(config.rules[1].settings.tolerance->limit, 0.002);
}

TEST(ParseConfig, EveryWayToGetItWrong) {
  struct Wrong {
    const char* text;
    std::vector<const char*> parts;  // of the message: line, item, value, remedy
  };
  const std::vector<Wrong> all = {
      {"default: {tolerance: 5mm\n", {"'f.yaml', line", "not valid YAML", "an earlier '{' is not closed"}},
      {"only: [a\n", {"not valid YAML", "an earlier '[' is not closed"}},
      {"links:\n\tarm: keep", {"line 2", "not valid YAML", "begins with a tab: indent with spaces"}},
      {"links:\n  arm: keep\n hand: keep", {"line 3", "not valid YAML", "indent it as the lines that it belongs to"}},
      {"- a list", {"line 1", "a configuration is a map", "default:"}},
      {"just words", {"line 1", "a configuration is a map"}},
      {"{}\n---\n{}", {"line 3", "a second document"}},
      {"link: {}", {"line 1", "'link' is not known", "default, only, links", "did you mean 'links'?"}},
      {"seed: 1\ntolerance: 5mm",
       {"line 2", "'tolerance' is not known: use one of default, ",
        "regions; tolerance is a setting of links: "
        "put it under default:"}},
      {"max-hulls: 4", {"'max-hulls' is not known", "; max_hulls is a setting of links: put it under default:"}},
      {"tree: none", {"'tree' is not known", "put it under default:"}},
      {"action: keep", {"'action' is not known", "put it under links:"}},
      {"seed: 1\nregions:\n  - {link: hand}", {"line 3", "region 1 has neither box nor half_space", "give one of them"}},
      {"links:\n  arm: {tolerence: 2mm}", {"line 2", "'tolerence' is not known in links 'arm'", "did you mean 'tolerance'?"}},
      {"links:\n  arm: {regions: []}", {"'regions' is not known in links 'arm'"}},
      {"default: {tolerance: 1cm,5%}", {"line 1", "'5%' stands alone in default", "'1cm,5%'"}},
      {"default: {action: keep}", {"'action' is not known in default"}},
      {"default: keep", {"line 1", "default is 'keep'", "only:"}},
      {"default: [1]", {"default is a list: use a map"}},
      {"default:", {"default is nothing"}},
      {"default: {tolerance: 0}", {"line 1: default: tolerance '0' is invalid", "positive length"}},
      {"default: {tolerance: 5}", {"default: tolerance '5' is more than 1 m", "did you mean 5mm?"}},
      {"links:\n  arm: {padding: 2m}", {"line 2: links 'arm': padding '2m' is more than 1 m"}},
      {"default: {tolerance: {limit: 1}}", {"tolerance of default is a map"}},
      {"default: {tolerance: }", {"tolerance of default is nothing"}},
      {"default: {tolerance: 1,5%}", {"line 1"}},  // which YAML reads as a pair
      {"default: {tree: lots}", {"default: tree 'lots'"}},
      {"default: {method: certifed}", {"method of default is 'certifed'", "one of certified, hacd", "did you mean 'certified'?"}},
      {"default: {effort: high}", {"effort of default is 'high': use one of instant, quick, best"}},
      {"default: {fill: 1}", {"fill of default is '1': use true or false"}},
      {"default: {fill: \"true\"}", {"true or false, without quotes"}},
      {"default: {max_hulls: many}", {"max_hulls of default is 'many': use a whole number"}},
      {"default: {max_hulls: -1}", {"max_hulls of default is '-1'"}},
      {"default: {max_hulls: 2.5}", {"max_hulls of default is '2.5'"}},
      {"default: {max_hulls: \"2\"}", {"max_hulls of default is '2'", "without quotes"}},
      {"default: {max_hulls: 99999999999}", {"max_hulls of default is '99999999999'"}},
      {"default: {max_vertices: 5}", {"line 1", "max-vertices '5' is invalid", "from 8"}},
      {"default: {source: visuals}", {"source of default is 'visuals'", "did you mean 'visual'?"}},
      {"default: {method: hacd, effort: best}", {"effort 'best' of default needs method 'certified', not 'hacd'"}},
      {"default: {effort: instant, method: acd}", {"effort 'instant' of default needs method 'certified', not 'acd'"}},
      {"links: [arm]", {"links is a list: use a map"}},
      {"links:\n  arm: kept", {"line 2", "links 'arm' is 'kept'", "did you mean 'keep'?"}},
      {"links:\n  arm:", {"line 2", "links 'arm' is nothing", "keep, remove"}},
      {"links:\n  arm: {}", {"links 'arm' is a map", "such as {tolerance: 2mm}"}},
      {"links:\n  arm: 2mm", {"links 'arm' is '2mm'", "{tolerance: 2mm}"}},
      {"links:\n  \"(arm\": keep", {"line 2", "links '(arm' is invalid", "lacks its partner"}},
      {"links:\n  \"(a)\\\\1\": keep", {"line 2", "back-references"}},
      {"links:\n  arm: keep\n  hand: remove\n  arm: remove", {"line 4", "'arm' of links is already in line 2"}},
      {"links:\n  arm: {tolerance: 1mm, tolerance: 2mm}", {"'tolerance' of links 'arm' is already in line 2"}},
      {"links:\n  arm: {action: keep, max_hulls: 3}", {"max_hulls of links 'arm' contradicts 'keep'", "remove one"}},
      {"links:\n  arm: {action: remove, method: hacd}", {"method of links 'arm' contradicts 'remove'"}},
      {"links:\n  arm: {action: keep, tolerance: 1mm}", {"tolerance of links 'arm' contradicts 'keep'"}},
      {"links:\n  arm: {method: acd, fill: true}", {"fill 'true' of links 'arm' needs method 'certified', not 'acd'"}},
      {"links: {[a]: keep}", {"line 1", "a key of links is a list: use a single word, in quotes if it has brackets"}},
      {"links: {? [a] : keep}", {"line 1", "a key of links is a list: use a single word"}},
      {"{a: b}: keep", {"line 1", "a key is a map: use a single word"}},
      {"links: {~: keep}", {"line 1", "a key of links is nothing: use a single word"}},
      {"links: {a: *nowhere}", {"not valid YAML", "put text that begins with '*' in quotes"}},
      {"links: &a {b: *a}", {"line 1"}},
      {"only: \"*\"", {"only '*' is invalid"}},
      {"only: {a: b}", {"only is a map"}},
      {"models: 1cm", {"models is '1cm': use a map", "{planning: 1cm"}},
      {"models: {a: 1cm, a: 2mm}", {"'a' of models is already in line 1"}},
      {"models: {a/b: 1cm}", {"model 'a/b' is invalid", "letters, digits"}},
      {"models: {a: fine}", {"model 'a': tolerance 'fine' is invalid"}},
      {"models: {planning: 1cm,5%, contact: 2mm}", {"line 1", "'5%' stands alone in models", "'1cm,5%'"}},
      {"output: {format: ply}", {"format of output is 'ply'", "stl, obj, dae"}},
      {"output: {uri: http}", {"uri of output is 'http'"}},
      {"output: {package_name: My Robot}", {"package-name 'My Robot' is invalid"}},
      {"output: {packagename: a}", {"'packagename' is not known in output", "did you mean 'package_name'?"}},
      {"links: {\"a\\e[31m\": keep}", {"a key of links holds a control character"}},
      {"links: {a: \"\\e[31m\"}", {"links 'a' holds a control character"}},
      {"seed: -1", {"seed is '-1': use a whole number"}},
      {"seed: 18446744073709551616", {"seed is '18446744073709551616'"}},
  };
  for (const Wrong& wrong : all) {
    try {
      parseConfig(wrong.text, "f.yaml");
      ADD_FAILURE() << "accepted: " << wrong.text;
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.code(), ErrorCode::kBadOption) << wrong.text;
      EXPECT_EQ(message.find("'f.yaml', line "), 0u) << wrong.text << "\n" << message;
      for (const char* part : wrong.parts)
        EXPECT_NE(message.find(part), std::string::npos) << wrong.text << "\n" << message << "\nlacks " << part;
    }
  }
}

// Each level names the one before nine times: nine to the ninth values, were they followed.
TEST(ParseConfig, ABombOfAliasesCostsNothing) {
  std::string text = "a: &a [1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (char level = 'b'; level < 'j'; ++level) {
    const std::string before = "*" + std::string(1, static_cast<char>(level - 1));
    text += std::string(1, level) + ": &" + level + " [";
    for (int i = 0; i < 9; ++i) text += (i ? ", " : "") + before;
    text += "]\n";
  }
  for (const std::string& config : std::vector<std::string>{text, text + "links: *i", "links: {x: &y {z: {tolerance: &z [*z, *z]}}}"})
    EXPECT_THROW(parseConfig(config, "f"), Error);
}

TEST(ParseConfig, HugeAndDeepTexts) {
  EXPECT_THROW(parseConfig(std::string((1 << 20) + 1, ' '), "f"), Error);
  EXPECT_THROW(parseConfig("links: " + std::string(100'000, '['), "f"), Error);
  EXPECT_THROW(parseConfig("links: {" + std::string(2000, 'a') + ": keep}", "f"), Error);
  std::string many = "links:\n";
  for (int i = 0; i < 10'000; ++i) many += "  arm_" + std::to_string(i) + ": {tolerance: 2mm}\n";
  EXPECT_EQ(parseConfig(many, "f").rules.size(), 10'000u);
}

TEST(ParseConfig, LooksAtTheControlForEachExpression) {
  constexpr int kMany = 900;
  std::string links = "links:\n", regions = "regions:\n";
  for (int i = 0; i < kMany; ++i) {
    links += "  arm_" + std::to_string(i) + "[a-z]*: keep\n";
    regions += "  - {link: \"arm_[a-z]*\", half_space: {normal: [0, 0, 1], offset: 1}, keep_clear: true}\n";
  }
  for (const std::string& text : {links, regions})
    EXPECT_GE(looksOf([&](const RunControl& control) { parseConfig(text, "f", control); }), static_cast<std::size_t>(kMany));
}

TEST(ParseConfig, TwentyModelsAreEnough) {
  std::string text = "models: {m0: 1cm";
  for (int i = 1; i < 20; ++i) text += ", m" + std::to_string(i) + ": 1cm";
  EXPECT_EQ(parseConfig(text + "}", "f").models.size(), 20u);
  try {
    parseConfig(text + ", more: 1cm}", "f");
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    for (const char* part : {"'f', line 1", "21 models", "'m0'", "at most 20", "run of their own"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(ReadConfig, NamesAFileThatIsMissing) {
  try {
    readConfig("/nowhere/panda.yaml");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kFileNotFound);
    EXPECT_NE(std::string(error.what()).find("/nowhere/panda.yaml"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace collision_hulls
