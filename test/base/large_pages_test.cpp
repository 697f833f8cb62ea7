// Programs start again to get large pages: once, and only if that is of use.
#include "base/large_pages.h"

#include <gtest/gtest.h>
#include <link.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "base/sanitizer.h"

namespace collision_hulls {
namespace {

constexpr int kStayed = 10, kStartedAgain = 11, kStartedWithoutThem = 12;

/// What this program comes to when it takes large pages, with this value of GLIBC_TUNABLES.
int taken(const char* tunables) {
  const pid_t child = fork();
  if (child == 0) {
    if (tunables)
      setenv("GLIBC_TUNABLES", tunables, 1);
    else
      unsetenv("GLIBC_TUNABLES");
    char name[] = "again", filter[] = "--gtest_filter=LargePages.DISABLED_Again", all[] = "--gtest_also_run_disabled_tests";
    char* arguments[] = {name, filter, all, nullptr};
    takeLargePages(arguments);
    _exit(kStayed);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The program that was started again.
TEST(LargePages, DISABLED_Again) {
  const char* const tunables = std::getenv("GLIBC_TUNABLES");
  const bool has_them = tunables && std::string(tunables).find("glibc.malloc.hugetlb=1") != std::string::npos;
  char* none[] = {nullptr};
  takeLargePages(none);  // not once more
  _exit(has_them ? kStartedAgain : kStartedWithoutThem);
}

TEST(LargePages, StartTheProgramAgainWhereTheKernelWantsToBeAsked) {
  std::ifstream file("/sys/kernel/mm/transparent_hugepage/enabled");
  std::string choices;
  std::getline(file, choices);
  const bool of_use = !kSanitized && choices.find("[madvise]") != std::string::npos;
  EXPECT_EQ(taken(nullptr), of_use ? kStartedAgain : kStayed) << choices;
}

TEST(LargePages, StartNothingWithLittleMemory) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_DATA, &before), 0);
  const rlimit little{1 << 29, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_DATA, &little), 0);
  EXPECT_EQ(taken(nullptr), kStayed);
  setrlimit(RLIMIT_DATA, &before);
}

/// The dynamic loader that this program names.
std::string loader() {
  std::string result;
  const auto visit = [](dl_phdr_info* info, std::size_t, void* path) {
    for (int i = 0; i < info->dlpi_phnum; ++i)
      if (info->dlpi_phdr[i].p_type == PT_INTERP)
        *static_cast<std::string*>(path) = reinterpret_cast<const char*>(info->dlpi_addr + info->dlpi_phdr[i].p_vaddr);
    return 1;  // the program is the first
  };
  dl_iterate_phdr(visit, &result);
  return result;
}

/// This program, started by the loader.
TEST(LargePages, DISABLED_ByTheLoader) {
  char name[] = "again";
  char* arguments[] = {name, nullptr};
  takeLargePages(arguments);
  _exit(kStayed);
}

// Then /proc/self/exe is the loader, which would take the first argument for a program.
TEST(LargePages, StartNothingByTheLoader) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer has to be loaded first";
  char program[4096] = {};
  ASSERT_GT(readlink("/proc/self/exe", program, sizeof program - 1), 0);
  ASSERT_NE(loader(), "");
  const pid_t child = fork();
  if (child == 0) {
    unsetenv("GLIBC_TUNABLES");
    execl(loader().c_str(), "loader", program, "--gtest_filter=LargePages.DISABLED_ByTheLoader", "--gtest_also_run_disabled_tests",
          static_cast<char*>(nullptr));
    _exit(kStartedWithoutThem);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), kStayed);
}

/// [bytes] that the process holds.
long resident() {
  std::ifstream file("/proc/self/statm");
  long all = 0, pages = 0;
  file >> all >> pages;
  return pages * sysconf(_SC_PAGESIZE);
}

TEST(LargePages, FreedMemoryIsGivenBackFromBelowWhatIsInUse) {
#ifndef __GLIBC__
  GTEST_SKIP() << "another C library has its own ways";
#endif
  if (kSanitized) GTEST_SKIP() << "a sanitizer keeps what was freed";
  constexpr std::size_t kPieces = 4000, kPiece = 16'000;
  std::vector<std::vector<char>> pieces(kPieces, std::vector<char>(kPiece, 1));
  const std::vector<char> above(3 * kPiece, 1);  // too large for a hole between them
  pieces = std::vector<std::vector<char>>();
  const long before = resident();
  giveBackFreedMemory();
  EXPECT_LT(resident(), before - static_cast<long>(kPieces * kPiece / 2));
  EXPECT_EQ(above.back(), 1);
}

TEST(LargePages, StartNothingForWhoHasSetTheVariable) {
  EXPECT_EQ(taken(""), kStayed);
  EXPECT_EQ(taken("glibc.malloc.check=0"), kStayed);
}

}  // namespace
}  // namespace collision_hulls
