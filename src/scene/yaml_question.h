// YAML that is parsed in a process of its own: both ends of the question, and what is passed between them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/error.h"
#include "sandbox/serve.h"

namespace collision_hulls {

/// A document as a list of its values: what a value holds stands before it, the root last. So an alias is an index like any other, and
/// nothing can hold itself.
struct YamlTree {
  enum class Kind : std::uint8_t { kNull, kScalar, kSequence, kMap };
  struct Node {
    Kind kind = Kind::kNull;
    std::uint64_t line = 0;      ///< of the text, from 0
    std::string text;            ///< of a scalar,
    std::uint8_t is_quoted = 0;  ///< which is a text, whatever it looks like
    /// indices of a sequence's items; of a map's keys and values in turn
    std::vector<std::uint32_t> children;
  };
  std::vector<Node> nodes;
};

/// A document's text, and the line of the file in which it starts.
struct YamlText {
  std::string text;
  std::uint64_t first_line = 1;
};

/// Parses documents in another process; `file` stands in messages. Throws `code`, naming file and line, for what is not YAML, and what
/// ReaderProgram::ask() throws.
std::vector<YamlTree> parseYaml(const std::vector<YamlText>& documents, const std::string& file, ErrorCode code, const RunControl& control);

/// How many values and characters the aliases of a document add to what is written out; counted no further than to the limit.
std::size_t repeatedByAliases(const YamlTree& tree);
constexpr std::size_t kMostRepeated = 4'000'000;

/// Takes documents, their file, and the code of an error: decodeYaml() of the room decode.
using YamlDecoder = std::function<std::vector<YamlTree>(const std::vector<YamlText>&, const std::string&, ErrorCode)>;

/// The worker's end.
std::string answerYamlQuestion(const Question& question, const YamlDecoder& decode);

/// The documents in an answer. Throws ByteFault for what is none.
std::vector<YamlTree> yamlIn(const std::string& answer);

}  // namespace collision_hulls
