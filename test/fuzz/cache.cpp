// Entries of the cache: whatever was stored under a name, with the owner's seal. The first byte chooses the kind.
#include "pipeline/cache.h"

#include <filesystem>

#include "fuzz/target.h"

namespace collision_hulls::fuzz {
namespace {

void takeEntry(const std::string& input) {
  static const std::filesystem::path folder = std::filesystem::path(fileOf("", "")).parent_path() / "cache";
  static const std::string key(64, 'a');
  std::string bytes = input;
  const unsigned char kind = firstOf(bytes) % 3;
  CacheFolder(folder, Cache::kMostBytes).store(key + (kind == 0 ? ".mesh" : kind == 1 ? ".tree" : ".validation"), bytes);
  Cache cache(folder);
  if (kind == 0) {
    cache.findMesh(key, "");
  } else if (kind == 1) {
    cache.findTree(key);
  } else {
    cache.findValidation(key);
  }
}

const Registered kCache("cache", takeEntry);

}  // namespace
}  // namespace collision_hulls::fuzz
