// The program among others: pipes, terminals, signals and limits.
// Also tests src/tools/decompose.cpp.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/descriptor.h"
#include "tools/decompose_program_test.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class DecomposeStreams : public DecomposeProgramTest {};

// A limit on the size of files is met like the end of a disk, but for a signal.
TEST_F(DecomposeStreams, AFileThatCannotBeCompletedLeavesTheOutputAsItWas) {
  EXPECT_EQ(run("arm_description --quiet -o out -m single_hull --json report.json").status, 0);
  const auto before = fixtures::contents(folder_.path());
  for (const std::string output : {"-o out", "-o other"}) {
    const Finished result = run("arm_description --quiet --no-cache --json report.json " + output, "ulimit -f 1; ");
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_NE(result.err.find("File too large; choose another output, or check its permissions and free space"), std::string::npos)
        << result.err;
    EXPECT_EQ(fixtures::contents(folder_.path()), before);
  }
}

// Neither a FIFO nor a device in place of a file keeps the program waiting.
TEST_F(DecomposeStreams, WhatIsNoFile) {
  ASSERT_EQ(run("mkfifo", "mkfifo fifo.urdf fifo.stl; mkdir out; mkfifo out/report.json; ln -s /dev/zero zero.urdf; ").status, 2);
  for (const std::string input : {"fifo.urdf", "fifo.stl", "zero.urdf"}) expectWrongUse(input + " --quiet", {input, "not a regular file"});
  expectWrongUse("arm_description --quiet -o out", {"out' is not an earlier output"});
}

TEST_F(DecomposeStreams, AReportInAPipe) {
  const Finished unread = run("arm_description --quiet -o out --json pipe", "mkfifo pipe; ");
  EXPECT_EQ(unread.status, 2);
  EXPECT_NE(unread.err.find("'pipe': nobody reads this pipe (start its reader first)"), std::string::npos) << unread.err;
  EXPECT_TRUE(fs::exists(folder_ / "out/report.json")) << "all the rest is written";
  const Descriptor reader(open((folder_ / "pipe").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  EXPECT_EQ(run("arm_description --quiet -o out --json pipe").status, 0);
  std::string text(std::size_t{1} << 16, '\0');  // as much as a pipe takes
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(reader.number(), text.data(), text.size()))));
  const Finished piped = run("arm_description --quiet -o out --json /dev/stdout | cat");
  EXPECT_EQ(piped.err, "");
  for (const std::string& report : {text, piped.out}) EXPECT_EQ(json::parse(report, nullptr, false)["links"].size(), 1u) << report;
}

// As in `decompose ... 2>&1 | head -1`: SIGPIPE would end the run.
TEST_F(DecomposeStreams, ReadersThatGoAway) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  close(ends[0]);
  const std::string robot = folder_ / "arm/urdf/arm.urdf", out = folder_ / "out", report = folder_ / "report.json";
  const pid_t child = fork();
  if (child == 0) {
    for (const int number : {STDOUT_FILENO, STDERR_FILENO}) dup2(ends[1], number);
    signal(SIGPIPE, SIG_DFL);
    execl(PROGRAMS "/decompose", "decompose", robot.c_str(), "-o", out.c_str(), "--json", report.c_str(), static_cast<char*>(nullptr));
    _exit(99);
  }
  close(ends[1]);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_FALSE(fixtures::read(report).empty());
  EXPECT_EQ(fixtures::read(report), fixtures::read(folder_ / "out/report.json"));
}

TEST_F(DecomposeStreams, ABarOnATerminal) {
  const std::string command =
      "cd '" + folder_.path().string() + "' && script -qec \"" PROGRAMS "/decompose arm/urdf/arm.urdf\" /dev/null > .terminal < /dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string seen = fixtures::read(folder_ / ".terminal");
  const std::size_t reading = seen.find("reading 1 mesh of 1 link"), bar = seen.find("[....................]   0 %  0 of 1 mesh"),
                    end = seen.find("] 100 %  validating"), table = seen.find("protrusion");
  EXPECT_LT(reading, bar);
  EXPECT_LT(bar, end);
  EXPECT_LT(end, table);
  EXPECT_NE(table, std::string::npos);
  EXPECT_EQ(seen.rfind("\r\033[K") + 4, seen.rfind("link ", table)) << "the bar is gone before the table";
}

