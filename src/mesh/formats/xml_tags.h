// The tags of an XML text, one after another.
#pragma once

#include <string>
#include <string_view>

namespace collision_hulls {

struct XmlTag {
  std::string_view name;
  std::string_view attributes;  ///< the text between the name and the end of the tag
  bool opens = false;           ///< <name> or <name/>
  bool closes = false;          ///< </name> or <name/>

  /// The value of an attribute; empty if it is missing.
  std::string_view attribute(std::string_view key) const;
};

/// Takes the next tag off the front of `rest`, skipping text, comments, CDATA and declarations; false if no complete tag is left.
bool nextTag(std::string_view* rest, XmlTag* tag);

}  // namespace collision_hulls
