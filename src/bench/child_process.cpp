// A child runs in its own process group. When its time is up, or once it ends, the whole group is killed and reaped: the caller is a
// subreaper (Linux), so grandchildren whose parent died are its children and their CPU time counts.
#include "bench/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

#include "base/shell_word.h"
#include "base/stopwatch.h"

namespace collision_hulls {
namespace {

constexpr int kNotStarted = 127;    // the shell's exit status for a command not found
constexpr long kMostOutput = 4000;  // characters

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// Kills a process group when the time is up, unless called off before.
class TimeLimit {
 public:
  TimeLimit(pid_t group, double limit) : thread_([this, group, limit] { watch(group, limit); }) {}
  ~TimeLimit() { callOff(); }
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;

  /// Stops the watch; returns true if it had to kill.
  bool callOff() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      called_off_ = true;
    }
    change_.notify_one();
    if (thread_.joinable()) thread_.join();
    return killed_;
  }

 private:
  void watch(pid_t group, double limit) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (!change_.wait_for(lock, std::chrono::duration<double>(limit), [this] { return called_off_; })) killed_ = kill(-group, SIGKILL) == 0;
  }

  std::mutex mutex_;
  std::condition_variable change_;
  bool called_off_ = false, killed_ = false;
  std::thread thread_;  // last, as it uses the other members
};

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Turns the forked process into the program; only async-signal-safe calls are allowed here. It gets its own group, so that it can be
/// killed together with everything it starts, and it dies with the thread that waits for it.
[[noreturn]] void become(const std::vector<char*>& argv, int output) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int ignored_by_us : {SIGPIPE, SIGXFSZ}) signal(ignored_by_us, SIG_DFL);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  execvp(argv[0], argv.data());
  const char reason[] = "cannot start: no such program, or no permission\n";
  if (write(STDERR_FILENO, reason, sizeof reason - 1) < 0) _exit(kNotStarted);
  _exit(kNotStarted);
}

std::string endOf(std::FILE* file) {
  std::fseek(file, 0, SEEK_END);
  std::fseek(file, std::max(0L, std::ftell(file) - kMostOutput), SEEK_SET);
  std::string text(kMostOutput, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  return text;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void add(const rusage& used, ChildResult& result) {
  result.cpu_seconds += seconds(used.ru_utime) + seconds(used.ru_stime);
  result.peak_mb = std::max(result.peak_mb, static_cast<double>(used.ru_maxrss) / 1024);
}

/// Reaps what is left of a group that was killed: orphans have become children of this process.
void reapRest(pid_t group, ChildResult& result) {
  rusage used{};
  while (wait4(-group, nullptr, 0, &used) > 0) add(used, result);
}

/// Waits for the process without reaping it, so that its number stays taken and no other process can be killed in its place. Returns true
/// if it had to be killed.
bool await(pid_t process, double limit) {
  TimeLimit time_limit(process, limit);
  siginfo_t ended{};
  while (waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOWAIT) != 0)
    if (errno != EINTR) fail("waiting for a process");
  return time_limit.callOff();
}

}  // namespace

ChildResult runChild(const std::vector<std::string>& arguments, double limit) {
  const File output(std::tmpfile(), &std::fclose);
  if (!output) fail("temporary file");
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);

  prctl(PR_SET_CHILD_SUBREAPER, 1);  // so that what a killed shell was running can be waited for, and its time counted
  Stopwatch clock;
  const pid_t process = fork();
  if (process < 0) fail("a new process");
  if (process == 0) become(argv, fileno(output.get()));
  setpgid(process, process);  // in the parent, too: either process may get here first

  ChildResult result;
  const bool killed = await(process, limit);
  result.wall_seconds = clock.lap();
  kill(-process, SIGKILL);  // what is left of the group: once the process is reaped, the group's number may be another's
  int status = 0;
  rusage used{};
  if (wait4(process, &status, 0, &used) != process) fail("reaping a process");
  add(used, result);
  reapRest(process, result);
  result.end = killed ? ChildResult::End::kTimeout : WIFSIGNALED(status) ? ChildResult::End::kSignal : ChildResult::End::kExit;
  result.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  result.output = endOf(output.get());
  return result;
}

std::string filledIn(const std::string& command, const std::vector<std::pair<std::string, std::string>>& values) {
  std::string result;
  for (std::size_t at = 0; at < command.size();) {
    const std::size_t before = at;
    for (const auto& [name, value] : values) {
      const std::string place = "{" + name + "}";
      if (command.compare(at, place.size(), place) != 0) continue;
      result += shellWord(value);
      at += place.size();
      break;
    }
    if (at == before) result += command[at++];
  }
  return result;
}

}  // namespace collision_hulls
