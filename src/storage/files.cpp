// Files written so that a reader never sees half of one, and read back, because a full disk does not always report an error.
#include "storage/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "base/descriptor.h"
#include "base/read_file.h"
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

/// Where a name leads, through links; also where nothing is there yet.
fs::path behindLinks(fs::path file) {
  constexpr int kMostLinks = 40;
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(file, error); ++i) file = file.parent_path() / fs::read_symlink(file, error);
  return file;
}

/// A path that leads through an open folder (/proc/self/fd/7/meshes), as people know it.
fs::path named(const fs::path& path) {
  constexpr int kParts = 5;  // "/", "proc", "self", "fd", "7"
  if (path.string().rfind("/proc/self/fd/", 0) != 0) return path;
  auto part = path.begin();
  fs::path open;
  for (int i = 0; i < kParts && part != path.end(); ++i) open /= *part++;
  std::error_code error;
  fs::path result = fs::read_symlink(open, error);
  for (; part != path.end(); ++part) result /= *part;
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

void checkFolderOf(const fs::path& path) {
  fs::path above = path.parent_path();
  std::error_code error;
  while (!fs::exists(above, error) && above.has_relative_path()) above = above.parent_path();
  if (!fs::is_directory(above, error)) throwUnwritable(path, "'" + above.string() + "' is not a folder");
  // Only a trial tells: permissions say nothing to root, nor about read-only and special file systems.
  const fs::path trial = above / (".collision_hulls-trial-" + std::to_string(getpid()));
  if (mkdir(trial.c_str(), 0700) != 0 && errno != EEXIST)  // ENOENT: a special file system such as /proc
    throwUnwritable(path,
                    "'" + above.string() + "' is not writable" + (errno == ENOENT ? "" : std::string(" (") + std::strerror(errno) + ")"));
  rmdir(trial.c_str());
}

void checkNamedFile(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) throwUnwritable(file, "it is a folder");
  const bool replaced = !fs::exists(file, error) || fs::is_regular_file(file, error);
  if (replaced) return checkFolderOf(fs::absolute(behindLinks(file)));
  if (access(file.c_str(), W_OK) != 0) throwUnwritable(file, std::strerror(errno));
}

void writeNamedFile(const fs::path& file, const std::string& text) {
  checkNamedFile(file);
  std::error_code error;
  if (fs::exists(file, error) && !fs::is_regular_file(file, error)) return write(file, text);
  const fs::path target = behindLinks(file);
  fs::path temporary = target;
  temporary += ".part-" + std::to_string(getpid());
  try {
    writeText(temporary, text);
    if (const int reason = syncPath(temporary, fsync)) throwUnwritable(file, std::strerror(reason));
    fs::rename(temporary, target, error);
  } catch (const Error&) {
    fs::remove(temporary, error);
    throw;
  }
  if (!error) return;
  const std::string why = error.message();
  fs::remove(temporary, error);
  throwUnwritable(file, why);
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
