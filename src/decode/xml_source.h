// XML text into tinyxml2, and complaints about it that give file and line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "collision_hulls/error.h"

namespace tinyxml2 {
class XMLDocument;
}

namespace collision_hulls {

/// The text that is being parsed, and how messages name it.
struct XmlSource {
  std::string_view text;
  std::string label;
  std::size_t root_line = 1;  ///< of the root element; tinyxml2 counts lines from there
  std::size_t elements = 0;   ///< in the text, once it is loaded

  [[noreturn]] void fail(ErrorCode code, const std::string& reason) const;
  [[noreturn]] void failAt(ErrorCode code, std::size_t line, const std::string& reason) const;
  std::size_t lineFromRoot(int line) const;  ///< in the text
};

/// Checks that the text is well-formed, sets root_line and elements, and loads the root element. Entities that a document type defines are
/// not expanded. Throws kNotXml with the line.
void loadRoot(XmlSource& source, tinyxml2::XMLDocument& document);

}  // namespace collision_hulls
