#include "storage/replace_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>
#include <set>

#include "base/roots.h"
#include "collision_hulls/error.h"
#include "pipeline/fixtures.h"
#include "storage/files.h"
#include "storage/sha256.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using fixtures::TempFolder;

constexpr int kFiles = 20;

/// A folder whose files all contain `text`, so that a mixture of two folders would show.
void replaceWith(const std::string& target, const std::string& text) {
  FolderReplacement replacement(target);
  for (int i = 0; i < kFiles; ++i) writeText(replacement.folder() / "sub" / std::to_string(i), text);
  replacement.commit();
}

std::set<std::string> texts(const fs::path& folder) {
  std::set<std::string> result;
  const auto files = fixtures::contents(folder);
  EXPECT_EQ(files.size(), static_cast<std::size_t>(kFiles)) << folder;
  for (const auto& [name, text] : files) result.insert(text);
  return result;
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(FolderReplacement, CreatesAndReplaces) {
  const TempFolder folder;
  const std::string target = folder / "a/b/out/";  // a slash, and folders that are not there yet
  replaceWith(target, "old");
  EXPECT_EQ(texts(target), std::set<std::string>{"old"});
  fixtures::write(folder / "a/b/out/of_the_old_one", "");
  replaceWith(target, "new");
  EXPECT_EQ(texts(target), std::set<std::string>{"new"});
  EXPECT_EQ(entries(folder / "a/b"), 1u) << "something is left";
}

// With GCC before 11.3, create_directories() refuses what symlink_status() takes for a link.
TEST(FolderReplacement, IsNoLinkToAFolder) {
  const TempFolder folder;
  FolderReplacement replacement(folder / "out");
  EXPECT_TRUE(fs::is_directory(fs::symlink_status(replacement.folder()))) << replacement.folder();
  writeText(replacement.folder() / "file", "");
  try {
    writeText(replacement.folder() / "file/below", "");
    FAIL() << "a file is no folder";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find("/./"), std::string::npos) << error.what();
  }
}

TEST(FolderReplacement, AcceptsAnEmptyFolder) {
  const TempFolder folder;
  fs::create_directory(folder / "out");
  replaceWith(folder / "out", "new");
  EXPECT_EQ(texts(folder / "out"), std::set<std::string>{"new"});
}

TEST(FolderReplacement, FollowsALink) {
  const TempFolder folder;
  replaceWith(folder / "real", "old");
  fs::create_directory_symlink(folder / "real", folder / "link");
  replaceWith(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(texts(folder / "real"), std::set<std::string>{"new"});
}

TEST(FolderReplacement, WithoutCommitNothingChanges) {
  const TempFolder folder;
  replaceWith(folder / "out", "old");
  {
    FolderReplacement replacement(folder / "out");
    writeText(replacement.folder() / "half", "done");
    EXPECT_EQ(texts(folder / "out"), std::set<std::string>{"old"});
  }
  EXPECT_EQ(texts(folder / "out"), std::set<std::string>{"old"});
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(FolderReplacement, UnwritablePlaces) {
  const TempFolder folder;
  fixtures::write(folder / "file", "");
  for (const std::string& target : {folder / "file/out", std::string("/proc/nowhere/out"), std::string("/")}) {
    try {
      FolderReplacement replacement(target);
      ADD_FAILURE() << target;
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::kUnwritableOutput) << e.what();
    }
  }
}

TEST(ReplacedFolder, TheRootIsNamedHoweverItIsSpelled) {
  const fs::path before = fs::current_path();
  fs::current_path("/");
  for (const std::string target : {"/", ".", "//", "/..", "tmp/.."}) {
    try {
      ADD_FAILURE() << target << " is " << replacedFolder(target);
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::kUnwritableOutput) << e.what();
      const std::string named = "output '" + target + "' is " + (target == "/" ? "" : "'/', ") + "the root of the file system";
      EXPECT_NE(std::string(e.what()).find(named), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find("; choose another output, such as a folder within it"), std::string::npos) << e.what();
    }
  }
  fs::current_path(before);
}

TEST(FolderReplacement, EndsWhereNothingMoreCanBeOpened) {
  const TempFolder folder;
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  const Descriptor next(open("/dev/null", O_RDONLY | O_CLOEXEC));
  bool failed = false, worked = false;
  for (rlim_t free = 0; free < 6; ++free) {
    rlimit limit = before;
    limit.rlim_cur = static_cast<rlim_t>(next.number()) + 1 + free;
    setrlimit(RLIMIT_NOFILE, &limit);
    try {
      FolderReplacement replacement(folder / "out");
      worked = true;
    } catch (const Error& error) {
      failed = true;
      EXPECT_EQ(error.code(), ErrorCode::kUnwritableOutput) << error.what();
    }
    setrlimit(RLIMIT_NOFILE, &before);
    EXPECT_EQ(entries(folder.path()), 0u) << free << " may be opened";
  }
  EXPECT_TRUE(failed && worked);
}

