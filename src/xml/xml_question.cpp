// A tree travels as the list of its elements with their depths, so that reading it back takes no recursion, however deep an answer claims
// to be.
#include "xml/xml_question.h"

#include <array>
#include <vector>

#include "collision_hulls/error.h"
#include "geometry/bytes.h"
#include "sandbox/file_reader.h"

namespace collision_hulls {
namespace {

struct FlatNode {
  std::uint32_t depth = 0;
  std::uint64_t line = 0;
  std::string name, text;
  std::vector<std::array<std::string, 2>> attributes;
};

constexpr std::uint32_t kDeepest = 1000;  // tinyxml2 refuses far less

void flatten(const XmlNode& node, std::uint32_t depth, std::vector<FlatNode>& all) {
  FlatNode& flat = all.emplace_back(FlatNode{depth, node.line, node.name, node.text, {}});
  for (const auto& [key, value] : node.attributes) flat.attributes.push_back({key, value});
  for (const XmlNode& child : node.children) flatten(child, depth + 1, all);
}

XmlNode toNode(FlatNode&& flat) {
  XmlNode node;
  node.name = std::move(flat.name);
  node.text = std::move(flat.text);
  node.line = flat.line;
  for (auto& [key, value] : flat.attributes) node.attributes[key] = std::move(value);
  return node;
}

}  // namespace

template <typename Archive>
void fields(Archive& archive, FlatNode& node) {
  archive(node.depth, node.line, node.name, node.text, node.attributes);
}

XmlNode xmlIn(const std::string& answer) {
  std::vector<FlatNode> all;
  fromBytes(answer, all);
  if (all.empty() || all.front().depth != 0) throw ByteFault("it has no root");
  XmlNode root = toNode(std::move(all.front()));
  std::vector<XmlNode*> open{&root};  // an element and those around it
  for (std::size_t i = 1; i < all.size(); ++i) {
    const std::uint32_t depth = all[i].depth;
    if (depth == 0 || depth > open.size() || depth > kDeepest) throw ByteFault("an element has no parent");
    open.resize(depth);
    open.push_back(&open.back()->children.emplace_back(toNode(std::move(all[i]))));
  }
  return root;
}

std::string answerXmlQuestion(const Question& question, const XmlDecoder& decode) {
  auto kind = Reading::kXml;
  std::string label;
  fromBytes(question.head, kind, label);
  std::vector<FlatNode> all;
  flatten(decode(question.body, label), 0, all);
  return toBytes(all);
}

XmlNode parseXml(const std::string& text, const std::string& label, const RunControl& control) {
  const std::string answer = askAboutText(toBytes(Reading::kXml, label), text, label, control);
  return madeOfAnswer(label, "replace the file", [&] { return xmlIn(answer); });
}

}  // namespace collision_hulls
