// The tags of an XML text, one after the other.
#pragma once

#include <string>
#include <string_view>

namespace collision_hulls {

struct XmlTag {
  std::string_view name;
  std::string_view attributes;  ///< the text between the name and the end
  bool opens = false;           ///< <name> or <name/>
  bool closes = false;          ///< </name> or <name/>

  /// The value of an attribute; empty if it is not there.
  std::string_view attribute(std::string_view key) const;
};

/// Takes the next tag off the front of `rest`, past text, comments, CDATA and declarations; false if none is whole.
bool nextTag(std::string_view* rest, XmlTag* tag);

}  // namespace collision_hulls
