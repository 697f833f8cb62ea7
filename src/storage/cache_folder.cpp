// Entries are written to a temporary file and renamed, so readers never see half of one, and no locks are needed between processes. An
// entry's time of last use is its modification time; trim() removes the least recently used.
//
// An entry's last 64 bytes are its seal: HMAC-SHA-256 over its name and content, with the folder's key. So it is of somebody who can read
// the key, and it was stored under this name. Comparing seals takes no care against timing: only the owner can write entries to try.
#include "storage/cache_folder.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <utility>

#include "storage/cache_key.h"
#include "storage/sha256.h"
#include "storage/trusted_file.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigits = 64;           // of an entry's name: a SHA-256
constexpr std::uintmax_t kLeastEntries = 4;   // that must fit; a larger entry would evict all others
constexpr std::size_t kSeal = 64;             // bytes
constexpr const char* kTrimmed = ".trimmed";  // its date: when a process last looked at all entries
constexpr std::chrono::minutes kTrimPeriod{1};
constexpr std::chrono::hours kGivenUp{1};  // age from which an unfinished file counts as left by a killed process

struct Entry {
  std::chrono::nanoseconds time{0};  // of last use, since 1970
  std::uintmax_t bytes = 0;
  fs::path file;
};

bool isHexDigit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
}

/// A file's time and size; nullopt if another process has removed it meanwhile, and for links and other things.
std::optional<Entry> entryOf(const fs::path& file) {
  struct stat status {};
  if (lstat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  const auto since_1970 = std::chrono::seconds(status.st_mtim.tv_sec) + std::chrono::nanoseconds(status.st_mtim.tv_nsec);
  return Entry{since_1970, static_cast<std::uintmax_t>(status.st_size), file};
}

bool isGivenUp(const Entry& entry) {
  const bool unfinished = entry.file.filename().string().rfind(kUnfinished, 0) == 0;
  return unfinished && std::chrono::system_clock::now().time_since_epoch() - entry.time > kGivenUp;
}

std::string sealOf(const std::string& key, const std::string& name, std::string_view content) {
  return hmacSha256(key, {name, std::string_view("", 1), content});  // no name has a zero, so nothing else gives these bytes
}

/// Makes a file the most recently used.
void touch(const fs::path& file) {
  utimensat(AT_FDCWD, file.c_str(), nullptr, AT_SYMLINK_NOFOLLOW);
}

std::string megabytes(std::uintmax_t bytes) {
  return std::to_string(bytes / 1'000'000) + " MB";
}

}  // namespace

fs::path cacheFolder() {
  const auto variable = [](const char* name) -> fs::path {
    const char* const value = std::getenv(name);
    return value ? value : "";
  };
  if (const fs::path own = variable("COLLISION_HULLS_CACHE"); !own.empty()) return own;
  if (const fs::path ros = variable("ROS_HOME"); !ros.empty()) return ros / "collision_hulls";
  if (const fs::path home = variable("HOME"); !home.empty()) return home / ".ros" / "collision_hulls";
  return {};
}

CacheFolder::CacheFolder(fs::path folder, std::uintmax_t most_bytes) : folder_(std::move(folder)), most_bytes_(most_bytes) {}

