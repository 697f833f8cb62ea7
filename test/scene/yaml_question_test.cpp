// Also tests src/decode/decode_yaml.cpp.
#include "scene/yaml_question.h"

#include "geometry/bytes.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

/// A value as text.
std::string written(const YamlTree& tree, std::size_t index) {
  const YamlTree::Node& node = tree.nodes.at(index);
  if (node.kind == YamlTree::Kind::kNull) return "null";
  if (node.kind == YamlTree::Kind::kScalar) return node.is_quoted ? "'" + node.text + "'" : node.text;
  std::string text = node.kind == YamlTree::Kind::kMap ? "{" : "[";
  for (const std::uint32_t child : node.children) text += written(tree, child) + ";";
  return text + (node.kind == YamlTree::Kind::kMap ? "}" : "]");
}

std::string parsed(const std::string& text) {
  const YamlTree tree = parseYaml({{text, 1}}, "a.yaml", ErrorCode::kBadScene, {}).at(0);
  return written(tree, tree.nodes.size() - 1);
}

TEST(YamlQuestion, Values) {
  EXPECT_EQ(parsed("a: 1\nb: [x, \"y z\", ~]\nc: {d: }\n'1': '~'\n"), "{a;1;b;[x;'y z';null;];c;{d;null;};'1';'~';}");
  EXPECT_EQ(parsed("- &x [1, 2]\n- *x\n- &y z\n- *y\n"), "[[1;2;];[1;2;];z;z;]");
  EXPECT_EQ(parsed(""), "null");
  EXPECT_EQ(parsed("a: 1\n---\n---\n"), "{a;1;}");
}

TEST(YamlQuestion, TextsThatAreNoYaml) {
  for (const std::string text : {",x", "]", "}", "a: 1\n---\n,", "\xEF\xBB\xBF,uuuu=", "[1, 2", "a: *b", "&a [*a]", "a: 1\n---\nb: 2\n"})
    expectError(ErrorCode::kBadScene, {"'a.yaml', line"}, [&] { parsed(text); });
  expectError(ErrorCode::kBadScene, {"500 brackets"}, [] { parsed(std::string(501, '[')); });
}

// Each of the lists is a thousand names of one character: 2,001 values and characters.
TEST(YamlQuestion, AliasesThatRepeatTooMuch) {
  const auto text = [](int lists) {
    std::string names = "- &names [", repeated;
    for (int i = 0; i < 1000; ++i) names += "a, ";
    for (int i = 0; i < lists; ++i) repeated += "- *names\n";
    return names + "]\n" + repeated;
  };
  EXPECT_NO_THROW(parsed(text(1900)));
  expectError(ErrorCode::kBadScene, {"'a.yaml', line 1", "aliases repeat more than 4000000", "fewer"}, [&] { parsed(text(2100)); });
  const std::string scalar = "- &long " + std::string(10'000, 'a') + "\n";
  std::string repeated;
  for (int i = 0; i < 410; ++i) repeated += "- *long\n";
  expectError(ErrorCode::kBadScene, {"aliases"}, [&] { parsed(scalar + repeated); });
}

TEST(YamlQuestion, SeveralDocumentsAtOnce) {
  const std::vector<YamlTree> trees = parseYaml({{"a: 1", 1}, {"[2]", 5}}, "a.yaml", ErrorCode::kBadScene, {});
  ASSERT_EQ(trees.size(), 2u);
  EXPECT_EQ(written(trees[1], trees[1].nodes.size() - 1), "[2;]");
  expectError(ErrorCode::kBadScene, {"line 8"}, [] { parseYaml({{"a: 1", 1}, {"\n[2", 7}}, "a.yaml", ErrorCode::kBadScene, {}); });
}

TEST(YamlQuestion, AnAnswerThatIsNoTree) {
  const auto node = [](YamlTree::Kind kind, const std::vector<std::uint32_t>& children) {
    return toBytes(kind, std::uint64_t{0}, std::string("a"), std::uint8_t{0}, children);
  };
  const auto answer = [](std::uint64_t nodes, const std::string& bytes) { return toBytes(std::uint64_t{1}, nodes) + bytes; };
  const std::string scalar = node(YamlTree::Kind::kScalar, {});
  EXPECT_NO_THROW(yamlIn(answer(2, scalar + node(YamlTree::Kind::kSequence, {0, 0}))));
  EXPECT_THROW(yamlIn(answer(0, "")), ByteFault);
  EXPECT_THROW(yamlIn(answer(2, scalar + node(YamlTree::Kind::kSequence, {1}))), ByteFault);
  EXPECT_THROW(yamlIn(answer(2, scalar + node(YamlTree::Kind::kMap, {0}))), ByteFault);
  EXPECT_THROW(yamlIn(answer(1, node(static_cast<YamlTree::Kind>(9), {}))), ByteFault);
  std::string doubling = scalar;
  for (std::uint32_t i = 0; i < 40; ++i) doubling += node(YamlTree::Kind::kSequence, {i, i});
  EXPECT_THROW(yamlIn(answer(41, doubling)), ByteFault);
}

}  // namespace
}  // namespace collision_hulls
