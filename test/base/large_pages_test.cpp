// Programs start again to get large pages: once, and only if that is of use.
#include "base/large_pages.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

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

TEST(LargePages, StartNothingForWhoHasSetTheVariable) {
  EXPECT_EQ(taken(""), kStayed);
  EXPECT_EQ(taken("glibc.malloc.check=0"), kStayed);
}

}  // namespace
}  // namespace collision_hulls
