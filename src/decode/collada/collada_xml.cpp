// The one door to the XML parser. What it cannot be trusted with is looked at before (how many elements) or afterwards (declarations).
#include "decode/collada/collada_xml.h"

#include <algorithm>

#include "collision_hulls/error.h"
#include "mesh/formats/number.h"
#include "mesh/formats/scan.h"

namespace collision_hulls {
namespace {

/// Each element takes about a hundred bytes of memory, and perhaps four of the file.
constexpr std::ptrdiff_t kMostElements = 5'000'000;

/// tinyxml2 compares each attribute of an element with all before.
constexpr std::size_t kMostAttributes = 200;

/// Throws kTooLarge for more elements, or more attributes of one, than the parser can take. Counts a little too many: what looks like one.
void checkSize(std::string_view text, const std::string& path) {
  if (std::count(text.begin(), text.end(), '<') > kMostElements)
    throw Error(ErrorCode::kTooLarge, path + ": more than " + std::to_string(kMostElements) + " elements; write its polygons as one list");
  std::size_t attributes = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '<') attributes = 0;
    if (text[i] != '=') continue;
    const std::size_t next = text.find_first_not_of(" \t\r\n", i + 1);
    if (next == std::string_view::npos || (text[next] != '"' && text[next] != '\'')) continue;
    if (++attributes > kMostAttributes)
      throw Error(ErrorCode::kTooLarge,
                  path + ": an element with more than " + std::to_string(kMostAttributes) + " attributes; remove some");
  }
}

/// DOCTYPE and others like it, which tinyxml2 keeps as unknown nodes.
void expectNoDeclarations(const tinyxml2::XMLNode& parent, const std::string& path) {
  for (const tinyxml2::XMLNode* node = parent.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToUnknown() != nullptr)
      failNotAMesh(path, static_cast<std::size_t>(node->GetLineNum()), "a declaration such as DOCTYPE, which is not supported",
                   "remove it");
    expectNoDeclarations(*node, path);  // as deep as tinyxml2 lets elements nest
  }
}

}  // namespace

const ColladaElement& parseCollada(const std::string& bytes, const std::string& path, tinyxml2::XMLDocument* document) {
  checkedText(bytes, path);
  checkSize(bytes, path);
  const tinyxml2::XMLError error = document->Parse(bytes.data(), bytes.size());
  const auto line = static_cast<std::size_t>(document->ErrorLineNum());
  if (error == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) failNotAMesh(path, line, "elements nest too deeply");
  if (error != tinyxml2::XML_SUCCESS) failNotAMesh(path, line, std::string("not well-formed XML (") + document->ErrorName() + ")");
  expectNoDeclarations(*document, path);
  const ColladaElement* root = document->RootElement();
  if (root == nullptr || !isNamed(*root, "COLLADA") || root->NextSiblingElement() != nullptr)
    failNotAMesh(path, "is not a document with <COLLADA> as its only root");
  return *root;
}

void failElement(const std::string& path, const ColladaElement& element, const std::string& reason) {
  failNotAMesh(path, static_cast<std::size_t>(element.GetLineNum()), "<" + std::string(element.Name()).substr(0, 40) + "> " + reason);
}

bool isNamed(const ColladaElement& element, std::string_view name) {
  return element.Name() == name;
}

std::string_view attributeOf(const ColladaElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

std::size_t countOf(const std::string& path, const ColladaElement& element, const char* name, std::size_t otherwise, std::size_t most) {
  if (element.Attribute(name) == nullptr) return otherwise;
  std::int64_t value = 0;
  if (!parseInteger(attributeOf(element, name), &value) || value < 0 || static_cast<std::size_t>(value) > most)
    failElement(path, element,
                "has " + std::string(name) + " = " + inQuotes(attributeOf(element, name)) + "; expected an integer from 0 to " +
                    std::to_string(most));
  return static_cast<std::size_t>(value);
}

std::string_view targetOf(const std::string& path, const ColladaElement& element, const char* attribute) {
  const std::string_view url = attributeOf(element, attribute);
  if (url.empty() || url[0] != '#')
    failElement(path, element, "refers to " + inQuotes(url) + ", not to something in this file; put everything into one file");
  return url.substr(1);
}

std::string_view textOf(const std::string& path, const ColladaElement& element) {
  const tinyxml2::XMLText* text = nullptr;
  for (const tinyxml2::XMLNode* node = element.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToText() == nullptr || text != nullptr) failElement(path, element, "holds more than a text");
    text = node->ToText();
  }
  return text == nullptr ? std::string_view() : std::string_view(text->Value());
}

std::vector<const ColladaElement*> childrenOf(const ColladaElement& element, const char* name) {
  std::vector<const ColladaElement*> children;
  for (const ColladaElement* child = element.FirstChildElement(name); child != nullptr; child = child->NextSiblingElement(name))
    children.push_back(child);
  return children;
}

const ColladaElement* onlyChild(const std::string& path, const ColladaElement& element, const char* name) {
  const ColladaElement* child = element.FirstChildElement(name);
  if (child != nullptr && child->NextSiblingElement(name) != nullptr)
    failElement(path, element, "holds more than one <" + std::string(name) + ">");
  return child;
}

}  // namespace collision_hulls
