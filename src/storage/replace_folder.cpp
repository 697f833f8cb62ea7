// Replaces a folder atomically: renameat2 exchanges the old and the new one, two renames do where the file system cannot. Paths that begin
// with /proc/self/fd/N lead through an open folder, whatever becomes of its name.
#include "storage/replace_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/roots.h"
#include "collision_hulls/error.h"
#include "storage/files.h"
#include "storage/sha256.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigitsOfTarget = 16;  // of the hash that stands for the target: its name with an addition might be too long

/// The beginning of the names of a target's hidden folders.
std::string prefixOf(const fs::path& target) {
  return ".collision_hulls-" + sha256(target.filename().string()).substr(0, kDigitsOfTarget) + "-";
}

fs::path asideOf(const fs::path& target) {
  return target.parent_path() / (prefixOf(target) + "old");
}

/// Whether a path still leads to a folder that was opened by it.
bool isAt(const fs::path& path, const Descriptor& folder) {
  struct stat there {};
  struct stat opened {};
  return lstat(path.c_str(), &there) == 0 && fstat(folder.number(), &opened) == 0 && there.st_ino == opened.st_ino &&
         there.st_dev == opened.st_dev;
}

/// Lets the owner remove what is in a folder. Not by its path, which may have become a link.
void unlock(const fs::path& path) {
  const Descriptor folder(open(path.c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (folder.number() >= 0) chmod(placeOf(folder).c_str(), S_IRWXU);
}

/// Also what its owner made read-only. What cannot be removed stays.
void removeTree(const fs::path& tree) {
  std::error_code error;
  fs::remove_all(tree, error);
  if (!error) return;
  unlock(tree);
  for (fs::recursive_directory_iterator i(tree, error), end; !error && i != end; i.increment(error))
    if (i->symlink_status(error).type() == fs::file_type::directory) unlock(i->path());
  fs::remove_all(tree, error);
}

/// Removes the folders that killed processes left.
void removeLeftovers(const fs::path& target) {
  std::error_code ignored;
  const std::string prefix = prefixOf(target);
  for (fs::directory_iterator i(target.parent_path(), ignored), end; !ignored && i != end; i.increment(ignored)) {
    const std::string name = i->path().filename().string();
    if (name.compare(0, prefix.size(), prefix) != 0 || i->path() == asideOf(target)) continue;
    const Descriptor lock(open(i->path().c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (lock.number() < 0 || flock(lock.number(), LOCK_EX | LOCK_NB) != 0) continue;
    removeTree(i->path());
  }
}

void move(const fs::path& from, const fs::path& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) throwUnwritable(to, std::strerror(errno));
}

}  // namespace

fs::path replacedFolder(const std::string& target) {
  if (target.empty()) throw Error(ErrorCode::kUnwritableOutput, "the output has no name; name a folder");
  std::error_code error;
  fs::path folder = fs::weakly_canonical(fs::absolute(target), error);
  if (error) throwUnwritable(target, error.message());
  if (!folder.has_filename()) folder = folder.parent_path();  // "out/" of a folder that is not there yet
  if (!folder.has_filename())
    throw Error(ErrorCode::kUnwritableOutput, "output '" + target + "' is " + (target == "/" ? "" : "'/', ") +
                                                  "the root of the file system, and an output replaces its folder as a whole; choose " +
                                                  "another output, such as a folder within it");
  if (fs::is_symlink(folder, error)) throwUnwritable(target, "it is a symbolic link to nothing");
  return folder;
}

void replaceByTwoRenames(const fs::path& folder, const fs::path& target) {
  const fs::path aside = asideOf(target);
  removeTree(aside);
  move(target, aside);
  try {
    move(folder, target);
  } catch (const Error&) {
    move(aside, target);
    throw;
  }
  removeTree(aside);
}

void restoreAside(const fs::path& target) {
  std::error_code ignored;
  if (!fs::exists(target, ignored) && fs::exists(asideOf(target), ignored)) move(asideOf(target), target);
}

FolderReplacement::FolderReplacement(const std::string& target) : named_(replacedFolder(target)) {
  writablePath(named_.string());
  std::error_code error;
  fs::create_directories(named_.parent_path(), error);
  if (error) throwUnwritable(named_.parent_path(), error.message());
  around_ = openedAround(named_);
  target_ = placeOf(around_) / named_.filename();
  restoreAside(target_);
  removeLeftovers(target_);
  const std::string stem = (target_.parent_path() / prefixOf(target_)).string() + std::to_string(getpid()) + "-";
  int number = 0;
  while (!makeLocked(stem + std::to_string(number))) ++number;
}

/// False if the name is taken, or if another process saw the folder before it was locked and removed it.
bool FolderReplacement::makeLocked(const fs::path& folder) {
  if (mkdir(folder.c_str(), 0777) != 0) {
    if (errno == EEXIST) return false;
    throwUnwritable(folder, std::strerror(errno));
  }
  folder_ = folder;
  lock_ = Descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (lock_.number() < 0 && errno != ENOENT) {
    const std::string why = std::strerror(errno);
    rmdir(folder.c_str());
    throwUnwritable(folder, why);
  }
  flock(lock_.number(), LOCK_EX);  // some file systems have no locks
  struct stat status {};
  if (!isAt(folder_, lock_) || fstat(lock_.number(), &status) != 0) return false;
  mode_ = status.st_mode;
  fchmod(lock_.number(), S_IRWXU);
  return true;
}

/// With "/.", as create_directories() of GCC before 11.3 refuses links to folders.
fs::path FolderReplacement::folder() const {
  return placeOf(lock_) / ".";
}

mode_t FolderReplacement::fileMode() const {
  return mode_ & (S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH);
}

FolderReplacement::~FolderReplacement() {
  if (!folder_.empty() && rmdir(folder_.c_str()) != 0) removeTree(folder_);  // an empty one takes no descriptor
}

/// Both folders must be where their paths lead.
void FolderReplacement::expectInPlace() const {
  std::error_code error;
  const bool moved = fs::weakly_canonical(named_.parent_path(), error) != named_.parent_path() || !isAt(named_.parent_path(), around_);
  if (moved || !isAt(folder_, lock_)) throwUnwritable(named_, "the folder around it was moved, or became a link, while it was written");
}

void FolderReplacement::commit() {
  // One call for thousands of small files; fsync of each would take as many turns of the disk.
  if (const int error = syncPath(folder(), syncfs)) throwUnwritable(folder(), std::strerror(error));
  expectInPlace();
  fchmod(lock_.number(), mode_);
  // A rename is enough if the target is missing or empty. After an exchange the old folder has our name.
  const bool renamed = std::rename(folder_.c_str(), target_.c_str()) == 0;
  if (!renamed && errno != ENOTEMPTY && errno != EEXIST) throwUnwritable(target_, std::strerror(errno));
  const bool exchanged = !renamed && renameat2(AT_FDCWD, folder_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0;
  if (!renamed && !exchanged) replaceByTwoRenames(folder_, target_);
  if (!exchanged) folder_.clear();
  syncPath(target_.parent_path(), fsync);  // even if it fails, the new output is in place
}

}  // namespace collision_hulls
