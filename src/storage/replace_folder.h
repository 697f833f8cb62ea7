// A folder that is replaced as a whole: whenever the process dies, the old or the new one stands there, complete.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>

#include "base/descriptor.h"

namespace collision_hulls {

/// Builds a new folder beside `target` and puts it in its place with one rename.
///
/// The new folder is hidden, named after its target and locked (flock) while its process lives; what killed processes left
/// behind is removed when the next one begins. Processes with the same target may run at once: the last one to commit stays.
///
/// It works through descriptors of the folder around the target and of the new one: what is written lands where it was checked
/// (base/roots.h), even if a part of the path becomes a link to another place meanwhile. Then commit() fails.
class FolderReplacement {
 public:
  /// Throws kUnwritableOutput, kOutsideRoots.
  explicit FolderReplacement(const std::string& target);
  ~FolderReplacement();
  FolderReplacement(const FolderReplacement&) = delete;
  FolderReplacement& operator=(const FolderReplacement&) = delete;

  /// Where to write; on the file system of the target. Only this user can, until commit().
  std::filesystem::path folder() const;

  /// The permissions of new files, as the umask has them.
  mode_t fileMode() const;

  /// Brings everything to the disk, exchanges the folders and removes the old one. Throws kUnwritableOutput.
  void commit();

 private:
  bool makeLocked(const std::filesystem::path& folder);
  void expectInPlace() const;

  const std::filesystem::path named_;      // the target, as a path
  Descriptor around_;                      // the folder that it is in
  std::filesystem::path target_, folder_;  // both by way of `around_`
  Descriptor lock_;                        // the new folder
  mode_t mode_ = 0;                        // of it, once it is in place
};

/// The folder that a path means: absolute, links followed, no slash at its end.
std::filesystem::path replacedFolder(const std::string& target);

/// For file systems that cannot exchange: sets `target` aside, then renames `folder` to it. A process that is killed in
/// between leaves the old folder aside, whole; restoreAside() brings it back.
void replaceByTwoRenames(const std::filesystem::path& folder, const std::filesystem::path& target);
void restoreAside(const std::filesystem::path& target);

}  // namespace collision_hulls
