// Small files by name that other processes write at the same time: the cache's place on the disk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace collision_hulls {

/// $COLLISION_HULLS_CACHE, else collision_hulls in $ROS_HOME, else ~/.ros/collision_hulls; empty where not even HOME is set.
std::filesystem::path cacheFolder();

/// Entries of a folder. An entry appears whole or not at all (it is written beside its place and renamed), and may vanish at any time.
/// Nothing here throws: what fails is an entry that is not there, and a note. Thread safe.
class CacheFolder {
 public:
  /// `folder` is made with the first entry; empty: keeps nothing. `most_bytes`: what trim() leaves.
  CacheFolder(std::filesystem::path folder, std::uintmax_t most_bytes);

  /// The content of an entry, which then counts as new again.
  std::optional<std::string> find(const std::string& name);
  void store(const std::string& name, const std::string& content);
  /// Removes an entry whose content is damaged.
  void discard(const std::string& name);

  /// Once something was stored: removes what killed processes left, and the oldest entries of all until the rest is small enough.
  void trim();

  /// What the user should know: entries that could not be written, entries that were damaged.
  std::vector<std::string> notes() const;

  /// Whether a file of this name is an entry: 64 hexadecimal digits, a point, letters. No other file is ever removed.
  static bool isEntry(const std::string& name);

 private:
  std::string write(const std::string& name, const std::string& content) const;

  const std::filesystem::path folder_;
  const std::uintmax_t most_bytes_;
  mutable std::mutex mutex_;
  bool stored_ = false;
  std::size_t damaged_ = 0;
  std::string trouble_;  // why the first entry that failed could not be written
};

}  // namespace collision_hulls
