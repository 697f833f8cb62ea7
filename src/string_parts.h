// Parts of strings.
#pragma once

#include <string>
#include <string_view>

namespace collision_hulls {

/// Without the given characters at its begin and its end.
std::string trimmed(std::string_view text, std::string_view blanks);

/// The extension of a path in lower case (ASCII), with the dot; empty where there is none.
std::string lowerExtension(const std::string& path);

}  // namespace collision_hulls
