#include "storage/cache_folder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
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

/// All files but the key.
Names namesIn(const fs::path& folder) {
  Names names;
  for (const auto& [name, content] : fixtures::contents(folder))
    if (fs::path(name).filename() != "key") names.push_back(name);
  return names;
}

void expectNote(const CacheFolder& cache, const Names& parts) {
  ASSERT_EQ(cache.notes().size(), 1u);
  for (const std::string& part : parts) EXPECT_NE(cache.notes()[0].find(part), std::string::npos) << cache.notes()[0];
}

constexpr std::uintmax_t kSeal = 64;  // [bytes] at an entry's end

TEST(CacheFolder, WithoutAFolderItStoresNothing) {
  CacheFolder cache("", kPlenty);
  cache.store(entry('a'), "content");
  EXPECT_EQ(cache.find(entry('a')), std::nullopt);
  cache.trim();
  EXPECT_EQ(cache.notes(), Names());
}

TEST(CacheFolder, KeepsAnEntryThatCannotBeOpenedForNow) {
  const TempFolder folder;
  CacheFolder cache(folder / "cache", kPlenty);
  cache.store(entry('a'), "content");
  ASSERT_EQ(cache.find(entry('a')), "content");
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  const rlimit none{0, limit.rlim_max};
  setrlimit(RLIMIT_NOFILE, &none);
  const std::optional<std::string> meanwhile = cache.find(entry('a'));
  setrlimit(RLIMIT_NOFILE, &limit);
  EXPECT_EQ(meanwhile, std::nullopt);
  EXPECT_EQ(cache.find(entry('a')), "content");
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
    expectNote(cache, {place, "COLLISION_HULLS_CACHE"});
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
  expectNote(cache, {"2 damaged"});
}

class SealedEntries : public ::testing::Test {
 protected:
  SealedEntries() { CacheFolder(folder_.path(), kPlenty).store(entry('a'), "content"); }

  /// What is there in place of the entry counts as damaged, and the entry can be stored again.
  void expectRefused(const std::string& what) {
    CacheFolder cache(folder_.path(), kPlenty);
    EXPECT_EQ(cache.find(entry('a')), std::nullopt) << what;
    expectNote(cache, {"1 damaged"});
    cache.store(entry('a'), "content");
    EXPECT_EQ(cache.find(entry('a')), "content") << what;
  }

  /// The whole folder is left alone until it is repaired.
  void expectUnused(const Names& parts) {
    const auto before = fixtures::contents(folder_.path());
    CacheFolder cache(folder_.path(), kPlenty);
    EXPECT_EQ(cache.find(entry('a')), std::nullopt) << parts[0];
    cache.store(entry('b'), "content");
    cache.trim();
    EXPECT_EQ(fixtures::contents(folder_.path()), before) << parts[0];
    expectNote(cache, parts);
  }

  std::string file() const { return folder_ / entry('a'); }
  std::string key() const { return folder_ / "key"; }

  const TempFolder folder_;
};

TEST_F(SealedEntries, AnyChangeIsNoticed) {
  const std::string sealed = fixtures::read(file());
  ASSERT_EQ(sealed.size(), 7 + kSeal);
  for (std::size_t i = 0; i < sealed.size(); ++i) {
    std::string changed = sealed;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    fixtures::write(file(), changed);
    EXPECT_EQ(CacheFolder(folder_.path(), kPlenty).find(entry('a')), std::nullopt) << i;
    fixtures::write(file(), sealed.substr(0, i));
    EXPECT_EQ(CacheFolder(folder_.path(), kPlenty).find(entry('a')), std::nullopt) << i;
  }
  fixtures::write(file(), sealed + "a");
  expectRefused("longer");
}

TEST_F(SealedEntries, ACopyUnderAnotherName) {
  CacheFolder(folder_.path(), kPlenty).store(entry('b'), "other");
  fs::copy_file(folder_ / entry('b'), file(), fs::copy_options::overwrite_existing);
  expectRefused("copy");
}

TEST_F(SealedEntries, SealedWithAnotherKey) {
  const TempFolder other;
  CacheFolder(other.path(), kPlenty).store(entry('a'), "poison");
  fs::copy_file(other / entry('a'), file(), fs::copy_options::overwrite_existing);
  expectRefused("of another folder");
}

TEST_F(SealedEntries, WhoseFileOthersCanWrite) {
  for (const fs::perms others : {fs::perms::group_write, fs::perms::others_write}) {
    fs::permissions(file(), others, fs::perm_options::add);
    expectRefused("writable");
  }
  if (geteuid() != 0) return;  // only root may give files away
  ASSERT_EQ(chown(file().c_str(), 12345, 12345), 0);
  expectRefused("of another user");
}

// None of these may be read, let alone waited for.
TEST_F(SealedEntries, WhatIsNoFile) {
  fs::rename(file(), folder_ / "elsewhere");
  fs::create_symlink("elsewhere", file());
  expectRefused("link");
  fs::remove(file());
  ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
  expectRefused("FIFO");
  fs::remove(file());
  fs::create_symlink("/dev/zero", file());
  expectRefused("link to a device");
  fixtures::write(file(), "");
  fs::permissions(file(), fs::perms::owner_read | fs::perms::owner_write);
  fs::resize_file(file(), std::uintmax_t{1} << 40);  // sparse
  expectRefused("huge");
}