// Which root never notices: a user of this process's own, without root's rights, has to.
TEST(FolderReplacement, RemovesWhatItsOwnerMadeReadOnly) {
  const TempFolder folder;
  chmod(folder.path().c_str(), 0777);
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && setuid(kNobody) != 0) _exit(2);
    const std::string target = folder / "out";
    replaceWith(target, "old");
    fs::create_directory(folder / "out/sub/deep");
    fixtures::write(folder / "out/sub/deep/file", "");
    for (const char* name : {"out/sub/deep", "out/sub", "out"}) chmod((folder / name).c_str(), name[3] == 0 ? 0555 : 0);
    replaceWith(target, "new");
    _exit(entries(folder.path()) == 1 && texts(target) == std::set<std::string>{"new"} ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST(FolderReplacement, LeavesFoldersOfLiveProcessesAlone) {
  const TempFolder folder;
  FolderReplacement first(folder / "out");
  writeText(first.folder() / "file", "first");
  replaceWith(folder / "out", "second");
  EXPECT_TRUE(fs::exists(first.folder() / "file"));
  first.commit();
  EXPECT_EQ(fixtures::read(folder / "out/file"), "first");
}

// Forked children replace one text by the next over and over, and are killed in the middle.
TEST(FolderReplacement, KillLeavesTheOldOrTheNewFolder) {
  const TempFolder folder;
  const std::string target = folder / "out";
  replaceWith(target, "x");
  std::mt19937 random(3);
  std::uniform_int_distribution<int> microseconds(0, 8000);
  for (int round = 0; round < 40; ++round) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (int n = 0;; ++n) replaceWith(target, std::to_string(round) + "." + std::to_string(n));
    }
    usleep(static_cast<useconds_t>(microseconds(random)));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    EXPECT_EQ(texts(target).size(), 1u) << "seed 3, round " << round;
  }
  replaceWith(target, "last");
  EXPECT_EQ(entries(folder.path()), 1u) << "what killed processes left was not removed";
}

TEST(ReplaceByTwoRenames, ReplacesAndCanBeResumed) {
  const TempFolder folder;
  const fs::path target = folder / "out";
  fixtures::write(folder / "new/file", "new");
  fixtures::write(target / "file", "old");
  replaceByTwoRenames(folder / "new", target);
  EXPECT_EQ(fixtures::read(target / "file"), "new");
  EXPECT_EQ(entries(folder.path()), 1u);

  // Where the second rename fails, the first is undone.
  EXPECT_THROW(replaceByTwoRenames(folder / "missing", target), Error);
  EXPECT_EQ(fixtures::read(target / "file"), "new");

  // A process that was killed between the two.
  const std::string aside = ".collision_hulls-" + sha256("out").substr(0, 16) + "-old";
  fs::rename(target, folder / aside);
  restoreAside(target);
  EXPECT_EQ(fixtures::read(target / "file"), "new");
  EXPECT_EQ(entries(folder.path()), 1u);
}

void expectCommitFails(FolderReplacement& replacement) {
  try {
    replacement.commit();
    ADD_FAILURE() << "committed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kUnwritableOutput);
    EXPECT_NE(std::string(error.what()).find("became a link"), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find("/proc"), std::string::npos) << error.what();
  }
}

TEST(FolderReplacement, AFolderThatIsSwappedForALinkMeanwhile) {
  const TempFolder folder;
  fs::create_directories(folder / "elsewhere/out");
  replaceWith(folder / "a/out", "old");
  {
    FolderReplacement replacement(folder / "a/out");
    writeText(replacement.folder() / "before", "text");
    fs::rename(folder / "a", folder / "moved");
    fs::create_directory_symlink(folder / "elsewhere", folder / "a");
    writeText(replacement.folder() / "sub/after", "text");
    expectCommitFails(replacement);
  }
  EXPECT_EQ(entries(folder / "elsewhere"), 1u);
  EXPECT_EQ(entries(folder / "elsewhere/out"), 0u);
  EXPECT_EQ(entries(folder / "moved"), 1u) << "something is left";
  EXPECT_EQ(texts(folder / "moved/out"), std::set<std::string>{"old"});
}

TEST(FolderReplacement, ANewFolderThatIsSwappedForALinkMeanwhile) {
  const TempFolder folder;
  fs::create_directories(folder / "elsewhere");
  fs::create_directories(folder / "a");
  FolderReplacement replacement(folder / "a/out");
  const fs::path hidden = fs::directory_iterator(folder / "a")->path();
  fs::rename(hidden, folder / "moved");
  fs::create_directory_symlink(folder / "elsewhere", hidden);
  writeText(replacement.folder() / "after", "text");
  expectCommitFails(replacement);
  EXPECT_EQ(entries(folder / "elsewhere"), 0u);
  EXPECT_FALSE(fs::exists(folder / "a/out"));
}

TEST(FolderReplacement, ALinkOutOfTheRootsSinceTheCheck) {
  const TempFolder folder;
  fs::create_directories(folder / "elsewhere");
  fs::create_directories(folder / "in");
  Roots roots;
  roots.write = {folder / "in"};
  const Confinement confinement(roots);
  const std::string checked = writablePath(folder / "in/sub/out");
  fs::create_directory_symlink(folder / "elsewhere", folder / "in/sub");
  try {
    FolderReplacement replacement(checked);
    ADD_FAILURE() << "opened";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kOutsideRoots) << error.what();
  }
  EXPECT_EQ(entries(folder / "elsewhere"), 0u);
}

TEST(FolderReplacement, OthersCanWriteOnlyWhenItIsInPlace) {
  const TempFolder folder;
  const auto others = [](const fs::path& path) { return fs::status(path).permissions() & (fs::perms::group_all | fs::perms::others_all); };
  fs::create_directory(folder / "usual");
  FolderReplacement replacement(folder / "out");
  EXPECT_EQ(others(replacement.folder()), fs::perms::none);
  replacement.commit();
  EXPECT_EQ(fs::status(folder / "out").permissions(), fs::status(folder / "usual").permissions());
}

}  // namespace
}  // namespace collision_hulls
