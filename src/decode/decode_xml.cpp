// XML by tinyxml2, as a tree of plain values.
#include "decode/decode_xml.h"

#include <tinyxml2.h>

#include "base/string_parts.h"
#include "decode/xml_source.h"
#include "xml/xml_spans.h"

namespace collision_hulls {
namespace {

// tinyxml2 bounds the depth.
XmlNode toNode(const XmlSource& source, const tinyxml2::XMLElement& element) {
  XmlNode node;
  node.name = element.Name();
  for (const auto* a = element.FirstAttribute(); a; a = a->Next()) node.attributes[a->Name()] = a->Value();
  if (const char* text = element.GetText()) node.text = trimmed(text, kXmlSpace);
  node.line = source.lineFromRoot(element.GetLineNum());
  for (const auto* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
    node.children.push_back(toNode(source, *child));
  }
  return node;
}

}  // namespace

XmlNode decodeXml(const std::string& text, const std::string& label) {
  XmlSource source{text, label};
  tinyxml2::XMLDocument document;
  loadRoot(source, document);
  return toNode(source, *document.RootElement());
}

}  // namespace collision_hulls
