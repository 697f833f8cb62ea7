// Reads through a file descriptor, so that what was looked at is what is read, even if the path leads elsewhere meanwhile. O_NONBLOCK keeps
// open() from waiting for a FIFO's other end; for regular files it has no effect. A pipe is polled: a read that waits would not see that
// the run was cancelled, and without a writer it would end at once.
#include "base/read_file.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/roots.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;  // [bytes] between looks at the cancel flag
constexpr int kPatience = 100;                        // [ms] between looks at it while a pipe gives nothing

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw Error(ErrorCode::kFileNotFound, "'" + path + "' " + reason);
}

[[noreturn]] void failToRead(const std::string& path, int error) {
  fail(path, std::string("cannot be read: ") + std::strerror(error) + (error == EACCES ? "; check its permissions" : ""));
}

[[noreturn]] void refuseSize(const std::string& path, const std::string& size, std::uintmax_t most_bytes, const std::string& kind) {
  throw Error(ErrorCode::kTooLarge, "'" + path + "' has " + size + " bytes, above the limit of " + std::to_string(most_bytes) + " for a " +
                                        kind + "; give a smaller one");
}

/// Waits for something to read, or for the writer's end. Throws kCancelled.
void awaitPipe(int descriptor, const RunControl& control) {
  pollfd pipe{descriptor, POLLIN, 0};
  while (pipe.revents == 0) {
    control.check();
    poll(&pipe, 1, kPatience);  // a signal, too, leads back to the check
  }
  control.check();
}

}  // namespace

OpenFile::OpenFile(const std::string& path, Links links)
    : path_(path),
      descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK | (links == Links::kRefuse ? O_NOFOLLOW : 0))) {
  if (descriptor_.number() < 0 || fstat(descriptor_.number(), &status_) != 0) error_ = errno;
}

void OpenFile::expectAllowed() const {
  if (error_ == 0) checkRead(path_, descriptor_.number());
}

void OpenFile::expectRegular(const std::string& kind) const {
  if (error_ == ENOENT) fail(path_, "does not exist; give the path of a " + kind);
  if (error_ != 0) failToRead(path_, error_);
  if (S_ISDIR(status_.st_mode)) fail(path_, "is a folder; give the " + kind + " in it");
  if (!S_ISREG(status_.st_mode)) fail(path_, "is not a regular file; copy its content into one");
}

std::string OpenFile::content(const std::string& kind, std::uintmax_t most_bytes, const RunControl& control) const {
  expectRegular(kind);
  const auto size = static_cast<std::uintmax_t>(status_.st_size);
  if (size > most_bytes) refuseSize(path_, std::to_string(size), most_bytes, kind);
  std::string bytes;
  bytes.reserve(size);
  for (std::size_t done = 0; done < size;) {
    control.check();
    bytes.resize(std::min<std::size_t>(size, done + kPiece));  // bit by bit: the kernel takes its time over much memory
    const ssize_t got = read(descriptor_.number(), bytes.data() + done, bytes.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) failToRead(path_, errno);
    if (got == 0) fail(path_, "became shorter while it was read; run again when it is complete");
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

std::string OpenFile::contentOfPipe(const std::string& kind, std::uintmax_t most_bytes, const RunControl& control) const {
  if (error_ != 0 || !S_ISFIFO(status_.st_mode)) return content(kind, most_bytes, control);
  std::string bytes;
  char piece[65536];
  for (;;) {
    awaitPipe(descriptor_.number(), control);
    const ssize_t got = read(descriptor_.number(), piece, sizeof piece);
    if (got == 0) return bytes;
    if (got < 0 && errno != EINTR && errno != EAGAIN) failToRead(path_, errno);
    if (got > 0) bytes.append(piece, static_cast<std::size_t>(got));
    if (bytes.size() > most_bytes) refuseSize(path_, "more than " + std::to_string(most_bytes), most_bytes, kind);
  }
}

std::string readFile(const std::string& path, const std::string& kind, std::uintmax_t most_bytes, const RunControl& control) {
  const OpenFile file(path);
  file.expectAllowed();
  return file.content(kind, most_bytes, control);
}

std::string readFileOrPipe(const std::string& path, const std::string& kind, std::uintmax_t most_bytes, const RunControl& control) {
  const OpenFile file(path);
  file.expectAllowed();
  return file.contentOfPipe(kind, most_bytes, control);
}

}  // namespace collision_hulls
