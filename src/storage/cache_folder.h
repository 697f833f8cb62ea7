// The cache's folder on disk: small named files that several processes may write at the same time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "storage/cache_key.h"

namespace collision_hulls {

/// $COLLISION_HULLS_CACHE, else collision_hulls in $ROS_HOME, else ~/.ros/collision_hulls; empty if not even HOME is set.
std::filesystem::path cacheFolder();

/// The entries of a folder. An entry appears complete or not at all (it is written to a temporary file and renamed), and may vanish at any
/// time. What is found was stored under this name by somebody who can read the folder's key, which only its owner can: see cache_key.h.
/// Nothing here throws, but for a lack of memory: after a failure the entry is simply not there, and a note says why. Thread safe.
class CacheFolder {
 public:
  /// `folder` is created with the first entry; empty: nothing is stored. `most_bytes`: the size to which trim() reduces the folder.
  CacheFolder(std::filesystem::path folder, std::uintmax_t most_bytes);

  /// The content of an entry, which is thereby the most recently used. An entry that is damaged, or that others could have written, is
  /// discarded.
  std::optional<std::string> find(const std::string& name);
  void store(const std::string& name, const std::string& content);
  /// Removes an entry whose content is damaged; counts it.
  void discard(const std::string& name);

  /// If anything was stored: removes files left by killed processes, and the least recently used entries until the rest is small enough.
  void trim();
  /// The same, unless some process has done so within the last minute: it looks at every entry, and thousands of short runs would spend
  /// their time on that.
  void trimNowAndThen();

  /// For the user: why the folder was not used; entries that were discarded; why entries could not be written.
  std::vector<std::string> notes() const;

  /// Whether a file of this name is an entry: 64 hexadecimal digits, a point, letters. No other file is ever removed.
  static bool isEntry(const std::string& name);

 private:
  enum class Missing { kFind, kMake };  ///< what to do about a key that is not there

  std::string key(Missing missing);
  std::string write(const std::string& name, const std::string& content, const std::string& key) const;

  const std::filesystem::path folder_;
  const std::uintmax_t most_bytes_;
  mutable std::mutex mutex_;
  CacheKey key_;
  bool stored_ = false;
  std::size_t damaged_ = 0;
  std::string trouble_;  // why the first entry that failed could not be written
};

}  // namespace collision_hulls
