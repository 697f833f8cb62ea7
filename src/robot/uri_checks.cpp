// The name of a package in a URI becomes an argument of rospack: "-h" would be an option.
#include "robot/uri_checks.h"

#include <algorithm>

#include "base/uri_text.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

// ASCII by hand: the C functions depend on the locale.
bool isLetterOrDigit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

}  // namespace

bool isPackageName(const std::string& text) {
  const auto allowed = [](char c) { return isLetterOrDigit(c) || c == '_' || c == '-' || c == '.'; };
  return !text.empty() && text.front() != '-' && text.front() != '.' && std::all_of(text.begin(), text.end(), allowed);
}

void checkPackageName(const std::string& uri, const std::string& name) {
  if (isPackageName(name)) return;
  throw Error(ErrorCode::kFileNotFound, "'" + shown(name) + "' of '" + shown(uri) +
                                            "' is not a package's name: it takes letters, digits, '_', '-' and '.', and begins with a "
                                            "letter, a digit or '_'");
}

void checkStaysWithin(const std::string& uri, const std::string& name, const std::string& path) {
  if (name == ".." || leadsOut(path))
    throw Error(ErrorCode::kOutsideRoots,
                "'" + shown(uri) + "' leads out of '" + shown(name) + "'; name the package or model that it is in");
}

}  // namespace collision_hulls
