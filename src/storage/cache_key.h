// The secret that seals the entries of a cache.
#pragma once

#include <filesystem>
#include <string>

namespace collision_hulls {

/// A cache folder's key, if it has one that can be trusted.
struct CacheKey {
  std::string bytes;  ///< 32 random ones; empty without a key
  std::string fault;  ///< why folder or key must not be used, and what to do about it; empty if there is no folder or no key yet
};

/// Reads `key` in the folder. A folder or key that others can write, or that belongs to another user than this one or root, is a fault, and
/// so is a key that others can read.
CacheKey readCacheKey(const std::filesystem::path& folder);

/// Makes the folder and its key, unless they are there: processes that do so at the same time agree on one. Returns what went wrong, or "".
std::string makeCacheKey(const std::filesystem::path& folder);

/// Writes a new file for this user alone, hidden and with a name of its own, beside the entries. Returns what went wrong, or "".
std::string writeUnfinished(const std::filesystem::path& folder, const std::string& content, std::filesystem::path& file);

/// How the names of such files begin, which may be left by a process that was killed.
constexpr const char* kUnfinished = ".unfinished-";

}  // namespace collision_hulls
