// Loads a description with tinyxml2, and refuses first what tinyxml2 accepts or misreads.
#include "decode/xml_source.h"

#include <tinyxml2.h>

#include <algorithm>

#include "xml/xml_spans.h"

namespace collision_hulls {
namespace {

void checkEncoding(const XmlSource& source) {
  const std::string_view mark = source.text.substr(0, 2);
  if (mark == "\xFF\xFE" || mark == "\xFE\xFF") source.fail(ErrorCode::kNotXml, "the text is UTF-16; save it as UTF-8");
  const std::size_t zero = source.text.find('\0');
  if (zero != std::string_view::npos) {
    source.failAt(ErrorCode::kNotXml, lineOf(source.text, zero), "a zero byte, which XML text never holds");
  }
}

XmlOutline scan(const XmlSource& source) {
  try {
    return scanXml(source.text);
  } catch (const XmlSyntaxError& error) {
    source.failAt(ErrorCode::kNotXml, lineOf(source.text, error.offset()), error.what());
  }
}

// The root alone and without processing instructions, which are legal XML: tinyxml2 ends a document type at its first '>', even
// within an internal subset, and takes every instruction for a misplaced XML declaration. Lines stay what they were.
std::string readableRoot(const XmlSource& source, const XmlOutline& outline) {
  std::string text(source.text.substr(0, outline.elements.front().end));
  for (const XmlSpan& span : outline.instructions) {
    for (std::size_t i = span.begin; i < std::min(span.end, text.size()); ++i) text[i] = text[i] == '\n' ? '\n' : ' ';
  }
  return text.substr(outline.elements.front().begin);
}

}  // namespace

void XmlSource::fail(ErrorCode code, const std::string& reason) const {
  throw Error(code, label + ": " + reason);
}

void XmlSource::failAt(ErrorCode code, std::size_t line, const std::string& reason) const {
  throw Error(code, label + ", line " + std::to_string(line) + ": " + reason);
}

std::size_t XmlSource::lineFromRoot(int line) const {
  return root_line + static_cast<std::size_t>(line) - 1;
}

void loadRoot(XmlSource& source, tinyxml2::XMLDocument& document) {
  checkEncoding(source);
  const XmlOutline outline = scan(source);
  source.elements = outline.elements.size();
  source.root_line = lineOf(source.text, outline.elements.front().begin);
  const std::string root = readableRoot(source, outline);
  document.Parse(root.data(), root.size());
  if (!document.Error() && !document.RootElement())
    source.fail(ErrorCode::kNotXml, "the name of an element is not allowed in XML; correct it");
  if (!document.Error()) return;
  const std::size_t line = source.lineFromRoot(document.ErrorLineNum());
  if (document.ErrorID() == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    source.failAt(ErrorCode::kNotXml, line, "elements nest deeper than " + std::to_string(TINYXML2_MAX_ELEMENT_DEPTH) + " levels");
  }
  source.failAt(ErrorCode::kNotXml, line, std::string("the XML cannot be read (") + document.ErrorName() + ")");
}

}  // namespace collision_hulls
