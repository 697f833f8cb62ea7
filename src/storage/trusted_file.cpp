// The open file is looked at, not its path, so nobody can put another one in its place in between.
#include "storage/trusted_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/read_file.h"
#include "collision_hulls/error.h"

namespace collision_hulls {

std::string distrust(const struct stat& status) {
  constexpr uid_t kRoot = 0;
  if (status.st_uid != geteuid() && status.st_uid != kRoot) return "it belongs to another user";
  if ((status.st_mode & (S_IWGRP | S_IWOTH)) != 0) return "it can be written by others";
  return "";
}

TrustedFile readTrustedFile(const std::string& path, std::uintmax_t most_bytes) {
  const OpenFile file(path, OpenFile::Links::kRefuse);
  TrustedFile result;
  result.missing = file.error() == ENOENT;
  result.status = file.status();
  if (file.error() != 0) {
    result.unopened = file.error() != ELOOP;
    result.fault = file.error() == ELOOP ? "it is a symbolic link" : std::strerror(file.error());
    return result;
  }
  result.fault = distrust(file.status());
  try {
    if (result.fault.empty()) result.content = file.content("file", most_bytes);
  } catch (const Error& error) {
    result.fault = error.what();
  }
  return result;
}

bool linkTrustedFile(const std::string& path, const std::string& content, mode_t mode, const std::string& link) {
  constexpr mode_t kPermissions = 07777;
  const OpenFile known(path, OpenFile::Links::kRefuse);
  if (known.error() != 0 || !distrust(known.status()).empty() || (known.status().st_mode & kPermissions) != mode) return false;
  try {
    if (known.content("file", content.size()) != content) return false;
  } catch (const Error&) {
    return false;
  }
  const std::string open = "/proc/self/fd/" + std::to_string(known.number());
  return linkat(AT_FDCWD, open.c_str(), AT_FDCWD, link.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

}  // namespace collision_hulls
