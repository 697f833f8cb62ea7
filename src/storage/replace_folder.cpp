// Replaces a folder atomically: renameat2 exchanges the old and the new one, two renames do where the file system cannot.
#include "storage/replace_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "collision_hulls/error.h"
#include "storage/files.h"
#include "storage/sha256.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigits = 16;  // of the hash that stands for the target: its name with an addition might be too long

/// The beginning of the names of a target's hidden folders.
std::string prefixOf(const fs::path& target) {
  return ".collision_hulls-" + sha256(target.filename().string()).substr(0, kDigits) + "-";
}

fs::path asideOf(const fs::path& target) {
  return target.parent_path() / (prefixOf(target) + "old");
}

enum class Locked { kWait, kRefuse };  ///< what to do if another process holds the lock

/// Opens and locks a folder; -1 on failure.
int lockFolder(const fs::path& folder, Locked by_another) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0 && flock(descriptor, LOCK_EX | (by_another == Locked::kRefuse ? LOCK_NB : 0)) != 0) {
    close(descriptor);
    return -1;
  }
  return descriptor;
}

/// Removes the folders that killed processes left.
void removeLeftovers(const fs::path& target) {
  std::error_code ignored;
  const std::string prefix = prefixOf(target);
  for (fs::directory_iterator i(target.parent_path(), ignored), end; !ignored && i != end; i.increment(ignored)) {
    const std::string name = i->path().filename().string();
    if (name.compare(0, prefix.size(), prefix) != 0 || i->path() == asideOf(target)) continue;
    const int lock = lockFolder(i->path(), Locked::kRefuse);
    if (lock < 0) continue;
    std::error_code failed;  // then it stays for the next one
    fs::remove_all(i->path(), failed);
    close(lock);
  }
}

void move(const fs::path& from, const fs::path& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) throwUnwritable(to, std::strerror(errno));
}

}  // namespace

fs::path replacedFolder(const std::string& target) {
  std::error_code error;
  fs::path folder = fs::weakly_canonical(fs::absolute(target), error);
  if (error) throwUnwritable(target, error.message());
  if (!folder.has_filename()) folder = folder.parent_path();  // "out/" of a folder that is not there yet
  if (!folder.has_filename()) throwUnwritable(target, "it is the root of the file system");
  if (fs::is_symlink(folder, error)) throwUnwritable(target, "it is a symbolic link to nothing");
  return folder;
}

void replaceByTwoRenames(const fs::path& folder, const fs::path& target) {
  const fs::path aside = asideOf(target);
  std::error_code ignored;
  fs::remove_all(aside, ignored);
  move(target, aside);
  move(folder, target);
  fs::remove_all(aside, ignored);
}

void restoreAside(const fs::path& target) {
  std::error_code ignored;
  if (!fs::exists(target, ignored) && fs::exists(asideOf(target), ignored)) move(asideOf(target), target);
}

FolderReplacement::FolderReplacement(const std::string& target) : target_(replacedFolder(target)) {
  std::error_code error;
  fs::create_directories(target_.parent_path(), error);
  if (error) throwUnwritable(target_.parent_path(), error.message());
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
  lock_ = lockFolder(folder, Locked::kWait);
  struct stat entry {};
  struct stat locked {};
  const bool ours = stat(folder.c_str(), &entry) == 0 && (lock_ < 0 || (fstat(lock_, &locked) == 0 && entry.st_ino == locked.st_ino));
  if (!ours && lock_ >= 0) close(lock_);
  return ours;
}

FolderReplacement::~FolderReplacement() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
  if (lock_ >= 0) close(lock_);
}

void FolderReplacement::commit() {
  // One call for thousands of small files; fsync of each would take as many turns of the disk.
  if (const int error = syncPath(folder_, syncfs)) throwUnwritable(folder_, std::strerror(error));
  // A rename is enough if the target is missing or empty. After an exchange the old folder has our name.
  const bool renamed = std::rename(folder_.c_str(), target_.c_str()) == 0;
  if (!renamed && errno != ENOTEMPTY && errno != EEXIST) throwUnwritable(target_, std::strerror(errno));
  const bool exchanged = !renamed && renameat2(AT_FDCWD, folder_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0;
  if (!renamed && !exchanged) replaceByTwoRenames(folder_, target_);
  if (!exchanged) folder_.clear();
  syncPath(target_.parent_path(), fsync);  // even if it fails, the new output is in place
}

}  // namespace collision_hulls
