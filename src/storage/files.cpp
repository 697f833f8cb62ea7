// Files written so that a reader never sees half of one, and read back, because a full disk does not always report an error.
#include "storage/files.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <utility>

#include "base/read_file.h"
#include "base/roots.h"
#include "collision_hulls/error.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, const std::string& text) {
  errno = 0;
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) throwUnwritable(file, errno ? std::strerror(errno) : "writing failed");
}

void writeTo(const Descriptor& out, const std::string& text, const fs::path& file) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(out.number(), text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) throwUnwritable(file, std::strerror(errno));
    done += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
  }
}

/// Into a pipe or a device, as fast as its reader takes it, unless the run is cancelled meanwhile.
void writeToReader(const Descriptor& out, const std::string& text, const fs::path& file, const RunControl& control) {
  constexpr int kLook = 50;  // [ms]
  for (std::size_t done = 0; done < text.size();) {
    pollfd place{out.number(), POLLOUT, 0};
    if (poll(&place, 1, kLook) == 0) {
      if (control.cancelled())
        throw Error(ErrorCode::kUnwritableOutput, "interrupted before the reader of '" + file.string() + "' took all that is to be " +
                                                      "written there; start one that reads, or give a file");
      continue;
    }
    const ssize_t written = ::write(out.number(), text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR && errno != EAGAIN) throwUnwritable(file, std::strerror(errno));
    done += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
  }
}

/// Into a pipe or a device, never into what has taken its place. Opened without O_NONBLOCK, a pipe that nobody reads would keep us for
/// ever.
void writeInto(const fs::path& file, const std::string& text, const RunControl& control) {
  const Descriptor out(open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
  struct stat status {};
  if (out.number() < 0 || fstat(out.number(), &status) != 0) {
    const std::string why = std::strerror(errno);
    std::error_code unknown;
    throwUnwritable(file, fs::is_fifo(file, unknown) ? "nobody reads this pipe (start its reader first)" : why);
  }
  if (S_ISREG(status.st_mode)) throwUnwritable(file, "it was a pipe or a device, and is a plain file now");
  writeToReader(out, text, file, control);
}

/// A file of this process alone, beside the one that it is to replace.
class NewFile {
 public:
  explicit NewFile(const fs::path& folder) {
    constexpr int kMostTries = 1000;
    for (int i = 0; open_.number() < 0 && i < kMostTries && (i == 0 || errno == EEXIST); ++i) {
      path_ = folder / (".collision_hulls-file-" + std::to_string(getpid()) + "-" + std::to_string(i));
      open_ = Descriptor(open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
    }
    if (open_.number() < 0) throwUnwritable(path_, std::strerror(errno));
  }
  ~NewFile() {
    if (!path_.empty()) unlink(path_.c_str());
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Reads it back, because a full disk does not always report an error.
  void fill(const std::string& text, const fs::path& file) const {
    writeTo(open_, text, file);
    if (fsync(open_.number()) != 0 && errno != EINVAL && errno != ENOSYS) throwUnwritable(file, std::strerror(errno));
    if (contentOf(placeOf(open_), text.size()) != text) throwUnwritable(file, "it reads back differently from what was written");
  }

  /// With the permissions of what was there.
  void moveTo(const fs::path& target, const fs::path& file) {
    struct stat before {};
    if (stat(target.c_str(), &before) == 0) fchmod(open_.number(), before.st_mode & 0777);
    if (std::rename(path_.c_str(), target.c_str()) != 0) throwUnwritable(file, std::strerror(errno));
    path_.clear();
  }

 private:
  fs::path path_;
  Descriptor open_;
};

/// A path that leads through an open folder (/proc/self/fd/7/meshes), as people know it.
fs::path named(const fs::path& path) {
  constexpr int kParts = 5;  // "/", "proc", "self", "fd", "7"
  if (path.string().rfind("/proc/self/fd/", 0) != 0) return path;
  auto part = path.begin();
  fs::path open;
  for (int i = 0; i < kParts && part != path.end(); ++i) open /= *part++;
  std::error_code error;
  fs::path result = fs::read_symlink(open, error);
  for (; part != path.end(); ++part)
    if (*part != ".") result /= *part;
  return error ? path : result;
}

}  // namespace

std::optional<std::string> contentOf(const fs::path& file, std::uintmax_t most_bytes) {
  try {
    return OpenFile(file.string()).content("file", most_bytes);
  } catch (const Error&) {
    return std::nullopt;
  }
}

void writeText(const fs::path& file, const std::string& text) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) throwUnwritable(file.parent_path(), error.message());
  write(file, text);
  if (contentOf(file, text.size()) != text) throwUnwritable(file, "it reads back differently from what was written");
}

