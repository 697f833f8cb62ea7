// Trimming, and extensions of file names.
#pragma once

#include <string>
#include <string_view>

namespace collision_hulls {

/// `text` without leading and trailing characters from `blanks`.
std::string trimmed(std::string_view text, std::string_view blanks);

/// A path's extension in lower case (ASCII), with the dot; empty if it has none.
std::string lowerExtension(const std::string& path);

}  // namespace collision_hulls
