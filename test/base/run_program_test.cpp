#include "base/run_program.h"

#include <signal.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "base/large_pages.h"
#include "robot/robot_tests.h"

namespace {

std::atomic<int> groups_killed{0}, groups_of_others{0};

}  // namespace

/// Takes the place of libc's, to see whether a group's number is still that of a child of ours that nobody has collected.
extern "C" int kill(pid_t process, int signal) noexcept {
  if (process < -1) {
    siginfo_t ended{};
    ++groups_killed;
    if (waitid(P_PID, static_cast<id_t>(-process), &ended, WEXITED | WNOHANG | WNOWAIT) != 0) ++groups_of_others;
  }
  return static_cast<int>(syscall(SYS_kill, process, signal));
}

namespace collision_hulls {
namespace {

std::vector<std::string> shell(const std::string& script) {
  return {"/bin/sh", "-c", script};
}

TEST(RunProgram, GivesWhatItWrites) {
  const auto result = runProgram(shell("echo out; echo err >&2; exit 3"));
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, 3);
  EXPECT_EQ(result->out, "out\n");
  EXPECT_EQ(result->errors, "err\n");
  EXPECT_EQ(runProgram(shell("kill -9 $$"))->status, 128 + SIGKILL);
  EXPECT_FALSE(runProgram({"no-such-program-anywhere"}));
}

TEST(RunProgram, WithTheEnvironmentOfOurCaller) {
  const std::string ours = kLargePages, name = ours.substr(0, ours.find('='));
  const auto result = [&] { return runProgram(shell("echo \"$" + name + " $ROBOT\""), {}, {}, {"ROBOT=arm"})->out; };
  {
    const ScopedVariable set_by_us(name.c_str(), ours.substr(name.size() + 1));
    EXPECT_EQ(result(), " arm\n");
  }
  const ScopedVariable set_by_the_caller(name.c_str(), "glibc.malloc.check=0");
  EXPECT_EQ(result(), "glibc.malloc.check=0 arm\n");
}

TEST(RunProgram, WithSignalsAsUsual) {
  const auto before = signal(SIGPIPE, SIG_IGN);
  EXPECT_EQ(runProgram(shell("kill -PIPE $$"))->status, 128 + SIGPIPE);
  signal(SIGPIPE, before);
}

TEST(RunProgram, WithoutAnyOpenFile) {
  const pid_t child = fork();
  if (child == 0) {
    for (int i = 0; i < 3; ++i) close(i);
    const auto result = runProgram(shell("cat; echo out; echo err >&2"));
    _exit(result && result->status == 0 && result->out == "out\n" && result->errors == "err\n" ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

TEST(RunProgram, OutputWithoutEnd) {
  ProgramLimits limits;
  limits.output = 1'000'000;
  expectError(ErrorCode::kTooLarge, {"1 MB"}, [&] { runProgram(shell("yes"), {}, limits); });
  expectError(ErrorCode::kTooLarge, {"1 MB"}, [&] { runProgram(shell("yes >&2"), {}, limits); });
}

TEST(RunProgram, TimeWithoutEnd) {
  ProgramLimits limits;
  limits.seconds = 0.2;
  expectError(ErrorCode::kOutOfTime, {"longer than"}, [&] { runProgram(shell("sleep 1000"), {}, limits); });
}

TEST(RunProgram, MemoryIsBounded) {
  ProgramLimits limits;
  limits.memory = std::uint64_t{1} << 30;
  EXPECT_EQ(runProgram(shell("sleep 0.2; ulimit -v"), {}, limits)->out, "1048576\n");
}

void expectEnds(pid_t process) {
  for (int i = 0; i < 1000 && kill(process, 0) == 0; ++i) {  // whoever adopts it has to collect it first
    char state = '?';
    std::string word;
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    if (stat >> word >> word >> state && state == 'Z') break;
    ASSERT_LT(i, 999);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

pid_t awaitNumberIn(const std::string& file) {
  pid_t number = 0;
  while (number == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::ifstream(file) >> number;
  }
  return number;
}

TEST(RunProgram, EndsWhenWeAreKilled) {
  const std::string file = testing::TempDir() + "run_program_killed_" + std::to_string(getpid());
  const pid_t child = fork();
  if (child == 0) {
    runProgram(shell("echo $$ > " + file + "; exec sleep 1000"));
    _exit(0);
  }
  const pid_t program = awaitNumberIn(file);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  expectEnds(program);
  kill(program, SIGKILL);
  std::remove(file.c_str());
}

TEST(RunProgram, EndsWhatItLeavesBehind) {
  const auto result = runProgram(shell("sleep 1000 & echo $!; exit 4"));
  EXPECT_EQ(result->status, 4);
  expectEnds(std::stoi(result->out));
}

TEST(RunProgram, KillsNoGroupWhoseNumberMayBeAnothers) {
  ProgramLimits limits;
  limits.seconds = 0.1;
  groups_killed = groups_of_others = 0;
  EXPECT_EQ(runProgram(shell("exit 0"))->status, 0);
  EXPECT_THROW(runProgram(shell("sleep 1000"), {}, limits), Error);
  EXPECT_EQ(groups_killed, 2);
  EXPECT_EQ(groups_of_others, 0);
}

TEST(RunProgram, EndsWithWhatItStartedWhenCancelled) {
  const std::string file = testing::TempDir() + "run_program_" + std::to_string(getpid());
  RunControl control;
  pid_t grandchild = 0;
  std::thread stop([&] {
    grandchild = awaitNumberIn(file);
    control.cancel();
  });
  expectError(ErrorCode::kCancelled, {}, [&] { runProgram(shell("sleep 1000 & echo $! > " + file + "; wait"), control); });
  stop.join();
  expectEnds(grandchild);
  std::remove(file.c_str());
}

}  // namespace
}  // namespace collision_hulls