fs::path behindLinks(fs::path file) {
  constexpr int kMostLinks = 40;
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(file, error); ++i) file = file.parent_path() / fs::read_symlink(file, error);
  return file;
}

void checkFolderOf(const fs::path& path) {
  fs::path above = path.parent_path();
  std::error_code error;
  for (; !fs::exists(above, error) && above.has_relative_path(); above = above.parent_path())
    if (fs::is_symlink(above, error)) throwUnwritable(path, "'" + above.string() + "' is a symbolic link that leads nowhere");
  if (!fs::is_directory(above, error)) throwUnwritable(path, "'" + above.string() + "' is not a folder");
  // Only a trial tells: permissions say nothing to root, nor about read-only and special file systems.
  const fs::path trial = above / (".collision_hulls-trial-" + std::to_string(getpid()));
  if (mkdir(trial.c_str(), 0700) != 0 && errno != EEXIST)  // ENOENT: a special file system such as /proc
    throwUnwritable(path,
                    "'" + above.string() + "' is not writable" + (errno == ENOENT ? "" : std::string(" (") + std::strerror(errno) + ")"));
  rmdir(trial.c_str());
}

void checkBeginsWith(const fs::path& file, const std::string& beginning, const std::string& what) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return;
  std::ifstream in(file, std::ios::binary);
  std::string found;
  for (char c = 0; found.size() < beginning.size() && in >> c;) found += c;  // >> skips white space
  if (found.empty() || found == beginning) return;
  throw Error(ErrorCode::kUnwritableOutput,
              "'" + file.string() + "' is there already and is no " + what + "; choose another name, or remove it");
}

void checkHoldsReport(const fs::path& file) {
  checkBeginsWith(file, "{\"collision_hulls\":", "report");
}

void checkNamedFile(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) throwUnwritable(file, "it is a folder");
  const bool replaced = !fs::exists(file, error) || fs::is_regular_file(file, error);
  const fs::path target = behindLinks(file);
  if (fs::is_symlink(target, error)) throwUnwritable(file, "its symbolic links lead in a circle");
  if (replaced) return checkFolderOf(fs::absolute(target));
  if (access(file.c_str(), W_OK) != 0) throwUnwritable(file, std::strerror(errno));
}

void makeFolders(const fs::path& folder, std::error_code& error) {
  const fs::path place = fs::weakly_canonical(folder, error);
  if (!error) fs::create_directories(place, error);
}

fs::path placeOf(const Descriptor& folder) {
  return "/proc/self/fd/" + std::to_string(folder.number());
}

Descriptor openedAround(const fs::path& path) {
  const fs::path folder = path.parent_path();
  Descriptor around(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (around.number() < 0) throwUnwritable(folder, std::strerror(errno));
  std::error_code error;
  const fs::path real = fs::read_symlink(placeOf(around), error);
  if (error) throwUnwritable(path, "/proc, which tells where an open folder lies, is missing: mount it");
  writablePath((real / path.filename()).string());
  return around;
}

void writeNamedFile(const fs::path& file, const std::string& text, const RunControl& control) {
  checkNamedFile(file);
  std::error_code error;
  if (fs::exists(file, error) && !fs::is_regular_file(file, error)) return writeInto(file, text, control);
  const fs::path target = behindLinks(fs::absolute(file));
  makeFolders(target.parent_path(), error);
  if (error) throwUnwritable(target.parent_path(), error.message());
  const Descriptor around = openedAround(target);
  NewFile made(placeOf(around));
  made.fill(text, file);
  made.moveTo(placeOf(around) / target.filename(), file);
}

int syncPath(const fs::path& path, int (*sync)(int)) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  const int error = file.number() >= 0 && sync(file.number()) == 0 ? 0 : errno;
  return error == EINVAL || error == ENOSYS ? 0 : error;
}

void throwUnwritable(const fs::path& path, const std::string& why) {
  throw Error(ErrorCode::kUnwritableOutput,
              "cannot write '" + named(path).string() + "': " + why + "; choose another output, or check its permissions and free space");
}

}  // namespace collision_hulls
