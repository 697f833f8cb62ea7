// A folder that is replaced as a whole: whenever the process dies, the old or the new one stands there, complete.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace collision_hulls {

/// Builds a new folder beside `target` and puts it in its place with one rename.
///
/// The new folder is hidden, named after its target and locked (flock) while its process lives; what killed processes left
/// behind is removed when the next one begins. Processes with the same target may run at once: the last one to commit stays.
class FolderReplacement {
 public:
  /// Throws kUnwritableOutput.
  explicit FolderReplacement(const std::string& target);
  ~FolderReplacement();
  FolderReplacement(const FolderReplacement&) = delete;
  FolderReplacement& operator=(const FolderReplacement&) = delete;

  /// Where to write; on the file system of the target.
  const std::filesystem::path& folder() const { return folder_; }

  /// Brings everything to the disk, exchanges the folders and removes the old one.
  void commit();

 private:
  bool makeLocked(const std::filesystem::path& folder);

  std::filesystem::path target_, folder_;
  int lock_ = -1;
};

/// The folder that a path means: absolute, links followed, no slash at its end.
std::filesystem::path replacedFolder(const std::string& target);

/// For file systems that cannot exchange: sets `target` aside, then renames `folder` to it. A process that is killed in
/// between leaves the old folder aside, whole; restoreAside() brings it back.
void replaceByTwoRenames(const std::filesystem::path& folder, const std::filesystem::path& target);
void restoreAside(const std::filesystem::path& target);

}  // namespace collision_hulls