/// Waits until a process has a handler for a signal, as it has once its run has begun.
bool awaitHandler(pid_t process, int number) {
  const std::string key = "SigCgt:";
  for (int i = 0; i < 6000; ++i, usleep(10'000)) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);)
      if (line.rfind(key, 0) == 0 && (std::stoull(line.substr(key.size()), nullptr, 16) >> (number - 1) & 1) != 0) return true;
  }
  return false;
}

// A torus of many triangles: long enough to be interrupted in the middle.
TEST_F(DecomposeStreams, InterruptLeavesTheOutputAsItWas) {
  run("arm/meshes/bracket.obj -o out --quiet");
  const auto before = fixtures::contents(folder_ / "out");
  ASSERT_FALSE(before.empty());
  const std::string mesh = fixtures::write(folder_ / "torus.obj", fixtures::obj(test_shapes::torus(1, 0.3, 600, 300)));
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const std::string out = folder_ / "out";
    const pid_t child = fork();
    if (child == 0) {
      ::signal(signal, SIG_DFL);  // it stays ignored if these tests were started by nohup
      if (!freopen((folder_ / "err").c_str(), "w", stderr)) _exit(98);
      execl(PROGRAMS "/decompose", "decompose", mesh.c_str(), "-o", out.c_str(), "--quiet", static_cast<char*>(nullptr));
      _exit(99);
    }
    EXPECT_TRUE(awaitHandler(child, signal));
    usleep(100'000);  // into the work
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_EQ(fixtures::read(folder_ / "err"), "decompose: interrupted; nothing was written\n");
    EXPECT_EQ(fixtures::contents(folder_ / "out"), before);
  }
}

/// A pipe that one page fills.
struct SmallPipe {
  explicit SmallPipe(const std::string& fifo = "") {
    if (fifo.empty()) {
      int ends[2] = {-1, -1};
      EXPECT_EQ(pipe2(ends, O_CLOEXEC), 0);
      read_end = Descriptor(ends[0]), write_end = Descriptor(ends[1]);
    } else {
      EXPECT_EQ(mkfifo(fifo.c_str(), 0600), 0);
      read_end = Descriptor(open(fifo.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    }
    EXPECT_EQ(fcntl(read_end.number(), F_SETPIPE_SZ, kPage), kPage);
  }
  int held() const {
    int bytes = 0;
    ioctl(read_end.number(), FIONREAD, &bytes);
    return bytes;
  }
  void fill() const {  // with a place of its own for O_NONBLOCK, which whoever writes to `write_end` must not have
    const Descriptor own(open(("/proc/self/fd/" + std::to_string(write_end.number())).c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC));
    while (write(own.number(), ".", 1) == 1) {
    }
  }
  /// Whether it is full in the end.
  bool awaitFull() const {
    for (int i = 0; i < 6000 && held() < kPage; ++i) usleep(10'000);
    return held() == kPage;
  }

  static constexpr int kPage = 4096;
  Descriptor read_end, write_end;
};

/// `decompose` beside the test. A file that is given takes the place of its standard output or error.
class Started {
 public:
  explicit Started(std::vector<std::string> arguments, const std::map<int, int>& files = {}) : child_(fork()) {
    if (child_ != 0) return;
    signal(SIGINT, SIG_DFL);  // it stays ignored if these tests were started by nohup
    for (const auto& [number, file] : files) dup2(file, number);
    arguments.insert(arguments.begin(), "decompose");
    std::vector<char*> words;
    for (std::string& word : arguments) words.push_back(word.data());
    words.push_back(nullptr);
    execv(PROGRAMS "/decompose", words.data());
    _exit(99);
  }

  /// Its status as of waitpid() after one SIGINT; -1 if that did not end it.
  int interrupted() const {
    kill(child_, SIGINT);
    int status = 0;
    for (int i = 0; i < 1000; ++i, usleep(10'000))
      if (waitpid(child_, &status, WNOHANG) == child_) return status;
    kill(child_, SIGKILL);
    waitpid(child_, &status, 0);
    return -1;
  }

 private:
  pid_t child_;
};

// As in `decompose ... > fifo` with a reader that sleeps. Nothing is left to undo when the report is printed.
TEST_F(DecomposeStreams, OneInterruptEndsTheWaitForAReaderThatDoesNotRead) {
  std::string links = fixtures::link("base", collision("bracket.obj"));
  for (const std::string name : {"a", "b", "c", "d"}) links += fixtures::link(name, collision("bracket.obj"), "base");
  addRobot("arm/urdf/arm.urdf", links);
  const std::string robot = folder_ / "arm/urdf/arm.urdf", out = folder_ / "out", fifo = folder_ / "fifo", err = folder_ / "err";
  {
    const SmallPipe pipe;
    const Started run({robot, "-o", out, "-m", "bounding_box", "--json", "-"}, {{STDOUT_FILENO, pipe.write_end.number()}});
    ASSERT_TRUE(pipe.awaitFull());
    const int status = run.interrupted();
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
    EXPECT_TRUE(fs::exists(folder_ / "out/report.json")) << "it was written before";
  }
  const SmallPipe pipe(fifo);
  const Descriptor errors(open(err.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
  const Started run({robot, "-o", out, "-m", "bounding_box", "--quiet", "--json", fifo}, {{STDERR_FILENO, errors.number()}});
  ASSERT_TRUE(pipe.awaitFull());
  const int status = run.interrupted();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 2) << status;
  EXPECT_EQ(fixtures::read(err), "decompose: interrupted before the reader of '" + fifo +
                                     "' took all that is to be written there; start one that reads, or give a file\n");
}

TEST_F(DecomposeStreams, OneInterruptEndsARunWhoseProgressNobodyReads) {
  const std::string mesh = fixtures::write(folder_ / "torus.obj", fixtures::obj(test_shapes::torus(1, 0.3, 600, 300)));
  const SmallPipe pipe;
  const Started run({mesh, "-o", folder_ / "out"}, {{STDERR_FILENO, pipe.write_end.number()}});
  for (int i = 0; i < 6000 && pipe.held() == 0; ++i) usleep(10'000);
  pipe.fill();
  const int status = run.interrupted();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 130) << status;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace collision_hulls
