#include "storage/cache_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using fixtures::TempFolder;
using Names = std::vector<std::string>;

constexpr std::uintmax_t kPlenty = 1'000'000;

std::string entry(char digit) {
  return std::string(64, digit) + ".element";
}

void age(const fs::path& file, int hours) {
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(hours));
}

Names namesIn(const fs::path& folder) {
  Names names;
  for (const auto& [name, content] : fixtures::contents(folder)) names.push_back(name);
  return names;
}

TEST(CacheFolder, WithoutAFolderItStoresNothing) {
  CacheFolder cache("", kPlenty);
  cache.store(entry('a'), "content");
  EXPECT_EQ(cache.find(entry('a')), std::nullopt);
  cache.trim();
  EXPECT_EQ(cache.notes(), Names());
}

TEST(CacheFolder, IsCreatedWithTheFirstEntry) {
  const TempFolder folder;
  CacheFolder cache(folder / "a/b", kPlenty);
  EXPECT_EQ(cache.find(entry('a')), std::nullopt);
  cache.trim();
  EXPECT_FALSE(fs::exists(folder / "a"));
  const std::string content("any\0bytes", 9);
  cache.store(entry('a'), content);
  EXPECT_EQ(cache.find(entry('a')), content);
  EXPECT_EQ(cache.find(entry('b')), std::nullopt);
  cache.store(entry('a'), "other");
  EXPECT_EQ(CacheFolder(folder / "a/b", kPlenty).find(entry('a')), "other");
  EXPECT_EQ(namesIn(folder.path()), Names{"a/b/" + entry('a')}) << "and nothing beside it";
  EXPECT_EQ(cache.notes(), Names());
}

TEST(CacheFolder, NotesAFolderThatCannotBeWritten) {
  const TempFolder folder;
  const std::string file = fixtures::write(folder / "file", "");
  for (const std::string& place : {file, file + "/cache"}) {
    CacheFolder cache(place, kPlenty);
    cache.store(entry('a'), "content");
    cache.store(entry('b'), "content");
    EXPECT_EQ(cache.find(entry('a')), std::nullopt);
    cache.trim();
    ASSERT_EQ(cache.notes().size(), 1u);
    for (const std::string& part : {place, std::string("COLLISION_HULLS_CACHE")})
      EXPECT_NE(cache.notes()[0].find(part), std::string::npos) << cache.notes()[0];
  }
  if (geteuid() != 0) {  // root may write everywhere
    fs::create_directory(folder / "locked");
    fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    CacheFolder cache(folder / "locked", kPlenty);
    cache.store(entry('a'), "content");
    EXPECT_EQ(cache.notes().size(), 1u);
  }
}

TEST(CacheFolder, DamagedEntriesAreRemovedAndCounted) {
  const TempFolder folder;
  CacheFolder cache(folder.path(), kPlenty);
  for (const char digit : {'a', 'b'}) {
    cache.store(entry(digit), "content");
    cache.discard(entry(digit));
    EXPECT_EQ(cache.find(entry(digit)), std::nullopt);
  }
  ASSERT_EQ(cache.notes().size(), 1u);
  EXPECT_NE(cache.notes()[0].find("2 damaged"), std::string::npos) << cache.notes()[0];
}

TEST(CacheFolder, FolderInPlaceOfAnEntry) {
  const TempFolder folder;
  fs::create_directories(folder / entry('a') + "/more");
  CacheFolder cache(folder.path(), kPlenty);
  EXPECT_EQ(cache.find(entry('a')), std::nullopt);
  cache.store(entry('a'), "content");
  EXPECT_EQ(cache.notes().size(), 1u);
  EXPECT_TRUE(namesIn(folder.path()).empty()) << "the unfinished file is still there";
}

TEST(CacheFolder, NamesOfEntries) {
  EXPECT_TRUE(CacheFolder::isEntry(entry('0')));
  EXPECT_TRUE(CacheFolder::isEntry(entry('f')));
  for (const std::string& name : {std::string(), std::string("thesis.tex"), entry('g'), entry('A'), entry('a') + "~", std::string(64, 'a'),
                                  std::string(64, 'a') + ".", "a" + entry('a'), entry('a').substr(1)})
    EXPECT_FALSE(CacheFolder::isEntry(name)) << name;
}

