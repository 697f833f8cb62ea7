// YAML with the place of everything in messages. With yaml_node.cpp the only place of this project that sees yaml-cpp.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "collision_hulls/error.h"

namespace collision_hulls {

/// A value of a document: a view into it, which keeps it alive. Its functions throw `code` of the document, naming file and line.
class YamlValue {
 public:
  /// Parses a document. `first_line`: where the text stands in the file.
  static YamlValue parse(const std::string& text, const std::string& file, ErrorCode code, std::size_t first_line = 1);

  bool isMap() const;
  bool isSequence() const;

  std::string text() const;                              ///< of a scalar
  double number() const;                                 ///< of a scalar; finite
  std::vector<YamlValue> items() const;                  ///< of a sequence
  std::vector<double> numbers() const;                   ///< of a sequence of numbers
  std::vector<double> numbers(std::size_t count) const;  ///< so many of them
  std::vector<std::string> keys() const;                 ///< of a map, in their order
  bool has(const std::string& key) const;                ///< of a map; false for what is none
  YamlValue operator[](const std::string& key) const;    ///< of a map that has it

  std::size_t line() const;
  std::string where() const;  ///< "'file', line 3"
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  struct Node;
  std::shared_ptr<const Node> node_;
};

}  // namespace collision_hulls
