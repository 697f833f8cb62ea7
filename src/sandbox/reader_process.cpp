// posix_spawn() copies nothing of the caller and runs nothing of it in the child, so other threads do no harm. The program gets the socket
// as standard input, the variables it needs, and, except in builds with sanitizers, nothing to write to. Signals of the terminal are
// blocked in it: its caller decides what a Ctrl-C means, and closing the socket ends it.
#include "sandbox/reader_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "base/sanitizer.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLook = 20;                            // [ms] between looks at the cancel flag
constexpr std::size_t kPipe = std::size_t{1} << 20;  // [bytes]: the most that Linux allows by default
constexpr int kGrace = 200;                          // [ms] for the program to end by itself
constexpr const char* kTunables = "GLIBC_TUNABLES";
constexpr const char* kPassed[] = {"LD_LIBRARY_PATH",  "ASAN_OPTIONS",      "UBSAN_OPTIONS", "TSAN_OPTIONS",
                                   "ROS_PACKAGE_PATH", "CMAKE_PREFIX_PATH", kTunables};

/// Files and signals of the program to start.
class Preparation {
 public:
  explicit Preparation(int socket) {
    posix_spawn_file_actions_init(&files_);
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_adddup2(&files_, socket, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    if (!kSanitized) posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    sigset_t set;
    sigfillset(&set);
    posix_spawnattr_setsigdefault(&attributes_, &set);
    sigemptyset(&set);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP}) sigaddset(&set, signal);
    posix_spawnattr_setsigmask(&attributes_, &set);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  }
  ~Preparation() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  posix_spawn_file_actions_t* files() { return &files_; }
  posix_spawnattr_t* attributes() { return &attributes_; }

 private:
  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

std::vector<std::string> environmentOfReader() {
  std::vector<std::string> result{"LC_ALL=C"};
  // Large pages, where the kernel and the C library have them: each worker's memory is new, and most of the cost of new memory is per page.
  if (!std::getenv(kTunables)) result.push_back(std::string(kTunables) + "=glibc.malloc.hugetlb=1");
  for (const char* const name : kPassed)
    if (const char* const value = std::getenv(name)) result.push_back(std::string(name) + "=" + value);
  return result;
}

[[noreturn]] void failToStart(const std::string& program, const std::string& variable, int error) {
  const bool for_want = error == EAGAIN || error == ENOMEM || error == EMFILE || error == ENFILE;
  throw Error(ErrorCode::kReaderFailed,
              "the program that reads files, '" + program + "', cannot be started: " + std::strerror(error) +
                  (for_want ? "; end other processes, or allow more" : "; install it again, or name it in " + variable));
}

/// The number of the new process, or minus errno.
pid_t start(const std::string& program, int socket) {
  Preparation preparation(socket);
  std::vector<std::string> environment = environmentOfReader();
  std::vector<char*> variables;
  for (std::string& variable : environment) variables.push_back(variable.data());
  variables.push_back(nullptr);
  char* const arguments[] = {const_cast<char*>(program.c_str()), nullptr};
  pid_t process = -1;
  const int error = posix_spawn(&process, program.c_str(), preparation.files(), preparation.attributes(), arguments, variables.data());
  return error == 0 ? process : -error;
}

/// Thrown by Exchange when the question has ended early.
struct Ended {
  ReaderOutcome::Kind kind;
};

