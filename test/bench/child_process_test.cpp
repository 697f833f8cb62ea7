// Child processes that exit, crash, hang or leave others behind.
#include "bench/child_process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace {

using End = ChildResult::End;

ChildResult shell(const std::string& command, double limit = 30) {
  return runChild({"/bin/sh", "-c", command}, limit);
}

TEST(ChildProcess, ExitStatusAndOutput) {
  const ChildResult result = shell("echo out; echo err >&2; exit 3");
  EXPECT_EQ(result.end, End::kExit);
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(result.output, "out\nerr\n");
  EXPECT_GT(result.wall_seconds, 0);
  EXPECT_GT(result.peak_mb, 0);
}

TEST(ChildProcess, SignalsAreAsUsual) {
  const auto before = signal(SIGPIPE, SIG_IGN);  // as our programs do
  const ChildResult result = shell("kill -PIPE $$");
  signal(SIGPIPE, before);
  EXPECT_EQ(result.end, End::kSignal);
  EXPECT_EQ(result.code, SIGPIPE);
}

TEST(ChildProcess, KeepsTheEndOfLongOutput) {
  const ChildResult result = shell("i=0; while [ $i -lt 2000 ]; do echo line $i; i=$((i+1)); done");
  EXPECT_EQ(result.output.substr(result.output.size() - 10), "line 1999\n");
  EXPECT_LE(result.output.size(), 4000u);
}

TEST(ChildProcess, InputIsEmpty) {
  EXPECT_EQ(shell("wc -c").output, "0\n");
}

TEST(ChildProcess, MissingProgram) {
  const ChildResult result = runChild({"/no/such/program"}, 30);
  EXPECT_EQ(result.end, End::kExit);
  EXPECT_EQ(result.code, 127);
  EXPECT_NE(result.output.find("cannot start"), std::string::npos);
}

TEST(ChildProcess, ReportsASignal) {
  const ChildResult result = shell("kill -SEGV $$");
  EXPECT_EQ(result.end, End::kSignal);
  EXPECT_EQ(result.code, SIGSEGV);
}

TEST(ChildProcess, TimeLimitEndsEverythingItStarted) {
  const fixtures::TempFolder folder;
  const std::string late = folder / "late";
  const ChildResult result = shell("(sleep 1; touch '" + late + "') & sleep 100", 0.2);
  EXPECT_EQ(result.end, End::kTimeout);
  EXPECT_GE(result.wall_seconds, 0.2);
  EXPECT_LT(result.wall_seconds, 50);
  shell("sleep 1.5");
  EXPECT_FALSE(std::filesystem::exists(late));
}

TEST(ChildProcess, EndsProcessesThatAFinishedProgramLeavesBehind) {
  const fixtures::TempFolder folder;
  const std::string late = folder / "late";
  EXPECT_EQ(shell("(sleep 1; touch '" + late + "') & exit 0").code, 0);
  shell("sleep 1.5");
  EXPECT_FALSE(std::filesystem::exists(late));
}

TEST(ChildProcess, DiesWithItsParent) {
  const fixtures::TempFolder folder;
  const std::string early = folder / "early", late = folder / "late";
  const pid_t program = fork();
  if (program == 0) {
    shell("touch '" + early + "'; sleep 1; touch '" + late + "'");
    _exit(0);
  }
  while (!std::filesystem::exists(early)) shell("sleep 0.05");
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  shell("sleep 1.5");
  EXPECT_FALSE(std::filesystem::exists(late));
}

TEST(ChildProcess, CountsCpuTimeAndMemoryOfItsChildren) {
  const ChildResult idle = shell("sleep 0.3");
  const ChildResult busy = shell("i=0; while [ $i -lt 300000 ]; do i=$((i+1)); done");
  EXPECT_GE(idle.wall_seconds, 0.3);
  EXPECT_LT(idle.cpu_seconds, 0.1);
  EXPECT_GT(busy.cpu_seconds, idle.cpu_seconds);
  const ChildResult killed = shell("sh -c 'while :; do :; done'; true", 2);
  EXPECT_GT(killed.cpu_seconds, 4 * idle.cpu_seconds) << "the shell's child must count";
  const ChildResult large = shell("head -c 100000000 /dev/zero | tail -c 80000000 | wc -c");
  EXPECT_GT(large.peak_mb, 70);
}

TEST(FilledIn, QuotesForTheShell) {
  const std::string odd = "it's a $HOME `x` \"path\" {out}";
  const std::string command = filledIn("printf %s {in}{other}", {{"in", odd}, {"out", "no"}});
  EXPECT_EQ(shell(command).output, odd + "{other}");
  EXPECT_EQ(filledIn("cmd {in} {in} $${x", {{"in", "a"}}), "cmd 'a' 'a' $${x");
}

}  // namespace
}  // namespace collision_hulls
