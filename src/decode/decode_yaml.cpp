// The only file that sees yaml-cpp, and that only as a source of events. Its own loader is not used: it never ends for a text such as ",x",
// and takes all memory meanwhile. Brackets are counted before parsing, as old versions overflow the stack on deep nesting.
#include "decode/decode_yaml.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace collision_hulls {
namespace {

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

/// Not YAML; where, and why.
struct YamlFault {
  YAML::Mark mark;
  std::string reason;
};

/// Collects the values of one document.
class TreeBuilder : public YAML::EventHandler {
 public:
  using Mark = YAML::Mark;
  using Anchor = YAML::anchor_t;
  using Style = YAML::EmitterStyle::value;

  void OnDocumentStart(const Mark& mark) override { start_ = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const Mark& mark, Anchor anchor) override { close(begin(YamlTree::Kind::kNull, mark, anchor)); }
  void OnAlias(const Mark& mark, Anchor anchor) override {
    const auto known = anchors_.find(anchor);
    if (known == anchors_.end()) throw YamlFault{mark, "an alias of a value that holds it; write the value out"};
    add(known->second);
  }
  void OnScalar(const Mark& mark, const std::string& tag, Anchor anchor, const std::string& value) override {
    Open scalar = begin(YamlTree::Kind::kScalar, mark, anchor);
    scalar.node.text = value;
    scalar.node.is_quoted = tag == "!";
    close(std::move(scalar));
  }
  void OnSequenceStart(const Mark& mark, const std::string&, Anchor anchor, Style) override {
    open_.push_back(begin(YamlTree::Kind::kSequence, mark, anchor));
  }
  void OnSequenceEnd() override { closeLast(); }
  void OnMapStart(const Mark& mark, const std::string&, Anchor anchor, Style) override {
    open_.push_back(begin(YamlTree::Kind::kMap, mark, anchor));
  }
  void OnMapEnd() override { closeLast(); }

  const Mark& start() const { return start_; }
  Mark root() const {
    Mark mark = start_;
    mark.line = static_cast<int>(tree_.nodes.back().line);
    return mark;
  }
  bool isNull() const { return tree_.nodes.size() == 1 && tree_.nodes.front().kind == YamlTree::Kind::kNull; }
  YamlTree take() { return std::move(tree_); }

 private:
  struct Open {
    YamlTree::Node node;
    Anchor anchor;
  };

  static Open begin(YamlTree::Kind kind, const Mark& mark, Anchor anchor) {
    return {{kind, static_cast<std::uint64_t>(std::max(0, mark.line)), "", 0, {}}, anchor};
  }
  void add(std::uint32_t index) {
    if (!open_.empty()) open_.back().node.children.push_back(index);
  }
  void close(Open value) {
    const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes.push_back(std::move(value.node));
    if (value.anchor != YAML::NullAnchor) anchors_[value.anchor] = index;
    add(index);
  }
  void closeLast() {
    Open last = std::move(open_.back());
    open_.pop_back();
    close(std::move(last));
  }

  Mark start_;
  YamlTree tree_;
  std::vector<Open> open_;
  std::map<Anchor, std::uint32_t> anchors_;
};

/// The only document of a text; empty ones may follow. The parser stands still at what cannot begin one.
YamlTree onlyDocument(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  YamlTree result;
  int last = -1;
  for (TreeBuilder next; parser.HandleNextDocument(next); next = TreeBuilder()) {
    if (next.start().pos == last) throw YamlFault{next.start(), "not valid YAML: nothing can begin like this"};
    last = next.start().pos;
    if (result.nodes.empty()) {
      result = next.take();
    } else if (!next.isNull()) {
      throw YamlFault{next.root(), "a second document; put everything into one"};
    }
  }
  if (result.nodes.empty()) result.nodes.emplace_back();
  return result;
}

/// The line of a text that a mark is in.
std::string lineAt(const std::string& text, const YAML::Mark& mark) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i <= mark.line; ++i) std::getline(lines, line);
  return line;
}

/// yaml-cpp's reason, and what most likely led to it.
std::string reasonOf(const YAML::Exception& error, const std::string& text) {
  const auto is = [&](const char* known) { return error.msg.rfind(known, 0) == 0; };
  const std::string line = lineAt(text, error.mark), indent = line.substr(0, line.find_first_not_of(" \t"));
  std::string likely;
  if (indent.find('\t') != std::string::npos)
    likely = "; the line begins with a tab: indent with spaces";
  else if (is(YAML::ErrorMsg::UNKNOWN_ANCHOR))
    likely = "; put text that begins with '*' in quotes";
  else if (is(YAML::ErrorMsg::END_OF_MAP_FLOW))
    likely = "; an earlier '{' is not closed";
  else if (is(YAML::ErrorMsg::END_OF_SEQ_FLOW))
    likely = "; an earlier '[' is not closed";
  else if (is(YAML::ErrorMsg::END_OF_MAP) || is(YAML::ErrorMsg::END_OF_SEQ))
    likely = "; indent it as the lines that it belongs to";
  return "not valid YAML: " + error.msg + likely;
}

YamlTree treeOf(const YamlText& document, const std::string& file, ErrorCode code) {
  const auto fail = [&](const YAML::Mark& mark, const std::string& reason) {
    const std::uint64_t line = document.first_line + static_cast<std::uint64_t>(std::max(0, mark.line));
    throw Error(code, "'" + file + "', line " + std::to_string(line) + ": " + reason);
  };
  if (nestsTooDeep(document.text)) fail({}, "more than 500 brackets are open at once; close them, or nest less");
  try {
    YamlTree tree = onlyDocument(document.text);
    if (repeatedByAliases(tree) > kMostRepeated)
      fail({},
           "aliases repeat more than " + std::to_string(kMostRepeated) + " values and characters; write the document with fewer of them");
    return tree;
  } catch (const YamlFault& fault) {
    fail(fault.mark, fault.reason);
  } catch (const YAML::Exception& error) {
    fail(error.mark, reasonOf(error, document.text));
  }
  return {};
}

}  // namespace

std::vector<YamlTree> decodeYaml(const std::vector<YamlText>& documents, const std::string& file, ErrorCode code) {
  std::vector<YamlTree> trees;
  for (const YamlText& document : documents) trees.push_back(treeOf(document, file, code));
  return trees;
}

}  // namespace collision_hulls
