// The open file is looked at, not its path, so nobody can put another one in its place in between.
#include "storage/trusted_file.h"

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

}  // namespace collision_hulls
