// What no URI may hold, looked at before any file or program is.
#pragma once

#include <cstddef>
#include <string>

namespace collision_hulls {

/// Letters, digits, '_', '-' and '.', none of the last two first. Looser than REP 144, but never an option of a program, nor a path.
bool isPackageName(const std::string& text);

/// The most bytes that a path can have.
constexpr std::size_t kLongestUri = 4096;

/// A text for messages: control characters as "?", and shortened().
std::string shown(const std::string& text);

/// Throws kFileNotFound for a URI of more than kLongestUri bytes, and for one with control characters, be they
/// percent-encoded ("%00").
void checkCharacters(const std::string& uri);

/// Throws kFileNotFound for a name in a URI that is no package's.
void checkPackageName(const std::string& uri, const std::string& name);

/// Throws kOutsideRoots where a path in a URI leads out of the package or model `name`, if only on its way.
void checkStaysWithin(const std::string& uri, const std::string& name, const std::string& path);

/// "%20" and its like become the bytes that they stand for; a '%' without two digits stays.
std::string percentDecoded(const std::string& text);

}  // namespace collision_hulls
