// The reader holds the socket and looks at sizes alone. Its worker, a fork, sees the bytes and writes into a pipe; the reader passes that
// on piece by piece and says at the end, on its own knowledge, how the worker ended. So a worker that a hostile file has taken over can lie
// about that file and about nothing else. If the library closes the socket, the worker is killed at once.
#include "sandbox/serve.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <iostream>
#include <vector>

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

/// Closes what a library's program left open across exec.
void closeInherited() {
#ifdef SYS_close_range
  if (syscall(SYS_close_range, STDERR_FILENO + 1, ~0U, 0) == 0) return;
#endif
  rlimit most{};
  getrlimit(RLIMIT_NOFILE, &most);
  for (int i = STDERR_FILENO + 1; i < static_cast<int>(std::min<rlim_t>(most.rlim_cur, 65536)); ++i) close(i);
}

void writeAll(int pipe, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = write(pipe, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(1);
    done += static_cast<std::size_t>(written);
  }
}

std::string answerOrError(const AnswerFunction& answer, const Question& question, const Protection& protection) {
  const auto closedBy = [](std::string bytes, AnswerKind kind) { return bytes += static_cast<char>(kind); };
  try {
    return closedBy(question.head == kAskProtection ? text(protection) : answer(question), AnswerKind::kAnswer);
  } catch (const Error& error) {
    return closedBy(toBytes(error.code(), std::string(error.what())), AnswerKind::kError);
  } catch (const std::bad_alloc&) {
    _exit(kOutOfMemory);
  } catch (const std::exception& error) {
    return closedBy(error.what(), AnswerKind::kException);
  }
}

[[noreturn]] void work(const AnswerFunction& answer, const Question& question, const QuestionHeader& header, int pipe, int readers_end,
                       pid_t reader) {
  const Protection protection = confine(header.memory, header.cpu_seconds, reader);
  close(kSocket);
  close(readers_end);
  writeAll(pipe, answerOrError(answer, question, protection));
  _exit(0);
}

/// Kills a worker, if it has not ended, and says how it did. One that has called exit() keeps its status.
Ending reaped(pid_t worker) {
  kill(worker, SIGKILL);
  int status = 0;
  while (waitpid(worker, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFSIGNALED(status)) return {Ending::Kind::kSignal, WTERMSIG(status)};
  return {Ending::Kind::kExit, WEXITSTATUS(status)};
}

bool sendPiece(const char* bytes, std::size_t size) {
  const auto prefix = static_cast<std::uint32_t>(size);
  return sendAll(kSocket, &prefix, sizeof prefix) && sendAll(kSocket, bytes, size);
}

/// Passes on what the worker writes until it closes the pipe. Returns false if nobody listens any more.
bool relay(int pipe) {
  std::vector<char> piece(kMostPiece);
  for (;;) {
    pollfd either[] = {{pipe, POLLIN, 0}, {kSocket, POLLRDHUP, 0}};
    if (poll(either, 2, -1) < 0) continue;  // EINTR
    if (either[1].revents != 0) return false;
    const ssize_t got = read(pipe, piece.data(), piece.size());
    if (got == 0) return true;
    if (got > 0 && !sendPiece(piece.data(), static_cast<std::size_t>(got))) return false;
  }
}

/// Returns false if nobody listens any more.
bool sendEnding(const Ending& ending) {
  return sendPiece(nullptr, 0) && sendAll(kSocket, &ending, sizeof ending);
}

bool answerInWorker(const AnswerFunction& answer, const Question& question, const QuestionHeader& header) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return sendEnding({Ending::Kind::kNotForked, errno});
  const Descriptor from_worker(ends[0]);
  Descriptor to_reader(ends[1]);
  const pid_t reader = getpid();
  const pid_t worker = fork();
  if (worker == 0) work(answer, question, header, to_reader.number(), from_worker.number(), reader);
  if (worker < 0) return sendEnding({Ending::Kind::kNotForked, errno});
  to_reader.reset();
  const bool heard = relay(from_worker.number());
  const Ending ending = reaped(worker);
  return heard && sendEnding(ending);
}

/// Opens a question's file before the worker exists, which could not.
bool openAndAnswer(const AnswerFunction& answer, Question& question, const std::string& path, const QuestionHeader& header) {
  if (path.empty()) return answerInWorker(answer, question, header);
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
  struct stat status {};
  if (file.number() < 0 || fstat(file.number(), &status) != 0) return sendEnding({Ending::Kind::kNotOpened, errno});
  if (!S_ISREG(status.st_mode)) return sendEnding({Ending::Kind::kNotOpened, EINVAL});
  question.file = file.number();
  return answerInWorker(answer, question, header);
}

bool receiveText(std::string& text, std::uint64_t size) {
  text.resize(size);
  return receiveAll(kSocket, text.data(), text.size());
}

bool serveOne(const AnswerFunction& answer) {
  QuestionHeader header;
  if (!receiveAll(kSocket, &header, sizeof header)) return false;
  if (header.version != kWireVersion) return sendEnding({Ending::Kind::kOtherVersion, 0}) && false;
  Question question;
  std::string path;
  if (!receiveText(path, header.file_size) || !receiveText(question.head, header.head_size) ||
      !receiveText(question.body, header.body_size))
    return false;
  return openAndAnswer(answer, question, path, header);
}

}  // namespace

int serve(const AnswerFunction& answer) {
  if (!isSocket(kSocket)) {
    std::cerr << "This program reads files for the library collision_hulls, which starts it; by hand it does nothing.\n";
    return 2;
  }
  closeInherited();
  while (serveOne(answer)) continue;
  return 0;
}

}  // namespace collision_hulls
