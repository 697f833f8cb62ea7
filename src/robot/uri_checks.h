// What a URI of a description may name, looked at before any file or program is.
#pragma once

#include <string>

namespace collision_hulls {

/// Letters, digits, '_', '-' and '.', none of the last two first. Looser than REP 144, but never an option of a program, nor a path.
bool isPackageName(const std::string& text);

/// Throws kFileNotFound for a name in a URI that is no package's.
void checkPackageName(const std::string& uri, const std::string& name);

/// Throws kOutsideRoots where a path in a URI leads out of the package or model `name`, if only on its way.
void checkStaysWithin(const std::string& uri, const std::string& name, const std::string& path);

}  // namespace collision_hulls