TEST(CacheFolder, TrimRemovesTheOldestEntriesAndNothingElse) {
  const TempFolder folder;
  fixtures::write(folder / "thesis.tex", std::string(1000, 'x'));
  age(folder / "thesis.tex", 9);
  CacheFolder cache(folder.path(), 100);
  for (const char digit : {'a', 'b', 'c', 'd', 'e'}) cache.store(entry(digit), std::string(25, digit));
  int hours = 9;
  for (const char digit : {'b', 'a', 'c', 'e', 'd'}) age(folder / entry(digit), hours--);
  EXPECT_TRUE(cache.find(entry('b'))) << "and is now the most recently used";
  cache.trim();
  EXPECT_EQ(namesIn(folder.path()), (Names{entry('b'), entry('c'), entry('d'), entry('e'), "thesis.tex"}));
}

TEST(CacheFolder, RefusesAnEntryThatWouldEvictTheOthers) {
  const TempFolder folder;
  CacheFolder cache(folder.path(), 100);
  cache.store(entry('a'), std::string(26, 'a'));
  EXPECT_EQ(cache.find(entry('a')), std::nullopt);
  EXPECT_EQ(cache.notes().size(), 1u);
}

TEST(CacheFolder, TrimRemovesFilesOfKilledProcesses) {
  const TempFolder folder;
  fixtures::write(folder / ".unfinished-old", "");
  age(folder / ".unfinished-old", 2);
  fixtures::write(folder / ".unfinished-new", "");
  CacheFolder cache(folder.path(), kPlenty);
  cache.trim();
  EXPECT_EQ(namesIn(folder.path()).size(), 2u) << "a run that stores nothing must not trim";
  cache.store(entry('a'), "content");
  cache.trim();
  EXPECT_EQ(namesIn(folder.path()), (Names{".unfinished-new", entry('a')}));
}

// Readers must see one of the stored contents, complete, whoever else writes or trims.
TEST(CacheFolder, ManyThreadsAtTheSameTime) {
  const TempFolder folder;
  const auto content = [](int writer) { return std::string(static_cast<std::size_t>(100'000 + writer), static_cast<char>('a' + writer)); };
  std::vector<std::thread> threads;
  std::vector<int> broken(4, 0), seen(4, 0);
  for (int writer = 0; writer < 4; ++writer) {
    threads.emplace_back([&, writer] {
      CacheFolder cache(folder.path(), 400'012);  // less than all five entries need
      for (int round = 0; round < 50; ++round) {
        cache.store(entry(static_cast<char>('0' + (writer + round) % 5)), content(writer));
        cache.trim();
        const auto found = cache.find(entry(static_cast<char>('0' + round % 5)));
        if (!found) continue;
        ++seen[static_cast<std::size_t>(writer)];
        if (found->empty() || *found != content(found->front() - 'a')) ++broken[static_cast<std::size_t>(writer)];
      }
      EXPECT_EQ(cache.notes(), Names());
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(broken, std::vector<int>(4, 0));
  for (const int count : seen) EXPECT_GT(count, 0);
  for (const std::string& name : namesIn(folder.path())) EXPECT_TRUE(CacheFolder::isEntry(name)) << name;
}

/// Sets environment variables and restores them.
class Environment {
 public:
  ~Environment() {
    for (const auto& [name, value] : before_) value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
  }
  void set(const char* name, const char* value) {
    const char* const old = std::getenv(name);
    before_.emplace(name, old ? old : "");
    value ? setenv(name, value, 1) : unsetenv(name);
  }

 private:
  std::map<std::string, std::string> before_;
};

TEST(CacheFolderPlace, OwnVariableThenRosThenHome) {
  Environment environment;
  environment.set("COLLISION_HULLS_CACHE", "/own");
  environment.set("ROS_HOME", "/ros");
  environment.set("HOME", "/home/someone");
  EXPECT_EQ(cacheFolder(), "/own");
  environment.set("COLLISION_HULLS_CACHE", "");
  EXPECT_EQ(cacheFolder(), "/ros/collision_hulls");
  environment.set("ROS_HOME", nullptr);
  EXPECT_EQ(cacheFolder(), "/home/someone/.ros/collision_hulls");
  environment.set("HOME", nullptr);
  EXPECT_EQ(cacheFolder(), "");
}

}  // namespace
}  // namespace collision_hulls
