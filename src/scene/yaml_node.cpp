// Wraps yaml-cpp so that every value knows its file and line. Brackets are counted before parsing, as old versions of yaml-cpp overflow the
// stack on deep nesting.
#include "scene/yaml_node.h"

#include <yaml-cpp/yaml.h>

#include "scene/reading.h"

namespace collision_hulls {

struct YamlValue::Node {
  struct Source {
    std::string file;
    ErrorCode code;
    std::size_t first_line;
  };
  YAML::Node value;
  std::shared_ptr<const Source> source;

  static YamlValue wrap(const YAML::Node& value, const std::shared_ptr<const Source>& source) {
    YamlValue result;
    result.node_ = std::make_shared<Node>(Node{value, source});
    return result;
  }
};

namespace {

std::string place(const std::string& file, std::size_t line) {
  return "'" + file + "', line " + std::to_string(line);
}

std::size_t lineOf(const YAML::Mark& mark, std::size_t first_line) {
  return first_line + static_cast<std::size_t>(std::max(0, mark.line));
}

/// yaml-cpp before 0.7 (Ubuntu 20.04) recurses once per bracket and overflows the stack.
bool nestsTooDeep(const std::string& text) {
  constexpr int kDeepest = 500;
  int depth = 0;
  for (const char c : text) {
    depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (depth > kDeepest) return true;
  }
  return false;
}

}  // namespace

YamlValue YamlValue::parse(const std::string& text, const std::string& file, ErrorCode code, std::size_t first_line) {
  if (nestsTooDeep(text))
    throw Error(code, place(file, first_line) + ": more than 500 brackets are open at once; close them, or nest less");
  const auto source = std::make_shared<const Node::Source>(Node::Source{file, code, first_line});
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAll(text);
    for (std::size_t i = 1; i < documents.size(); ++i)
      if (!documents[i].IsNull())
        throw Error(code, place(file, lineOf(documents[i].Mark(), first_line)) + ": a second document; put everything into one");
    return Node::wrap(documents.empty() ? YAML::Node() : documents.front(), source);
  } catch (const YAML::Exception& error) {
    throw Error(code, place(file, lineOf(error.mark, first_line)) + ": not valid YAML: " + error.msg);
  }
}

bool YamlValue::isMap() const {
  return node_->value.IsMap();
}

bool YamlValue::isSequence() const {
  return node_->value.IsSequence();
}

bool YamlValue::isNull() const {
  return node_->value.IsNull();
}

bool YamlValue::isQuoted() const {
  return node_->value.IsScalar() && node_->value.Tag() == "!";
}

std::string YamlValue::text() const {
  if (!node_->value.IsScalar()) fail("expected a single value");
  return node_->value.Scalar();
}

double YamlValue::number() const {
  double value = 0;
  if (!parseNumber(text(), value)) fail("expected a finite number, found '" + text() + "'");
  return value;
}

std::vector<YamlValue> YamlValue::items() const {
  if (!isSequence()) fail("expected a list");
  std::vector<YamlValue> result;
  for (const YAML::Node& item : node_->value) result.push_back(Node::wrap(item, node_->source));
  return result;
}

std::vector<double> YamlValue::numbers() const {
  std::vector<double> result;
  for (const YamlValue& item : items()) result.push_back(item.number());
  return result;
}

std::vector<double> YamlValue::numbers(std::size_t count) const {
  std::vector<double> result = numbers();
  if (result.size() != count) fail("expected " + std::to_string(count) + " numbers, found " + std::to_string(result.size()));
  return result;
}

std::vector<std::pair<YamlValue, YamlValue>> YamlValue::entries() const {
  if (!isMap()) fail("expected a map (key: value)");
  std::vector<std::pair<YamlValue, YamlValue>> result;
  for (const auto& entry : node_->value)
    result.emplace_back(Node::wrap(entry.first, node_->source), Node::wrap(entry.second, node_->source));
  return result;
}

std::vector<std::string> YamlValue::keys() const {
  std::vector<std::string> result;
  for (const auto& [key, value] : entries()) result.push_back(key.text());
  return result;
}

bool YamlValue::has(const std::string& key) const {
  return isMap() && node_->value[key].IsDefined();
}

YamlValue YamlValue::operator[](const std::string& key) const {
  if (!has(key)) fail("'" + key + "' is missing");
  return Node::wrap(node_->value[key], node_->source);
}

std::size_t YamlValue::line() const {
  return lineOf(node_->value.Mark(), node_->source->first_line);
}

std::string YamlValue::where() const {
  return place(node_->source->file, line());
}

void YamlValue::fail(const std::string& reason) const {
  throw Error(node_->source->code, where() + ": " + reason);
}

}  // namespace collision_hulls
