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

/// A process that leaves a sign once it is told to: so it is seen whether it is still there, however busy the machine is.
struct Survivor {
  const fixtures::TempFolder folder;
  const std::string go = folder / "go", sign = folder / "sign";

  std::string command() const { return "until [ -e '" + go + "' ]; do sleep 0.05; done; touch '" + sign + "'"; }
  bool isThere() const {
    fixtures::write(go, "");
    shell("sleep 0.5");
    return std::filesystem::exists(sign);
  }
};

TEST(ChildProcess, ExitStatusAndOutput) {
  const ChildResult result = shell("echo out; echo err >&2; exit 3");
  EXPECT_EQ(result.end, End::kExit);
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(result.output, "out\nerr\n");
  EXPECT_GT(result.wall_seconds, 0);
  EXPECT_GT(result.peak_mb, 0);
}

TEST(ChildProcess, SignalsAreAsUsual) {
  for (const auto& [number, name] : {std::pair(SIGPIPE, "PIPE"), {SIGXFSZ, "XFSZ"}}) {
    const auto before = signal(number, SIG_IGN);  // as our programs do
    const ChildResult result = shell(std::string("kill -") + name + " $$");
    signal(number, before);
    EXPECT_EQ(result.end, End::kSignal) << name;
    EXPECT_EQ(result.code, number);
  }
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
  const Survivor started;
  const ChildResult result = shell("(" + started.command() + ") & sleep 100", 0.2);
  EXPECT_EQ(result.end, End::kTimeout);
  EXPECT_GE(result.wall_seconds, 0.2);
  EXPECT_LT(result.wall_seconds, 50);
  EXPECT_FALSE(started.isThere());
}

TEST(ChildProcess, EndsProcessesThatAFinishedProgramLeavesBehind) {
  const Survivor left;
  EXPECT_EQ(shell("(" + left.command() + ") & exit 0").code, 0);
  EXPECT_FALSE(left.isThere());
}

TEST(ChildProcess, DiesWithItsParent) {
  const fixtures::TempFolder folder;
  const std::string early = folder / "early";
  const Survivor survivor;
  const pid_t program = fork();
  if (program == 0) {
    shell("touch '" + early + "'; " + survivor.command());
    _exit(0);
  }
  while (!std::filesystem::exists(early)) shell("sleep 0.05");
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  EXPECT_FALSE(survivor.isThere());
}

// Of CPU time, a program says when it has had enough, or its own limit ends it: a busy machine makes no difference.

TEST(ChildProcess, CountsCpuTimeAndMemoryOfItsChildren) {
  const ChildResult idle = shell("sleep 0.3");
  EXPECT_GE(idle.wall_seconds, 0.3);
  EXPECT_LT(idle.cpu_seconds, idle.wall_seconds - 0.2) << "waiting does not count";
  const ChildResult busy = shell("(ulimit -t 1; while :; do :; done); true", 300);
  EXPECT_EQ(busy.end, End::kExit);
  EXPECT_GT(busy.cpu_seconds, 0.5);
  const ChildResult large = shell("head -c 100000000 /dev/zero | tail -c 80000000 | wc -c");
  EXPECT_GT(large.peak_mb, 70);
}

TEST(ChildProcess, CountsCpuTimeOfChildrenThatItKills) {
  const fixtures::TempFolder folder;
  const std::string had_a_second = folder / "had_a_second";
  const std::string busy = "sh -c 'ulimit -S -t 1; trap \"touch $0\" XCPU; while :; do :; done' " + had_a_second;
  ChildResult killed;
  for (double limit = 2; limit < 300 && !std::filesystem::exists(had_a_second); limit *= 2) killed = shell(busy + "; true", limit);
  EXPECT_EQ(killed.end, End::kTimeout);
  EXPECT_GT(killed.cpu_seconds, 0.5) << "the shell's child must count";
}

TEST(FilledIn, QuotesForTheShell) {
  const std::string odd = "it's a $HOME `x` \"path\" {out}";
  const std::string command = filledIn("printf %s {in}{other}", {{"in", odd}, {"out", "no"}});
  EXPECT_EQ(shell(command).output, odd + "{other}");
  EXPECT_EQ(filledIn("cmd {in} {in} $${x", {{"in", "a b"}}), "cmd 'a b' 'a b' $${x");
  EXPECT_EQ(filledIn("cmd {in} {out}", {{"in", "a"}, {"out", ""}}), "cmd a ''");
}

}  // namespace
}  // namespace collision_hulls
