// Also tests src/sandbox/serve.cpp, src/sandbox/confine.cpp and src/sandbox/wire.cpp, which run in the reader program.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include "base/descriptor.h"
#include "base/sanitizer.h"
#include "collision_hulls/error.h"
#include "sandbox/reader_process.h"
#include "sandbox/reader_program.h"

namespace collision_hulls {
namespace {

constexpr std::uint64_t kMegabyte = 1'000'000;

constexpr ReadingLimits kLimits{{300 * kMegabyte, 5}, 100 * kMegabyte, 60};

ReaderProgram& reader() {
  static ReaderProgram program(TEST_READER, "COLLISION_HULLS_TEST_READER");
  return program;
}

std::string ask(const std::string& deed, const std::string& body = "", const ReadingLimits& limits = kLimits,
                const RunControl& control = {}) {
  return reader().ask({deed, body, -1}, limits, "a.dae", "raise it", control);
}

/// Expects an Error of this code whose text has this part.
void expectError(const std::string& deed, ErrorCode code, const std::string& part, const ReadingLimits& limits = kLimits) {
  try {
    ask(deed, "", limits);
    ADD_FAILURE() << deed << " was answered";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << deed << ": " << error.what();
  }
}

/// The living children of a process.
std::set<pid_t> childrenOf(pid_t parent) {
  std::set<pid_t> result;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream in(entry.path() / "stat");
    pid_t number = 0, its_parent = 0;
    std::string name, state;
    if (in >> number >> name >> state >> its_parent && its_parent == parent && state != "Z") result.insert(number);
  }
  return result;
}

template <typename Condition>
void waitUntil(const Condition& condition) {
  for (int i = 0; i < 3000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(condition());
}

/// All processes below one.
std::set<pid_t> below(pid_t parent) {
  std::set<pid_t> result;
  for (const pid_t child : childrenOf(parent)) {
    result.insert(child);
    result.merge(below(child));
  }
  return result;
}

bool alive(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  return in >> number >> name >> state && state != "Z";
}

TEST(Reader, AnswersByteForByte) {
  EXPECT_EQ(ask("echo", ""), "");
  std::string bytes(3'000'001, '\x80');  // many pieces
  bytes[1'500'000] = '\0';
  EXPECT_EQ(ask("echo", bytes), bytes);
}

TEST(Reader, SaysWhatProtectsIt) {
  EXPECT_NE(reader().protection().find("confined by resource limits"), std::string::npos) << reader().protection();
}

TEST(Reader, EachQuestionHasMemoryOfItsOwn) {
  EXPECT_EQ(ask("calls"), "1");
  EXPECT_EQ(ask("calls"), "1");
  EXPECT_NE(ask("pids"), ask("pids"));
}

TEST(Reader, OneProcessServesManyQuestions) {
  ask("echo");
  const std::set<pid_t> before = childrenOf(getpid());
  EXPECT_EQ(before.size(), 1u);
  for (int i = 0; i < 20; ++i) ask("echo");
  expectError("crash", ErrorCode::kReaderFailed, "");
  ask("echo");
  EXPECT_EQ(childrenOf(getpid()), before);
}

TEST(Reader, HasOnlyItsPipe) {
  const Descriptor left_open(open("/dev/null", O_RDONLY));
  EXPECT_EQ(ask("descriptors"), "1 2 3 5 ");
}

TEST(Reader, HasNoEnvironmentBeyondNeed) {
  setenv("COLLISION_HULLS_SECRET", "1", 1);
  ReaderProgram fresh(TEST_READER, "COLLISION_HULLS_TEST_READER");
  const std::string variables = fresh.ask({"environment", {}, -1}, kLimits, "a", "", {});
  EXPECT_NE(variables.find("LC_ALL=C "), std::string::npos) << variables;
  EXPECT_EQ(variables.find("SECRET"), std::string::npos) << variables;
  EXPECT_EQ(variables.find("HOME"), std::string::npos) << variables;
}

TEST(Reader, TakesMemoryAsTheUserSays) {
  const char* const before = std::getenv("GLIBC_TUNABLES");
  const std::string kept = before ? before : "";
  const auto variables_of_reader = [] {
    return ReaderProgram(TEST_READER, "COLLISION_HULLS_TEST_READER").ask({"environment", {}, -1}, kLimits, "a", "", {});
  };
  unsetenv("GLIBC_TUNABLES");
  EXPECT_NE(variables_of_reader().find("GLIBC_TUNABLES=glibc.malloc.hugetlb=1 "), std::string::npos);
  setenv("GLIBC_TUNABLES", "", 1);
  EXPECT_NE(variables_of_reader().find("GLIBC_TUNABLES= "), std::string::npos);
  before ? setenv("GLIBC_TUNABLES", kept.c_str(), 1) : unsetenv("GLIBC_TUNABLES");
}

TEST(Reader, PassesErrorsOn) {
  expectError("error", ErrorCode::kTooFarFromOrigin, "too far");
  expectError("cancelled", ErrorCode::kReaderFailed, "makes no sense");  // it has no say in that
  expectError("exception", ErrorCode::kReaderFailed, "a.dae: cannot be read (out of order)");
}

TEST(Reader, CrashIsAnError) {
  const bool s = kSanitized;
  expectError("crash", ErrorCode::kReaderFailed, s ? "a.dae: " : "a.dae: its reader crashed (signal 11, Segmentation fault)");
  expectError("abort", ErrorCode::kReaderFailed, "a.dae: its reader crashed (signal 6, Aborted)");
  expectError("overflow", ErrorCode::kReaderFailed, s ? "a.dae: " : "a.dae: its reader crashed");
  expectError("exit", ErrorCode::kReaderFailed, "a.dae: its reader ended with status 3 instead of an answer");
  expectError("silent", ErrorCode::kReaderFailed, "a.dae: its reader's answer makes no sense (it is empty)");
}

TEST(Reader, MemoryIsLimited) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer needs more than any limit";
  expectError("memory", ErrorCode::kOutOfMemory, "a.dae: reading it takes more memory than the limit of 300 MB; raise it");
  expectError("bad_alloc", ErrorCode::kOutOfMemory, "more memory than the limit");
}

TEST(Reader, TimeIsLimited) {
  expectError("loop", ErrorCode::kOutOfTime, "a.dae: reading it takes more computing than the limit of 1 s; raise it",
              {{300 * kMegabyte, 1}, 1000, 60});
  expectError("sleep", ErrorCode::kOutOfTime, "a.dae: reading it takes longer than the limit of 1 s; raise it",
              {{300 * kMegabyte, 5}, 1000, 1});
  expectError("run_on", ErrorCode::kOutOfMemory, "signal 9", {{300 * kMegabyte, 50}, 1000, 60});
}

TEST(Reader, LengthOfAnAnswerIsLimited) {
  const std::string text(1000, 'x');
  EXPECT_EQ(ask("echo", text, {{300 * kMegabyte, 5}, 1001, 60}), text);
  EXPECT_THROW(ask("echo", text, {{300 * kMegabyte, 5}, 1000, 60}), Error);  // with its kind, one byte too long
}

TEST(Reader, DoesNothingButRead) {
  const std::string protection = reader().protection();
  if (protection.find(", seccomp") == std::string::npos) GTEST_SKIP() << protection;
  const std::string file = (std::filesystem::temp_directory_path() / ("sandbox_" + std::to_string(getpid()))).string();
  std::ofstream(file) << "kept";
  for (const char* const deed : {"open", "socket", "start", "fork", "trace", "kill", "signals", "code"})
    EXPECT_EQ(ask(deed), "Operation not permitted") << deed;
  EXPECT_EQ(ask("create", file + "_new"), "Operation not permitted");
  EXPECT_EQ(ask("remove", file), "Operation not permitted");
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_FALSE(std::filesystem::exists(file + "_new"));
  std::filesystem::remove(file);
}

TEST(Reader, ReadsTheFileThatItIsGiven) {
  const std::string path = (std::filesystem::temp_directory_path() / ("sandbox_given_" + std::to_string(getpid()))).string();
  std::ofstream(path) << "content";
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  std::filesystem::remove(path);
  EXPECT_EQ(reader().ask({"file", {}, file.number()}, kLimits, path, "", {}), "content");
}

/// Neither bytes nor answers are files, which the shell's `ulimit -f` would bound.
TEST(Reader, NeedsNoFiles) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit none{0, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &none);
  const std::string text(1'000'000, 'x');
  EXPECT_EQ(ask("echo", text), text);
  setrlimit(RLIMIT_FSIZE, &before);
}

