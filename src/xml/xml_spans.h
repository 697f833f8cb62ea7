// Where the elements of an XML text stand, byte by byte: what rewriting in place needs and XML libraries do not tell.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace collision_hulls {

/// One element, as offsets into the text. Elements stand in document order, so the descendants of element i are the
/// elements i + 1 .. subtree_end - 1.
struct XmlElement {
  std::string_view name;        ///< as written, with its prefix
  std::size_t begin = 0;        ///< of '<'
  std::size_t tag_end = 0;      ///< just past the start tag's '>'
  std::size_t end = 0;          ///< just past the element's last '>'
  std::size_t subtree_end = 0;  ///< index of the first element after this one's descendants
  bool self_closing = false;
};

struct XmlSpan {
  std::size_t begin = 0, end = 0;
};

struct XmlOutline {
  std::vector<XmlElement> elements;   ///< the first is the root
  std::vector<XmlSpan> instructions;  ///< processing instructions, the XML declaration among them
};

/// Thrown for a text that is not well-formed.
class XmlSyntaxError : public std::runtime_error {
 public:
  XmlSyntaxError(std::size_t offset, const std::string& reason) : std::runtime_error(reason), offset_(offset) {}
  std::size_t offset() const { return offset_; }

 private:
  std::size_t offset_;
};

/// What stands where in `text`, which must outlive the result. Knows comments, CDATA, processing instructions,
/// a document type with internal subset, and both kinds of quotes. Does not look at character data or decode entities.
/// Linear in the text's length, no recursion. Throws XmlSyntaxError.
XmlOutline scanXml(std::string_view text);

/// Indices of the children of element `parent` that are called `name`.
std::vector<std::size_t> childrenNamed(const std::vector<XmlElement>& elements, std::size_t parent, std::string_view name);

/// Where the value of an attribute of `element` stands, without its quotes; nullopt if the element does not have the attribute.
std::optional<XmlSpan> attributeValue(std::string_view text, const XmlElement& element, std::string_view name);

/// Number of the line (from 1) that holds the byte at `offset`.
std::size_t lineOf(std::string_view text, std::size_t offset);

/// White space as XML knows it.
constexpr std::string_view kXmlSpace = " \t\r\n";

}  // namespace collision_hulls
