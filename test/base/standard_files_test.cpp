// A child process without some of its standard files.
#include "base/standard_files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <vector>

namespace collision_hulls {
namespace {

constexpr int kHeld = 0, kTaken = 1, kOutputIsLost = 2, kErrorFails = 3;

int childWithout(const std::vector<int>& files) {
  const pid_t child = fork();
  if (child == 0) {
    for (const int file : files) close(file);
    holdStandardFiles();
    if (open("/dev/null", O_RDWR) <= STDERR_FILENO) _exit(kTaken);
    for (const int file : files) {
      const bool written = write(file, "x", 1) == 1;
      if (file == STDOUT_FILENO && written) _exit(kOutputIsLost);
      if (file == STDERR_FILENO && !written) _exit(kErrorFails);
    }
    _exit(kHeld);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(HoldStandardFiles, NothingElseTakesTheirPlace) {
  for (const std::vector<int>& files : std::vector<std::vector<int>>{{}, {0}, {1}, {2}, {0, 1}, {1, 2}, {0, 1, 2}})
    EXPECT_EQ(childWithout(files), kHeld) << ::testing::PrintToString(files);
}

TEST(TakesLine, AsLongAsNobodyHasToWaitForTheReader) {
  constexpr int kPage = 4096;
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  ASSERT_EQ(fcntl(ends[1], F_SETPIPE_SZ, kPage), kPage);
  EXPECT_TRUE(takesLine(ends[1]));
  const std::vector<char> page(kPage, '.');
  ASSERT_EQ(write(ends[1], page.data(), page.size()), kPage);
  EXPECT_FALSE(takesLine(ends[1]));
  close(ends[0]);
  EXPECT_TRUE(takesLine(ends[1])) << "it fails at once";
  close(ends[1]);
  const int file = open("/dev/null", O_WRONLY);
  EXPECT_TRUE(takesLine(file));
  close(file);
}

}  // namespace
}  // namespace collision_hulls