TEST(Reader, CancelEndsIt) {
  RunControl control;
  ask("echo");
  std::thread cancelling([&] {
    waitUntil([] { return below(getpid()).size() == 2; });  // the reader and its worker
    control.cancel();
  });
  try {
    ask("sleep", "", kLimits, control);
    ADD_FAILURE() << "it answered";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
  cancelling.join();
  EXPECT_TRUE(below(getpid()).empty());
  EXPECT_EQ(ask("echo", "next"), "next");
}

TEST(Reader, ThatWasKilledIsReplaced) {
  ask("echo");
  for (const pid_t child : childrenOf(getpid())) kill(child, SIGKILL);
  EXPECT_EQ(ask("echo", "again"), "again");
}

TEST(Reader, EndsWithTheProgramThatHasIt) {
  const pid_t program = fork();
  if (program == 0) {
    ask("sleep");
    _exit(0);
  }
  waitUntil([program] { return below(program).size() == 2; });
  const std::set<pid_t> both = below(program);
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  waitUntil([&] { return std::none_of(both.begin(), both.end(), alive); });
}

TEST(Reader, ServesManyThreads) {
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t)
    threads.emplace_back([t] {
      const std::string mine(1000 + static_cast<std::size_t>(t), static_cast<char>('a' + t));
      for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(ask("echo", mine), mine);
        if (i % 5 == t % 5) expectError("crash", ErrorCode::kReaderFailed, "crashed");
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_LE(childrenOf(getpid()).size(), 8u);
}

TEST(Reader, ThatCannotBeStarted) {
  ReaderProgram missing("no_such_program", "COLLISION_HULLS_NO_SUCH");
  try {
    missing.ask({"echo", {}, -1}, kLimits, "a.dae", "", {});
    ADD_FAILURE() << "it answered";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kReaderFailed);
    EXPECT_NE(std::string(error.what()).find("/no_such_program', cannot be started: No such file"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("COLLISION_HULLS_NO_SUCH"), std::string::npos) << error.what();
  }
}

TEST(Reader, ThatIsAnotherProgram) {
  setenv("COLLISION_HULLS_OTHER", "/bin/true", 1);
  ReaderProgram other("no_such_program", "COLLISION_HULLS_OTHER");
  try {
    other.ask({"echo", {}, -1}, kLimits, "a.dae", "", {});
    ADD_FAILURE() << "it answered";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kReaderFailed);
    EXPECT_NE(std::string(error.what()).find("a.dae: '/bin/true', which reads files, ended without an answer"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace collision_hulls
