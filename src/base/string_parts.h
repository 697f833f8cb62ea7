// Trimming, shortening, listing, and extensions of file names.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace collision_hulls {

/// `text` without leading and trailing characters from `blanks`.
std::string trimmed(std::string_view text, std::string_view blanks);

/// `text` for a message: of one that is longer than `most` bytes, the start, the length and the end. Never cuts a character of UTF-8.
std::string shortened(const std::string& text, std::size_t most = 200);

/// "a, b, c".
template <class Texts>
std::string listed(const Texts& texts, const std::string& between = ", ") {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : between) + text;
  return list;
}

/// "a, b and 3 more": the first `most`.
template <class Texts>
std::string listedFirst(Texts texts, std::size_t most) {
  const std::size_t more = texts.size() - std::min(most, texts.size());
  texts.resize(texts.size() - more);
  return listed(texts) + (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

std::string inLowerCase(std::string text);  ///< ASCII letters

std::string lastPart(const std::string& uri);  ///< behind the last slash

/// A path's extension in lower case (ASCII), with the dot; empty if it has none.
std::string lowerExtension(const std::string& path);

}  // namespace collision_hulls
