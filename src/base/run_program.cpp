// Runs a program without a shell, so that no file name can turn into a command. The program leads a process group of its own, so that it
// ends with all that it has started, and a Ctrl-C in the terminal reaches it through us alone. If we are killed, the kernel kills it. That
// covers the program itself, not what it has started, nor one that runs as another user (set-user-ID); and posix_spawn() has no way to
// ask for it, hence fork(). prlimit() bounds its memory just after its start, before it can have read anything: bounded before, a copy of
// a large process might not get as far as that.
#include "base/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
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
#include "base/large_pages.h"

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

/// What the new process needs, since it may do nothing but async-signal-safe calls. The lists end with a null pointer.
struct Start {
  std::vector<char*> arguments, environment;
  int out, errors;  ///< where it writes
  int failure;      ///< where errno goes if it cannot become the program
  pid_t parent;
};

/// Turns the forked process into the program. It dies with the thread that forked it, which waits for it.
[[noreturn]] void become(const Start& start) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != start.parent) _exit(0);  // which died before it could take the program along
  for (const int ignored_by_us : {SIGPIPE, SIGXFSZ}) signal(ignored_by_us, SIG_DFL);
  close(STDIN_FILENO);
  open("/dev/null", O_RDONLY);  // takes the number that is free
  dup2(start.out, STDOUT_FILENO);
  dup2(start.errors, STDERR_FILENO);
  execvpe(start.arguments[0], start.arguments.data(), start.environment.data());
  const int error = errno;
  _exit(write(start.failure, &error, sizeof error) < 0);
}

/// The process, once it is the program; nullopt where there is no such program.
std::optional<pid_t> started(Start start) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail(errno, "a pipe");
  const Descriptor ours(ends[0]);
  Descriptor theirs(ends[1]);  // above the program's own three: the outputs and `ours` have taken those that were free
  start.failure = theirs.number();
  start.parent = getpid();
  const pid_t process = fork();
  if (process == 0) become(start);
  if (process < 0) fail(errno, start.arguments[0]);
  theirs.reset();
  int error = 0;
  while (read(ours.number(), &error, sizeof error) < 0 && errno == EINTR) continue;
  if (error == 0) return process;
  while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) continue;
  if (error == ENOENT) return std::nullopt;
  fail(error, start.arguments[0]);
}

/// A program that runs. Its group ends with it, or with this object.
class Running {
 public:
  explicit Running(pid_t process) : process_(process) {}
  ~Running() {
    if (!collected_) end();
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Its exit status, once it has ended.
  std::optional<int> status() {
    siginfo_t ended{};
    if (waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 && errno != EINTR) {
      collected_ = true;  // by others
      fail(errno, "waiting for a program");
    }
    if (ended.si_pid != process_) return std::nullopt;
    const int status = end();
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }

 private:
  /// Kills the group, then collects the program. Until that is collected its number stays taken: afterwards the group may be another's.
  int end() {
    kill(-process_, SIGKILL);
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
    collected_ = true;
    return status;
  }

  const pid_t process_;
  bool collected_ = false;
};

void expectLess(const Output& output, const ProgramLimits& limits, const std::string& program) {
  if (output.size() <= limits.output) return;
  throw Error(ErrorCode::kTooLarge,
              "'" + program + "' writes more than the limit of " + std::to_string(limits.output / 1'000'000) + " MB; does it call itself?");
}

/// What the caller of our program had in its environment, with these variables, each NAME=VALUE.
std::vector<char*> environmentWith(const std::vector<std::string>& variables) {
  const auto is_replaced = [&](const char* ours) {
    return std::any_of(variables.begin(), variables.end(), [&](const std::string& theirs) {
      return theirs.compare(0, theirs.find('=') + 1, ours, std::strcspn(ours, "=") + 1) == 0;
    });
  };
  std::vector<char*> result;
  for (char** ours = environ; *ours; ++ours)
    if (!is_replaced(*ours) && std::strcmp(*ours, kLargePages) != 0) result.push_back(*ours);
  for (const std::string& variable : variables) result.push_back(const_cast<char*>(variable.c_str()));
  result.push_back(nullptr);
  return result;
}

std::vector<char*> pointersTo(const std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (const std::string& text : texts) result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

}  // namespace

std::optional<ProgramResult> runProgram(const std::vector<std::string>& arguments, const RunControl& control, const ProgramLimits& limits,
                                        const std::vector<std::string>& variables) {
  const Output out, errors;
  const std::optional<pid_t> process =
      started({pointersTo(arguments), environmentWith(variables), out.descriptor(), errors.descriptor(), -1, 0});
  if (!process) return std::nullopt;
  Running running(*process);
  const rlimit memory{limits.memory, limits.memory};
  prlimit(*process, RLIMIT_AS, &memory, nullptr);
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
