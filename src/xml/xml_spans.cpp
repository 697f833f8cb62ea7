// A scanner for the positions of elements. XML libraries print a document anew; rewriting in place needs the bytes of the original.
#include "xml/xml_spans.h"

#include <algorithm>
#include <set>
#include <string>

#include "base/string_parts.h"

namespace collision_hulls {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// XML libraries compare each attribute with all before it. The elements of descriptions have a dozen.
constexpr std::size_t kMostAttributes = 1000;

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {
    if (text_.substr(0, kByteOrderMark.size()) == kByteOrderMark) at_ = kByteOrderMark.size();
  }

  XmlOutline run() {
    while (skipCharacters()) markup();
    if (!open_.empty()) fail(elements_[open_.back()].begin, "<" + std::string(elements_[open_.back()].name) + "> is never closed");
    if (elements_.empty()) fail(0, text_.find('<') == std::string_view::npos ? "it is empty" : "there is no element");
    return {std::move(elements_), std::move(instructions_)};
  }

 private:
  [[noreturn]] static void fail(std::size_t offset, const std::string& reason) {
    throw XmlSyntaxError(offset, reason + "; the text has to be XML");
  }

  bool startsWith(std::string_view prefix) const { return text_.substr(at_, prefix.size()) == prefix; }

  // To the next '<'; false at the end of the text. Outside the root only white space may stand.
  bool skipCharacters() {
    const std::size_t next = std::min(text_.find('<', at_), text_.size());
    if (open_.empty()) {
      const std::size_t stray = text_.find_first_not_of(kXmlSpace, at_);
      if (stray < next) fail(stray, "there is text outside the root element");
    }
    at_ = next;
    return at_ < text_.size();
  }

  void markup() {
    if (startsWith("<!--")) return skipPast("<!--", "-->", "a comment");
    if (startsWith("<![CDATA[")) return skipPast("<![CDATA[", "]]>", "a CDATA section");
    if (startsWith("<?")) return skipInstruction();
    if (startsWith("<!DOCTYPE")) return skipDocumentType();
    if (startsWith("</")) return endTag();
    startTag();
  }

  void skipPast(std::string_view opening, std::string_view closing, const char* what) {
    const std::size_t close = text_.find(closing, at_ + opening.size());
    if (close == std::string_view::npos) fail(at_, std::string(what) + " is never closed");
    at_ = close + closing.size();
  }

  void skipInstruction() {
    const std::size_t begin = at_;
    skipPast("<?", "?>", "a processing instruction");
    instructions_.push_back({begin, at_});
  }

  // The '>' that ends a document type is outside quotes, comments and the brackets of its internal subset.
  void skipDocumentType() {
    const std::size_t begin = at_;
    int brackets = 0;
    while (++at_ < text_.size()) {
      const char c = text_[at_];
      if (startsWith("<!--")) {
        skipPast("<!--", "-->", "a comment");
        --at_;
      } else if (c == '"' || c == '\'') {
        at_ = std::min(text_.find(c, at_ + 1), text_.size());
      } else if (c == '[' || c == ']') {
        brackets += c == '[' ? 1 : -1;
      } else if (c == '>' && brackets <= 0) {
        ++at_;
        return;
      }
    }
    fail(begin, "the document type is never closed");
  }

  std::string_view readName() {
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(" \t\r\n=/><\"'", at_), text_.size());
    return text_.substr(begin, at_ - begin);
  }

  void skipSpace() { at_ = std::min(text_.find_first_not_of(kXmlSpace, at_), text_.size()); }

  void startTag() {
    XmlElement element;
    element.begin = at_++;
    element.name = readName();
    if (element.name.empty()) fail(element.begin, "'<' is not followed by a name");
    if (open_.empty() && !elements_.empty()) fail(element.begin, "there is a second root element, <" + std::string(element.name) + ">");
    attributes_.clear();
    while (attribute(element)) {
      if (attributes_.size() > kMostAttributes)
        throw XmlSyntaxError(element.begin, "<" + std::string(element.name) + "> has more than " + std::to_string(kMostAttributes) +
                                                " attributes; remove some");
    }
    element.self_closing = text_[at_] == '/';
    at_ += element.self_closing ? 2 : 1;
    element.tag_end = element.end = at_;
    elements_.push_back(element);
    elements_.back().subtree_end = elements_.size();
    if (!element.self_closing) open_.push_back(elements_.size() - 1);
  }

  // Past the next attribute; false where the tag's end ("/>" or ">") comes instead.
  bool attribute(const XmlElement& element) {
    skipSpace();
    if (startsWith(">") || startsWith("/>")) return false;
    const std::size_t begin = at_;
    const std::string tag = "<" + std::string(element.name) + ">";
    const std::string name(readName());
    if (at_ == text_.size()) fail(element.begin, "the tag " + tag + " is never closed");
    if (name.empty()) fail(begin, "'" + std::string(1, text_[at_]) + "' has no place within the tag " + tag);
    skipSpace();
    if (!startsWith("=")) fail(begin, "attribute '" + name + "' of " + tag + " has no value");
    if (!attributes_.insert(name).second) throw XmlSyntaxError(begin, "attribute '" + name + "' of " + tag + " appears twice; remove one");
    ++at_;
    skipSpace();
    if (!startsWith("\"") && !startsWith("'")) fail(begin, "the value of attribute '" + name + "' of " + tag + " is not in quotes");
    const std::size_t close = text_.find(text_[at_], at_ + 1);
    if (close == std::string_view::npos) fail(begin, "the quotes of attribute '" + name + "' of " + tag + " are never closed");
    at_ = close + 1;
    return true;
  }

  void endTag() {
    const std::size_t begin = at_;
    at_ += 2;
    const std::string name(readName());
    skipSpace();
    if (!startsWith(">")) fail(begin, "the tag </" + name + "> is never closed");
    if (open_.empty()) fail(begin, "</" + name + "> closes nothing");
    XmlElement& element = elements_[open_.back()];
    if (name != element.name) {
      fail(begin, "</" + name + "> stands where <" + std::string(element.name) + "> of line " +
                      std::to_string(lineOf(text_, element.begin)) + " has to be closed");
    }
    element.end = ++at_;
    element.subtree_end = elements_.size();
    open_.pop_back();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<XmlElement> elements_;
  std::vector<XmlSpan> instructions_;
  std::vector<std::size_t> open_;     // elements whose end tag has not come yet
  std::set<std::string> attributes_;  // of the tag that is read
};

}  // namespace

XmlOutline scanXml(std::string_view text) {
  return Scanner(text).run();
}

std::vector<std::size_t> childrenNamed(const std::vector<XmlElement>& elements, std::size_t parent, std::string_view name) {
  std::vector<std::size_t> children;
  for (std::size_t i = parent + 1; i < elements[parent].subtree_end; i = elements[i].subtree_end) {
    if (elements[i].name == name) children.push_back(i);
  }
  return children;
}

std::optional<XmlSpan> attributeValue(std::string_view text, const XmlElement& element, std::string_view name) {
  std::size_t at = element.begin + 1 + element.name.size();
  while (true) {
    at = std::min(text.find_first_not_of(kXmlSpace, at), element.tag_end);
    const std::size_t equals = text.find('=', at), quote = text.find_first_of("\"'", at);
    if (equals >= element.tag_end || quote >= element.tag_end) return std::nullopt;
    const std::size_t close = text.find(text[quote], quote + 1);
    if (trimmed(text.substr(at, equals - at), kXmlSpace) == name) return XmlSpan{quote + 1, close};
    at = close + 1;
  }
}

std::size_t lineOf(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

}  // namespace collision_hulls
