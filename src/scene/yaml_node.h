// YAML values that name their file and line in messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/error.h"
#include "scene/yaml_question.h"

namespace collision_hulls {

/// A value in a document: a view that keeps the document alive. Its functions throw the document's `code`, naming file and line, and
/// the keys that led to the value since the document or the last called().
class YamlValue {
 public:
  /// Parses a document, or several at once, in another process (see parseYaml()). `first_line`: the line of the file at which the text
  /// starts.
  static YamlValue parse(const std::string& text, const std::string& file, ErrorCode code, std::size_t first_line = 1,
                         const RunControl& control = {});
  static std::vector<YamlValue> parse(const std::vector<YamlText>& documents, const std::string& file, ErrorCode code,
                                      const RunControl& control);

  bool isMap() const;
  bool isSequence() const;

  bool isScalar() const;
  bool isNull() const;    ///< nothing stands there
  bool isQuoted() const;  ///< a scalar that is a text, whatever it looks like

  std::string text() const;                                      ///< of a scalar
  double number() const;                                         ///< of a scalar; finite
  std::vector<YamlValue> items() const;                          ///< of a sequence
  std::vector<double> numbers() const;                           ///< of a sequence of numbers
  std::vector<double> numbers(std::size_t count) const;          ///< of a sequence of `count` numbers
  std::vector<std::string> keys() const;                         ///< of a map, in document order
  std::vector<std::pair<YamlValue, YamlValue>> entries() const;  ///< of a map: keys and values in document order
  bool has(const std::string& key) const;                        ///< of a map; false if the value is not a map
  YamlValue operator[](const std::string& key) const;            ///< of a map that has the key; of several, the first

  /// The same value, which messages about it and what it holds call this: "body 'table'".
  YamlValue called(std::string what) const;

  std::size_t line() const;
  std::string where() const;  ///< "'file', line 3"
  std::string place() const;  ///< "'file', line 3, body 'table', pose"
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  struct Document {
    YamlTree tree;
    std::string file;
    ErrorCode code;
    std::size_t first_line;
  };
  YamlValue(std::shared_ptr<const Document> document, std::size_t node, std::string what = "")
      : document_(std::move(document)), node_(node), what_(std::move(what)) {}
  const YamlTree::Node& node() const { return document_->tree.nodes[node_]; }
  YamlValue valueAt(std::uint32_t node) const { return {document_, node, what_}; }
  const std::uint32_t* valueOf(const std::string& key) const;  // null where there is none

  std::shared_ptr<const Document> document_;
  std::size_t node_;
  std::string what_;
};

}  // namespace collision_hulls
