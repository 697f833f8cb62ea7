// Who knows the key can make entries, so it is worth as much as the permissions of its file. It is written under another name and then
// linked: link() fails where another process was first, and that one's key counts.
#include "storage/cache_key.h"

#include <stdlib.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "storage/files.h"
#include "storage/trusted_file.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kKeySize = 32;  // [bytes] as long as a digest of SHA-256: RFC 2104, section 3
constexpr const char* kKeyFile = "key";

std::string faultOfFolder(const fs::path& folder, const struct stat& status) {
  const std::string fault = distrust(status);
  if (fault.empty()) return "";
  const std::string own = "set COLLISION_HULLS_CACHE to a folder of your own";
  return fault + "; " + (status.st_uid == geteuid() ? "run chmod go-w '" + folder.string() + "', or " : "") + own;
}

std::string faultOfKey(const TrustedFile& key) {
  if (!key.fault.empty()) return key.fault;
  if ((key.status.st_mode & (S_IRWXG | S_IRWXO)) != 0) return "it can be read by others";
  if (key.content.size() != kKeySize)
    return "it has " + std::to_string(key.content.size()) + " bytes instead of " + std::to_string(kKeySize);
  return "";
}

}  // namespace

CacheKey readCacheKey(const fs::path& folder) {
  struct stat status {};
  if (stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) return {};
  CacheKey result;
  result.fault = faultOfFolder(folder, status);
  if (!result.fault.empty()) return result;
  const fs::path file = folder / kKeyFile;
  const TrustedFile key = readTrustedFile(file.string(), kKeySize);
  if (key.missing) return {};
  if (const std::string fault = faultOfKey(key); fault.empty()) {
    result.bytes = key.content;
  } else {
    result.fault = "its key '" + file.string() + "' cannot be trusted: " + fault + "; delete the folder, which will be filled again";
  }
  return result;
}

std::string makeCacheKey(const fs::path& folder) {
  std::error_code error;
  const fs::path above = folder.parent_path();
  makeFolders(folder.has_filename() ? above : above.parent_path(), error);  // "cache/" is cache in the current folder
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return std::strerror(errno);
  if (fs::exists(fs::symlink_status(folder / kKeyFile, error))) return "";
  std::string bytes(kKeySize, '\0');
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return std::strerror(errno);
  fs::path file;
  std::string trouble = writeUnfinished(folder, bytes, file);
  if (!trouble.empty()) return trouble;
  int reason = syncPath(file, fsync);  // a power failure must not leave an empty key, which would make the cache useless
  if (reason == 0 && link(file.c_str(), (folder / kKeyFile).c_str()) != 0 && errno != EEXIST) reason = errno;
  fs::remove(file, error);
  return reason == 0 ? "" : std::strerror(reason);
}

std::string writeUnfinished(const fs::path& folder, const std::string& content, fs::path& file) {
  std::string name = (folder / kUnfinished).string() + "XXXXXX";
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) return std::strerror(errno);
  close(descriptor);
  file = name;
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (out) return "";
  const int reason = errno;
  std::error_code ignored;
  fs::remove(file, ignored);
  return reason ? std::strerror(reason) : "writing failed";
}

}  // namespace collision_hulls
