// Files that only this user could have written.
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <string>

namespace collision_hulls {

/// Why others may have written what has this status: "it can be written by others", "it belongs to another user"; empty if none can but
/// this user and root. An access control list that lets others write shows in the group's permissions.
std::string distrust(const struct stat& status);

struct TrustedFile {
  bool missing = false;
  bool unopened = false;  ///< for a reason that may pass, such as too many open files
  std::string fault;      ///< why it was not read, as distrust() says it, or because it is a link, no regular file, too large, unreadable
  std::string content;    ///< empty unless it could be read
  struct stat status {};
};

TrustedFile readTrustedFile(const std::string& path, std::uintmax_t most_bytes);

/// Makes `link` a hard link to the file at `path`, if that holds this content, has the permissions `mode`, and nobody but this user and
/// root can change it. False: there is no link.
bool linkTrustedFile(const std::string& path, const std::string& content, mode_t mode, const std::string& link);

}  // namespace collision_hulls
