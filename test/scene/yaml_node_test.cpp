#include "scene/yaml_node.h"

#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

YamlValue parse(const std::string& text, std::size_t first_line = 1) {
  return YamlValue::parse(text, "cell.yaml", ErrorCode::kBadScene, first_line);
}

TEST(YamlValue, GivesWhatTheTextSays) {
  const YamlValue root = parse("name: cell\nsizes: [1, 2.5, -3e-2]\n");
  ASSERT_TRUE(root.isMap());
  EXPECT_EQ(root.keys(), (std::vector<std::string>{"name", "sizes"}));
  EXPECT_EQ(root["name"].text(), "cell");
  EXPECT_TRUE(root["sizes"].isSequence());
  EXPECT_EQ(root["sizes"].numbers(3), (std::vector<double>{1, 2.5, -0.03}));
  EXPECT_EQ(root["sizes"].items().size(), 3u);
  EXPECT_TRUE(root.has("name"));
  EXPECT_FALSE(root.has("pose") || root["name"].has("x"));
}

TEST(YamlValue, OutlivesItsDocument) {
  const YamlValue inner = parse("a: {b: 7}")["a"]["b"];
  EXPECT_EQ(inner.number(), 7);
}

TEST(YamlValue, FaultsNameFileAndLine) {
  expectError(ErrorCode::kBadScene, {"'cell.yaml', line 12"}, [] { parse("a: 1\nb: word\n", 11)["b"].number(); });
  expectError(ErrorCode::kBadScene, {"'cell.yaml', line 1"}, [] { parse("[1, 2]").numbers(3); });
  expectError(ErrorCode::kBadScene, {"cell.yaml"}, [] { parse("a: [1, 2"); });
  expectError(ErrorCode::kBadScene, {"cell.yaml"}, [] { parse("x: .nan")["x"].number(); });
}

TEST(YamlValue, FaultsNameTheKeysThatLedThere) {
  const YamlValue root = parse("bodies:\n- {pose: {xyz: [1, 2]}, scale: 2}\n");
  expectError(ErrorCode::kBadScene, {"'cell.yaml', line 2, bodies: 'size' is missing"}, [&] { root["bodies"].items()[0]["size"]; });
  const YamlValue body = root["bodies"].items()[0].called("body 7");
  EXPECT_EQ(body["pose"]["xyz"].place(), "'cell.yaml', line 2, body 7, pose, xyz");
  EXPECT_EQ(body["pose"]["xyz"].where(), "'cell.yaml', line 2");
  expectError(ErrorCode::kBadScene, {"line 2, body 7, pose, xyz: expected 3 numbers, found 2"}, [&] { body["pose"]["xyz"].numbers(3); });
  expectError(ErrorCode::kBadScene, {"line 2, body 7, scale: expected a list of 3 numbers"}, [&] { body["scale"].numbers(3); });
}

TEST(YamlValue, AFaultyNumberIsShownShort) {
  try {
    parse("x: " + std::string(100'000, 'y'))["x"].number();
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_LT(std::string(error.what()).size(), 1000u);
  }
}

}  // namespace
}  // namespace collision_hulls
