// An item of --package-path: DIR, or NAME=DIR for one package.
#pragma once

#include <filesystem>
#include <string>

namespace collision_hulls {

struct PackagePlace {
  std::string package;  ///< empty: of any package
  std::filesystem::path folder;
};

/// A folder whose own name has an equals sign stays whole. Throws kBadOption if there is no such folder.
PackagePlace packagePlace(const std::string& item);

}  // namespace collision_hulls