TEST_F(SealedEntries, AFolderThatOthersCanWrite) {
  const fs::perms sticky_as_tmp = fs::perms::others_write | fs::perms::sticky_bit;
  for (const fs::perms others : {fs::perms::group_write, fs::perms::others_write, sticky_as_tmp}) {
    fs::permissions(folder_.path(), others, fs::perm_options::add);
    expectUnused({"can be written by others", "chmod go-w '" + folder_.path().string() + "'", "COLLISION_HULLS_CACHE"});
    fs::permissions(folder_.path(), others, fs::perm_options::remove);
  }
  EXPECT_EQ(CacheFolder(folder_.path(), kPlenty).find(entry('a')), "content");
  if (geteuid() != 0) return;
  ASSERT_EQ(chown(folder_.path().c_str(), 12345, 12345), 0);
  expectUnused({"belongs to another user", "set COLLISION_HULLS_CACHE to a folder of your own"});
}

TEST_F(SealedEntries, AKeyThatIsNoSecret) {
  for (const fs::perms others : {fs::perms::group_read, fs::perms::others_read, fs::perms::others_write}) {
    fs::permissions(key(), others, fs::perm_options::add);
    expectUnused({key(), "by others", "delete the folder"});
    fs::permissions(key(), others, fs::perm_options::remove);
  }
  const std::string secret = fixtures::read(key());
  EXPECT_EQ(secret.size(), 32u);
  for (const std::string& other : {std::string(), secret + "a", secret.substr(1)}) {
    fixtures::write(key(), other);
    expectUnused({key(), "bytes", "delete the folder"});
  }
  fixtures::write(folder_ / "elsewhere", secret);
  fs::remove(key());
  fs::create_symlink("elsewhere", key());
  expectUnused({key(), "symbolic link"});
  fs::remove(key());
  CacheFolder cache(folder_.path(), kPlenty);
  EXPECT_EQ(cache.find(entry('a')), std::nullopt) << "nothing proves it";
  cache.store(entry('b'), "with a new key");
  expectRefused("with the old key");
}

TEST_F(SealedEntries, AFolderThatVanishes) {
  CacheFolder cache(folder_.path(), kPlenty);
  EXPECT_EQ(cache.find(entry('a')), "content");
  fs::rename(folder_.path(), folder_.path().string() + ".away");
  EXPECT_EQ(cache.find(entry('a')), std::nullopt);
  cache.store(entry('a'), "content");
  cache.trim();
  expectNote(cache, {"could not store"});
  fs::rename(folder_.path().string() + ".away", folder_.path());
}

// The first of several processes makes the key, and all use it.
TEST(CacheFolder, ProcessesAgreeOnAKey) {
  for (int round = 0; round < 20; ++round) {
    const TempFolder folder;
    std::vector<pid_t> children;
    for (const char digit : std::string("01234567")) {
      children.push_back(fork());
      if (children.back() != 0) continue;
      CacheFolder(folder / "cache", kPlenty).store(entry(digit), std::string(1, digit));
      _exit(0);
    }
    for (const pid_t child : children) waitpid(child, nullptr, 0);
    CacheFolder cache(folder / "cache", kPlenty);
    for (const char digit : std::string("01234567")) EXPECT_EQ(cache.find(entry(digit)), std::string(1, digit));
    EXPECT_EQ(namesIn(folder / "cache").size(), 8u);
    EXPECT_EQ(fs::status(folder / "cache").permissions(), fs::perms::owner_all);
  }
}

TEST(CacheFolder, FolderInPlaceOfAnEntry) {
  const TempFolder folder;
  fs::create_directories(folder / entry('a') + "/more");
  CacheFolder cache(folder.path(), kPlenty);
  cache.store(entry('a'), "content");
  EXPECT_EQ(cache.find(entry('a')), std::nullopt);
  EXPECT_EQ(cache.notes().size(), 2u) << "neither stored nor found";
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
  fs::create_symlink("thesis.tex", folder / entry('f'));  // takes no place
  CacheFolder cache(folder.path(), 4 * (25 + kSeal));
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

TEST(CacheFolder, TrimsNowAndThen) {
  const TempFolder folder;
  CacheFolder cache(folder.path(), kPlenty);
  const auto leaveFile = [&] {
    fixtures::write(folder / ".unfinished-old", "");
    age(folder / ".unfinished-old", 2);
  };
  leaveFile();
  cache.trimNowAndThen();
  EXPECT_TRUE(fs::exists(folder / ".unfinished-old")) << "a run that stores nothing must not trim";
  cache.store(entry('a'), "content");
  cache.trimNowAndThen();
  EXPECT_FALSE(fs::exists(folder / ".unfinished-old"));
  for (const int hours : {0, 2, -2}) {  // since the last time: lately, long ago, by a clock that is wrong
    leaveFile();
    if (hours != 0) age(folder / ".trimmed", hours);
    cache.trimNowAndThen();
    EXPECT_EQ(fs::exists(folder / ".unfinished-old"), hours == 0) << hours << " h";
  }
}

// Readers must see one of the stored contents, complete, whoever else writes or trims.
TEST(CacheFolder, ManyThreadsAtTheSameTime) {
  const TempFolder folder;
  const auto content = [](int writer) { return std::string(static_cast<std::size_t>(100'000 + writer), static_cast<char>('a' + writer)); };
  std::vector<std::thread> threads;
  std::vector<int> broken(4, 0), seen(4, 0);
  for (int writer = 0; writer < 4; ++writer) {
    threads.emplace_back([&, writer] {
      CacheFolder cache(folder.path(), 400'268);  // less than all five entries need
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
