// Text in HTML. What a description or a message says is foreign: it never becomes markup.
#pragma once

#include <cstddef>
#include <string>

namespace collision_hulls {

/// As the text of an element, or as an attribute's value between quotes of either kind. Bytes that HTML forbids become U+FFFD.
std::string escapedHtml(const std::string& text);

/// JSON as the text of a <script> element, where no HTML is unescaped: '<', which JSON has in strings alone, becomes \u003c.
std::string scriptJson(std::string json);

/// "26,202"
std::string grouped(std::size_t number);

}  // namespace collision_hulls
