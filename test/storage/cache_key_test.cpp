// What a key protects is tested in cache_folder_test.cpp.
#include "storage/cache_key.h"

#include <gtest/gtest.h>

#include "pipeline/fixtures.h"
#include "umask.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;

TEST(CacheKey, IsMadeOnceForItsOwnerAlone) {
  const fixtures::TempFolder folder;
  const fs::path cache = folder / "deep/cache";
  EXPECT_EQ(readCacheKey(cache).bytes, "");
  EXPECT_EQ(readCacheKey(cache).fault, "");
  EXPECT_FALSE(fs::exists(cache)) << "reading makes nothing";
  EXPECT_EQ(makeCacheKey(cache), "");
  const std::string key = readCacheKey(cache).bytes;
  EXPECT_EQ(key.size(), 32u);
  EXPECT_EQ(makeCacheKey(cache), "");
  EXPECT_EQ(readCacheKey(cache).bytes, key);
  EXPECT_EQ(fs::status(cache / "key").permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(fixtures::contents(cache).size(), 1u) << "and nothing beside it";
  EXPECT_EQ(makeCacheKey(folder / "other"), "");
  EXPECT_NE(readCacheKey(folder / "other").bytes, key);
}

// Some systems let a user's group write by default.
TEST(CacheKey, ItsFolderIsForItsOwnerAloneWhateverTheUmask) {
  const fixtures::TempFolder folder;
  const Umask lax(0002);
  for (const char* const name : {"a", "b/c", "d/", "e/f/"}) {
    EXPECT_EQ(makeCacheKey(folder / name), "") << name;
    EXPECT_EQ(readCacheKey(folder / name).bytes.size(), 32u) << name << ": " << readCacheKey(folder / name).fault;
  }
}

TEST(CacheKey, WhereNoneCanBeMade) {
  const fixtures::TempFolder folder;
  const std::string file = fixtures::write(folder / "file", "");
  for (const std::string& place : {file, file + "/cache", std::string("/proc/cache")}) {
    EXPECT_NE(makeCacheKey(place), "") << place;
    EXPECT_EQ(readCacheKey(place).bytes, "") << place;
  }
}

}  // namespace
}  // namespace collision_hulls
