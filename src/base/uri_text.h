// What a URI may be spelled with, looked at before any file is.
#pragma once

#include <cstddef>
#include <string>

namespace collision_hulls {

/// The most bytes that a path can have.
constexpr std::size_t kLongestUri = 4096;

/// ASCII's control characters, line ends and tabs among them.
bool isControl(char c);

/// Those that a terminal obeys: all but line ends and tabs.
bool isTerminalControl(char c);

/// A text for messages: control characters as "?", and shortened().
std::string shown(const std::string& text);

/// Throws kFileNotFound for a URI of more than kLongestUri bytes, and for one with control characters, be they
/// percent-encoded ("%00").
void checkCharacters(const std::string& uri);

/// Whether a path leads out of the folder that it is relative to, if only on its way, or is absolute.
bool leadsOut(const std::string& path);

/// "%20" and its like become the bytes that they stand for; a '%' without two digits stays.
std::string percentDecoded(const std::string& text);

}  // namespace collision_hulls
