// Trees travel as lists of values. What comes back may be made to do harm: that nothing holds itself is checked, and how much aliases
// repeat, before anything walks a tree.
#include "scene/yaml_question.h"

#include <algorithm>

#include "geometry/bytes.h"
#include "sandbox/file_reader.h"

namespace collision_hulls {
namespace {

void expectSound(const YamlTree& tree) {
  if (tree.nodes.empty()) throw ByteFault("a document has no root");
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const YamlTree::Node& node = tree.nodes[i];
    if (node.kind > YamlTree::Kind::kMap) throw ByteFault("a value is of no known kind");
    if (node.kind == YamlTree::Kind::kMap && node.children.size() % 2 != 0) throw ByteFault("a key has no value");
    for (const std::uint32_t child : node.children)
      if (child >= i) throw ByteFault("a value does not precede what holds it");
  }
  if (repeatedByAliases(tree) > kMostRepeated) throw ByteFault("its aliases repeat too much");
}

}  // namespace

template <typename Archive>
void fields(Archive& archive, YamlTree::Node& node) {
  archive(node.kind, node.line, node.text, node.is_quoted, node.children);
}

template <typename Archive>
void fields(Archive& archive, YamlTree& tree) {
  archive(tree.nodes);
}

template <typename Archive>
void fields(Archive& archive, YamlText& document) {
  archive(document.text, document.first_line);
}

std::size_t repeatedByAliases(const YamlTree& tree) {
  std::vector<std::size_t> sizes;  // of the values, with what they hold
  std::size_t written = 0;
  for (const YamlTree::Node& node : tree.nodes) {
    std::size_t size = 1 + node.text.size();
    written += size;
    for (const std::uint32_t child : node.children) size = std::min(size + sizes[child], written + kMostRepeated + 1);
    sizes.push_back(size);
  }
  return sizes.back() - std::min(sizes.back(), written);
}

std::string answerYamlQuestion(const Question& question, const YamlDecoder& decode) {
  auto kind = Reading::kYaml;
  std::string file;
  auto code = ErrorCode::kInternal;
  fromBytes(question.head, kind, file, code);
  std::vector<YamlText> documents;
  fromBytes(question.body, documents);
  return toBytes(decode(documents, file, code));
}

std::vector<YamlTree> yamlIn(const std::string& answer) {
  std::vector<YamlTree> trees;
  fromBytes(answer, trees);
  for (const YamlTree& tree : trees) expectSound(tree);
  return trees;
}

std::vector<YamlTree> parseYaml(const std::vector<YamlText>& documents, const std::string& file, ErrorCode code,
                                const RunControl& control) {
  const std::string label = "'" + file + "'";
  const std::string answer = askAboutText(toBytes(Reading::kYaml, file, code), toBytes(documents), label, control);
  return madeOfAnswer(label, "replace the file", [&] {
    std::vector<YamlTree> trees = yamlIn(answer);
    if (trees.size() != documents.size()) throw ByteFault("it has another number of documents");
    return trees;
  });
}

}  // namespace collision_hulls