/// Bytes to and from a reader program, with an eye on the clock and the cancel flag.
class Exchange {
 public:
  Exchange(int socket, const ReadingLimits& limits, const RunControl& control)
      : socket_(socket),
        end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits.clock_seconds))),
        control_(control) {}

  void send(const ReaderQuestion& question, const WorkerLimits& limits, int answer) {
    QuestionHeader header;
    header.limits = limits;
    header.head_size = question.head.size();
    header.body_size = question.body.size();
    const auto with = [&](const char* at, std::size_t size) { return sendWith(socket_, at, size, {answer, question.file}, MSG_DONTWAIT); };
    const auto alone = [&](const char* at, std::size_t size) { return ::send(socket_, at, size, MSG_NOSIGNAL | MSG_DONTWAIT); };
    all(reinterpret_cast<const char*>(&header), sizeof header, {socket_, POLLOUT, 0}, with);
    all(question.head.data(), question.head.size(), {socket_, POLLOUT, 0}, alone);
    all(question.body.data(), question.body.size(), {socket_, POLLOUT, 0}, alone);
  }

  /// Up to the end of what the worker writes. Takes no more memory than that needs.
  std::string receiveAnswer(int pipe, std::uint64_t longest) {
    std::string answer;
    const std::unique_ptr<char[]> piece(new char[kPipe]);  // no more of it is touched than comes
    for (;;) {
      const long got = part({pipe, POLLIN, 0}, [&] { return read(pipe, piece.get(), kPipe); });
      if (got == 0) return answer;
      if (answer.size() + static_cast<std::size_t>(got) > longest) throw Ended{ReaderOutcome::Kind::kTooLong};
      answer.append(piece.get(), static_cast<std::size_t>(got));
    }
  }

  Ending receiveEnding() {
    Ending ending;
    all(reinterpret_cast<char*>(&ending), sizeof ending, {socket_, POLLIN, 0},
        [&](char* at, std::size_t size) { return recv(socket_, at, size, MSG_DONTWAIT); });
    return ending;
  }

 private:
  /// `move(at, size)` sends or receives a part of `size` bytes.
  template <typename Pointer, typename Move>
  void all(Pointer at, std::size_t size, const pollfd& ready, const Move& move) {
    while (size > 0) {
      const long moved = part(ready, [&] { return move(at, size); });
      if (moved == 0) throw Ended{ReaderOutcome::Kind::kReaderEnded};
      at += moved;
      size -= static_cast<std::size_t>(moved);
    }
  }

  /// What `call` returns once it does not have to wait.
  template <typename Call>
  long part(pollfd ready, const Call& call) {
    for (;;) {
      control_.check();
      const long moved = call();
      if (moved >= 0) return moved;
      if (errno != EAGAIN && errno != EINTR) throw Ended{ReaderOutcome::Kind::kReaderEnded};
      if (Clock::now() > end_) throw Ended{ReaderOutcome::Kind::kTooSlow};
      poll(&ready, 1, kLook);
    }
  }

  int socket_;
  Clock::time_point end_;
  const RunControl& control_;
};

/// A pipe: this end, from which reading never waits, and the worker's.
Descriptors pipeForAnswer() {
  Numbers ends{-1, -1};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error(ErrorCode::kReaderFailed,
                std::string("there is no pipe for what a file holds: ") + std::strerror(errno) + "; close other files, or allow more");
  Descriptors result{Descriptor(ends[0]), Descriptor(ends[1])};
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  fcntl(ends[0], F_SETPIPE_SZ, static_cast<int>(kPipe));  // where that is not allowed, it takes more turns
  return result;
}

}  // namespace

ReaderProcess::ReaderProcess(const std::string& program, const std::string& variable) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) failToStart(program, variable, errno);
  socket_ = Descriptor(ends[0]);
  const Descriptor theirs(ends[1]);
  process_ = start(program, theirs.number());
  if (process_ < 0) failToStart(program, variable, -process_);
}

ReaderProcess::~ReaderProcess() {
  socket_.reset();  // kills the worker and ends the program
  for (int waited = 0; waited < kGrace; ++waited) {
    if (waitpid(process_, nullptr, WNOHANG) != 0) return;
    const timespec millisecond{0, 1'000'000};
    nanosleep(&millisecond, nullptr);
  }
  kill(process_, SIGKILL);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
}

ReaderOutcome ReaderProcess::ask(const ReaderQuestion& question, const ReadingLimits& limits, const RunControl& control) {
  ReaderOutcome outcome;
  try {
    Exchange exchange(socket_.number(), limits, control);
    Descriptors answer = pipeForAnswer();
    exchange.send(question, limits.worker, answer[1].number());
    answer[1].reset();
    outcome.answer = exchange.receiveAnswer(answer[0].number(), limits.answer);
    outcome.worker = exchange.receiveEnding();
  } catch (const Ended& ended) {
    outcome.kind = ended.kind;
  }
  return outcome;
}

}  // namespace collision_hulls