bool CacheFolder::isEntry(const std::string& name) {
  if (name.size() < kDigits + 2 || name[kDigits] != '.') return false;
  const auto point = name.begin() + kDigits;
  return std::all_of(name.begin(), point, isHexDigit) && std::all_of(point + 1, name.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

/// The folder's key, once it has one; makes it if told to. Empty: the folder cannot be used (yet).
std::string CacheFolder::key(Missing missing) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (folder_.empty() || !key_.bytes.empty() || !key_.fault.empty()) return key_.bytes;
  key_ = readCacheKey(folder_);
  if (missing == Missing::kFind || !key_.bytes.empty() || !key_.fault.empty()) return key_.bytes;
  if (const std::string trouble = makeCacheKey(folder_); trouble.empty()) {
    key_ = readCacheKey(folder_);
  } else if (trouble_.empty()) {
    trouble_ = trouble;
  }
  return key_.bytes;
}

std::optional<std::string> CacheFolder::find(const std::string& name) {
  const std::string key = this->key(Missing::kFind);
  if (key.empty()) return std::nullopt;
  const fs::path file = folder_ / name;
  TrustedFile entry = readTrustedFile(file.string(), most_bytes_ / kLeastEntries + kSeal);
  if (entry.missing || entry.unopened) return std::nullopt;
  std::string& bytes = entry.content;
  const std::string_view content = std::string_view(bytes).substr(0, bytes.size() - std::min(bytes.size(), kSeal));
  if (!entry.fault.empty() || bytes.substr(content.size()) != sealOf(key, name, content)) {
    discard(name);
    return std::nullopt;
  }
  touch(file);
  bytes.resize(content.size());
  return std::move(bytes);
}

void CacheFolder::store(const std::string& name, const std::string& content) {
  const std::string key = this->key(Missing::kMake);
  if (key.empty()) return;
  const std::string trouble = write(name, content, key);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (trouble.empty()) stored_ = true;
  if (trouble_.empty()) trouble_ = trouble;
}

/// Writes an entry; returns what went wrong, or an empty string.
std::string CacheFolder::write(const std::string& name, const std::string& content, const std::string& key) const {
  const std::uintmax_t limit = most_bytes_ / kLeastEntries;
  if (content.size() > limit) return "an entry of " + megabytes(content.size()) + " exceeds the limit of " + megabytes(limit);
  fs::path unfinished;
  const std::string trouble = writeUnfinished(folder_, content + sealOf(key, name, content), unfinished);
  if (!trouble.empty()) return trouble;
  std::error_code error, ignored;
  fs::rename(unfinished, folder_ / name, error);
  if (!error) return "";
  fs::remove(unfinished, ignored);
  return error.message();
}

void CacheFolder::discard(const std::string& name) {
  std::error_code ignored;
  fs::remove(folder_ / name, ignored);
  const std::lock_guard<std::mutex> lock(mutex_);
  ++damaged_;
}

void CacheFolder::trimNowAndThen() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!stored_) return;
  }
  const auto now = fs::file_time_type::clock::now();
  const fs::path stamp = folder_ / kTrimmed;
  std::error_code error, ignored;
  const auto age = now - fs::last_write_time(stamp, error);
  if (!error && age < kTrimPeriod && age > -kTrimPeriod) return;
  std::ofstream(stamp, std::ios::app).close();
  fs::last_write_time(stamp, now, ignored);
  trim();
}

void CacheFolder::trim() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!stored_) return;
  std::vector<Entry> entries;
  std::uintmax_t sum = 0;
  std::error_code error, ignored;
  for (fs::directory_iterator i(folder_, error), end; !error && i != end; i.increment(error)) {
    const std::optional<Entry> entry = entryOf(i->path());
    if (!entry) continue;
    if (isGivenUp(*entry)) fs::remove(entry->file, ignored);
    if (!isEntry(entry->file.filename().string())) continue;
    entries.push_back(*entry);
    sum += entry->bytes;
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.time < b.time; });
  for (auto oldest = entries.begin(); sum > most_bytes_; ++oldest) {
    fs::remove(oldest->file, ignored);
    sum -= oldest->bytes;
  }
}

std::vector<std::string> CacheFolder::notes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<std::string> notes;
  const std::string place = "the cache '" + folder_.string() + "'";
  if (!key_.fault.empty()) notes.push_back(place + " was not used: " + key_.fault);
  if (damaged_ > 0) {
    notes.push_back(place + " had " + std::to_string(damaged_) + " damaged or foreign entries, which were computed again");
  }
  if (!trouble_.empty()) {
    notes.push_back(place + " could not store everything from this run: " + trouble_ +
                    "; set COLLISION_HULLS_CACHE to a writable folder, or turn the cache off (--no-cache)");
  }
  return notes;
}

}  // namespace collision_hulls
