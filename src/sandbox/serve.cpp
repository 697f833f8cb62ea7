// The reader passes bytes on and never looks at them. Its worker, a fork, does, and writes the answer into a pipe that the library made for
// this question. The reader says on its own knowledge how the worker ended. So a worker that a hostile file has taken over can lie about
// that file and about nothing else. If the library closes the socket, the worker is killed at once.
#include "sandbox/serve.h"

#include <fcntl.h>
#include <malloc.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iostream>

#include "base/descriptor.h"
#include "collision_hulls/error.h"
#include "geometry/bytes.h"
#include "sandbox/confine.h"
#include "sandbox/wire.h"

namespace collision_hulls {
namespace {

constexpr int kSocket = STDIN_FILENO;

bool isSocket(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 && S_ISSOCK(status.st_mode);
}

/// Each worker's memory is new, and most of the cost of new memory is per page: take much at once, of large pages if there are any (see the
/// environment in reader_process.cpp), and keep it.
void takeMemoryInLargePieces() {
#ifdef __GLIBC__
  mallopt(M_TOP_PAD, 64 << 20);
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

/// Closes what a library's program left open across exec.
void closeInherited() {
#ifdef SYS_close_range
  if (syscall(SYS_close_range, STDERR_FILENO + 1, ~0U, 0) == 0) return;
#endif
  rlimit most{};
  getrlimit(RLIMIT_NOFILE, &most);
  for (int i = STDERR_FILENO + 1; i < static_cast<int>(std::min<rlim_t>(most.rlim_cur, 65536)); ++i) close(i);
}

struct Answer {
  std::string bytes;
  AnswerKind kind;
};

Answer answerOrError(const AnswerFunction& answer, const Question& question, const Protection& protection) {
  try {
    return {question.head == kAskProtection ? text(protection) : answer(question), AnswerKind::kAnswer};
  } catch (const Error& error) {
    return {toBytes(error.code(), std::string(error.what())), AnswerKind::kError};
  } catch (const std::bad_alloc&) {
    _exit(kWorkerOutOfMemory);
  } catch (const std::exception& error) {
    return {error.what(), AnswerKind::kException};
  }
}

/// What the reader keeps of one question, and its worker gets.
struct Job {
  QuestionHeader header;
  Question question;
  Descriptors given;                    // the pipe for the answer, and the file
  Descriptor readers_end, workers_end;  // of another pipe, which shows by closing that the worker has ended
};

[[noreturn]] void work(const AnswerFunction& answer, Job& job, pid_t reader) {
  const Protection protection = confine(job.header.limits, reader);
  close(kSocket);
  job.readers_end.reset();
  const auto [bytes, kind] = answerOrError(answer, job.question, protection);
  const char last = static_cast<char>(kind);
  const int pipe = job.given[0].number();
  const bool written = writeAll(pipe, bytes) && writeAll(pipe, {&last, 1});
  _exit(written ? 0 : 1);
}

/// Returns true when the worker has ended, false if nobody waits for it any more, or if that cannot be told.
bool awaitWorker(int pipe) {
  pollfd either[] = {{pipe, POLLIN, 0}, {kSocket, POLLRDHUP, 0}};
  int ready = poll(either, 2, -1);
  while (ready < 0 && errno == EINTR) ready = poll(either, 2, -1);
  return ready > 0 && either[1].revents == 0;
}

/// Kills a worker, if it has not ended, and says how it did. One that has called exit() keeps its status.
Ending reaped(pid_t worker) {
  kill(worker, SIGKILL);
  int status = 0;
  while (waitpid(worker, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFSIGNALED(status)) return {Ending::Kind::kSignal, WTERMSIG(status)};
  return {Ending::Kind::kExit, WEXITSTATUS(status)};
}

/// Returns false if nobody waits for it any more.
bool sendEnding(const Ending& ending) {
  return send(kSocket, &ending, sizeof ending, MSG_NOSIGNAL) == static_cast<long>(sizeof ending);
}

bool answerInWorker(const AnswerFunction& answer, Job& job) {
  int ends[2] = {-1, -1};
  if (pipe2(ends, O_CLOEXEC) != 0) return sendEnding({Ending::Kind::kNotForked, errno});
  job.readers_end = Descriptor(ends[0]);
  job.workers_end = Descriptor(ends[1]);
  const pid_t reader = getpid();
  const pid_t worker = fork();
  if (worker == 0) work(answer, job, reader);
  if (worker < 0) return sendEnding({Ending::Kind::kNotForked, errno});
  job.workers_end.reset();
  for (Descriptor& given : job.given) given.reset();  // the library waits for the pipe to close
  const bool awaited = awaitWorker(job.readers_end.number());
  const Ending ending = reaped(worker);
  return awaited && sendEnding(ending);
}

bool receiveText(std::string& text, std::uint64_t size) {
  text.resize(size);
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t got = recv(kSocket, text.data() + done, text.size() - done, MSG_WAITALL);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    done += static_cast<std::size_t>(got);
  }
  return true;
}

bool serveOne(const AnswerFunction& answer) {
  Job job;
  if (receiveWith(kSocket, &job.header, sizeof job.header, job.given, MSG_WAITALL) != static_cast<long>(sizeof job.header)) return false;
  if (job.header.version != kWireVersion) {
    sendEnding({Ending::Kind::kOtherVersion, 0});
    return false;
  }
  job.question.file = job.given[1].number();
  return receiveText(job.question.head, job.header.head_size) && receiveText(job.question.body, job.header.body_size) &&
         answerInWorker(answer, job);
}

}  // namespace

int serve(const AnswerFunction& answer) {
  if (!isSocket(kSocket)) {
    std::cerr << "This program reads files for the library collision_hulls, which starts it; by hand it does nothing.\n";
    return 2;
  }
  closeInherited();
  takeMemoryInLargePieces();
  while (serveOne(answer)) continue;
  return 0;
}

}  // namespace collision_hulls
