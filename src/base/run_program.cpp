// Runs a program without a shell, so that no file name can turn into a command. The program leads a process group of its own, so that it
// ends with all that it has started, and a Ctrl-C in the terminal reaches it through us alone. prlimit() bounds its memory just after its
// start, before it can have read anything.
#include "base/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>
#include <thread>

#include "base/descriptor.h"

extern char** environ;

namespace collision_hulls {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

// A file without a name. Unlike a pipe it takes any amount of output while nobody reads.
class Output {
 public:
  Output() : file_(std::tmpfile(), &std::fclose) {
    if (!file_) fail(errno, "temporary file");
    // Above the program's own three, whichever of these are closed here, and not for programs that start meanwhile.
    descriptor_ = Descriptor(fcntl(fileno(file_.get()), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
    if (descriptor_.number() < 0) fail(errno, "temporary file");
    fcntl(fileno(file_.get()), F_SETFD, FD_CLOEXEC);
  }
  int descriptor() const { return descriptor_.number(); }

  std::uint64_t size() const {
    struct stat status {};
    return fstat(descriptor(), &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
  }

  std::string text() const {
    std::string text;
    std::rewind(file_.get());
    char buffer[4096];
    while (const std::size_t size = std::fread(buffer, 1, sizeof buffer, file_.get())) text.append(buffer, size);
    return text;
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  Descriptor descriptor_;
};

/// How the program starts: its three files, and a process group of its own.
class Preparation {
 public:
  Preparation(const Output& out, const Output& errors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, out.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, errors.descriptor(), STDERR_FILENO);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  ~Preparation() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;
  const posix_spawn_file_actions_t* files() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

/// A program that runs. Its group ends with this object at the latest.
class Running {
 public:
  explicit Running(pid_t process) : process_(process) {}
  ~Running() {
    kill(-process_, SIGKILL);
    while (!ended_ && waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Its exit status, once it has ended.
  std::optional<int> status() {
    int status = 0;
    const pid_t found = waitpid(process_, &status, WNOHANG);
    if (found < 0 && errno != EINTR) fail(errno, "waiting for a program");
    if (found != process_) return std::nullopt;
    ended_ = true;
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }

 private:
  const pid_t process_;
  bool ended_ = false;
};

void expectLess(const Output& output, const ProgramLimits& limits, const std::string& program) {
  if (output.size() <= limits.output) return;
  throw Error(ErrorCode::kTooLarge,
              "'" + program + "' writes more than the limit of " + std::to_string(limits.output / 1'000'000) + " MB; does it call itself?");
}

/// Our environment with these variables, each NAME=VALUE.
std::vector<char*> environmentWith(const std::vector<std::string>& variables) {
  const auto is_replaced = [&](const char* ours) {
    return std::any_of(variables.begin(), variables.end(), [&](const std::string& theirs) {
      return theirs.compare(0, theirs.find('=') + 1, ours, std::strcspn(ours, "=") + 1) == 0;
    });
  };
  std::vector<char*> result;
  for (char** ours = environ; *ours; ++ours)
    if (!is_replaced(*ours)) result.push_back(*ours);
  for (const std::string& variable : variables) result.push_back(const_cast<char*>(variable.c_str()));
  result.push_back(nullptr);
  return result;
}

}  // namespace

std::optional<ProgramResult> runProgram(const std::vector<std::string>& arguments, const RunControl& control, const ProgramLimits& limits,
                                        const std::vector<std::string>& variables) {
  const Output out, errors;
  const Preparation preparation(out, errors);
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const std::vector<char*> environment = environmentWith(variables);
  pid_t process = 0;
  const int error = posix_spawnp(&process, argv[0], preparation.files(), preparation.attributes(), argv.data(), environment.data());
  if (error == ENOENT) return std::nullopt;
  if (error != 0) fail(error, arguments.front());
  Running running(process);
  const rlimit memory{limits.memory, limits.memory};
  prlimit(process, RLIMIT_AS, &memory, nullptr);
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits.seconds));
  for (auto pause = std::chrono::milliseconds(1);; pause = std::min(2 * pause, std::chrono::milliseconds(50))) {
    const std::optional<int> status = running.status();
    for (const Output* const output : {&out, &errors}) expectLess(*output, limits, arguments.front());
    if (status) return ProgramResult{*status, out.text(), errors.text()};
    control.check();
    if (Clock::now() > end)
      throw Error(ErrorCode::kOutOfTime, "'" + arguments.front() + "' takes longer than the limit of " +
                                             std::to_string(static_cast<int>(limits.seconds)) + " s; run it by hand and give its output");
    std::this_thread::sleep_for(pause);
  }
}

}  // namespace collision_hulls
