// Every value knows its file, its line and the keys that led to it, so that messages can say them.
#include "scene/yaml_node.h"

#include "base/finite_number.h"
#include "base/uri_text.h"

namespace collision_hulls {

YamlValue YamlValue::parse(const std::string& text, const std::string& file, ErrorCode code, std::size_t first_line,
                           const RunControl& control) {
  return parse({{text, first_line}}, file, code, control).front();
}

std::vector<YamlValue> YamlValue::parse(const std::vector<YamlText>& documents, const std::string& file, ErrorCode code,
                                        const RunControl& control) {
  std::vector<YamlTree> trees = parseYaml(documents, file, code, control);
  std::vector<YamlValue> values;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const std::size_t root = trees[i].nodes.size() - 1;
    values.push_back(
        {std::make_shared<const Document>(Document{std::move(trees[i]), file, code, std::size_t{documents[i].first_line}}), root});
  }
  return values;
}

bool YamlValue::isMap() const {
  return node().kind == YamlTree::Kind::kMap;
}

bool YamlValue::isSequence() const {
  return node().kind == YamlTree::Kind::kSequence;
}

bool YamlValue::isScalar() const {
  return node().kind == YamlTree::Kind::kScalar;
}

bool YamlValue::isNull() const {
  return node().kind == YamlTree::Kind::kNull;
}

bool YamlValue::isQuoted() const {
  return node().is_quoted != 0;
}

std::string YamlValue::text() const {
  if (!isScalar()) fail("expected a single value");
  return node().text;
}

double YamlValue::number() const {
  double value = 0;
  if (!parseFinite(text(), value)) fail("expected a finite number, found '" + shown(text()) + "'");
  return value;
}

std::vector<YamlValue> YamlValue::items() const {
  if (!isSequence()) fail("expected a list; an empty one is []");
  std::vector<YamlValue> result;
  for (const std::uint32_t item : node().children) result.push_back(valueAt(item));
  return result;
}

std::vector<double> YamlValue::numbers() const {
  std::vector<double> result;
  for (const YamlValue& item : items()) result.push_back(item.number());
  return result;
}

std::vector<double> YamlValue::numbers(std::size_t count) const {
  if (!isSequence()) fail("expected a list of " + std::to_string(count) + " numbers");
  std::vector<double> result = numbers();
  if (result.size() != count) fail("expected " + std::to_string(count) + " numbers, found " + std::to_string(result.size()));
  return result;
}

std::vector<std::pair<YamlValue, YamlValue>> YamlValue::entries() const {
  if (!isMap()) fail("expected a map (key: value)");
  std::vector<std::pair<YamlValue, YamlValue>> result;
  for (std::size_t i = 0; i < node().children.size(); i += 2)
    result.emplace_back(valueAt(node().children[i]), valueAt(node().children[i + 1]));
  return result;
}

std::vector<std::string> YamlValue::keys() const {
  std::vector<std::string> result;
  for (const auto& [key, value] : entries()) result.push_back(key.text());
  return result;
}

const std::uint32_t* YamlValue::valueOf(const std::string& key) const {
  if (!isMap()) return nullptr;
  const std::vector<std::uint32_t>& entries = node().children;
  for (std::size_t i = 0; i < entries.size(); i += 2) {
    const YamlTree::Node& known = document_->tree.nodes[entries[i]];
    if (known.kind == YamlTree::Kind::kScalar && known.text == key) return &entries[i + 1];
  }
  return nullptr;
}

bool YamlValue::has(const std::string& key) const {
  return valueOf(key) != nullptr;
}

YamlValue YamlValue::operator[](const std::string& key) const {
  const std::uint32_t* const value = valueOf(key);
  if (!value) fail("'" + key + "' is missing");
  return valueAt(*value).called(what_.empty() ? key : what_ + ", " + key);
}

YamlValue YamlValue::called(std::string what) const {
  return {document_, node_, std::move(what)};
}

std::size_t YamlValue::line() const {
  return document_->first_line + node().line;
}

std::string YamlValue::where() const {
  return "'" + document_->file + "', line " + std::to_string(line());
}

std::string YamlValue::place() const {
  return what_.empty() ? where() : where() + ", " + what_;
}

void YamlValue::fail(const std::string& reason) const {
  throw Error(document_->code, place() + ": " + reason);
}

}  // namespace collision_hulls
