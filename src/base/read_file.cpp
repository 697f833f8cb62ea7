// Reads through a file descriptor, so that what was looked at is what is read, even if the path leads elsewhere meanwhile. O_NONBLOCK keeps
// open() from waiting for a FIFO's other end; for regular files it has no effect.
#include "base/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;  // [bytes] between looks at the cancel flag

/// An open file, closed at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(const std::string& path) : number_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw Error(ErrorCode::kFileNotFound, "'" + path + "' " + reason);
}

std::uintmax_t regularSize(int file, const std::string& path, const std::string& kind, std::uintmax_t most_bytes) {
  struct stat status {};
  if (fstat(file, &status) != 0) fail(path, std::string("cannot be read: ") + std::strerror(errno));
  if (S_ISDIR(status.st_mode)) fail(path, "is a folder; give the " + kind + " in it");
  if (!S_ISREG(status.st_mode)) fail(path, "is not a regular file; copy its content into one");
  const auto size = static_cast<std::uintmax_t>(status.st_size);
  if (size > most_bytes)
    throw Error(ErrorCode::kTooLarge, "'" + path + "' has " + std::to_string(size) + " bytes, above the limit of " +
                                          std::to_string(most_bytes) + " for a " + kind + "; simplify it or raise the limit");
  return size;
}

}  // namespace

std::string readFile(const std::string& path, const std::string& kind, std::uintmax_t most_bytes, const RunControl& control) {
  const Descriptor file(path);
  if (file.number() < 0 && errno == ENOENT) fail(path, "does not exist; give the path of a " + kind);
  if (file.number() < 0) fail(path, std::string("cannot be read: ") + std::strerror(errno) + "; check its permissions");
  std::string bytes(regularSize(file.number(), path, kind, most_bytes), '\0');
  for (std::size_t done = 0; done < bytes.size();) {
    control.check();
    const ssize_t got = read(file.number(), bytes.data() + done, std::min(kPiece, bytes.size() - done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path, std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0) fail(path, "became shorter while it was read; run again when it is complete");
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

}  // namespace collision_hulls
