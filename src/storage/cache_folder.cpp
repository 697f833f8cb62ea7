// Entries are written to a temporary file and renamed, so readers never see half of one, and no locks are needed between processes. An
// entry's time of last use is its modification time; trim() removes the least recently used.
#include "storage/cache_folder.h"

#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigits = 64;          // of an entry's name: a SHA-256
constexpr std::uintmax_t kLeastEntries = 4;  // that must fit; a larger entry would evict all others
constexpr const char* kUnfinished = ".unfinished-";
constexpr std::chrono::hours kGivenUp{1};  // age from which an unfinished file counts as left by a killed process

struct Entry {
  fs::file_time_type time;
  std::uintmax_t bytes = 0;
  fs::path file;
};

bool isHexDigit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
}

/// A file's time and size; nullopt if another process has removed it meanwhile.
std::optional<Entry> entryOf(const fs::path& file) {
  std::error_code error;
  Entry entry;
  entry.file = file;
  entry.time = fs::last_write_time(file, error);
  if (!error) entry.bytes = fs::file_size(file, error);
  return error ? std::nullopt : std::optional<Entry>(entry);
}

bool isGivenUp(const Entry& entry) {
  const bool unfinished = entry.file.filename().string().rfind(kUnfinished, 0) == 0;
  return unfinished && fs::file_time_type::clock::now() - entry.time > kGivenUp;
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

std::optional<std::string> CacheFolder::find(const std::string& name) {
  if (folder_.empty()) return std::nullopt;
  const fs::path file = folder_ / name;
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;  // removed meanwhile
  std::string content{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
  return content;
}

void CacheFolder::store(const std::string& name, const std::string& content) {
  if (folder_.empty()) return;
  const std::string trouble = write(name, content);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (trouble.empty()) stored_ = true;
  if (trouble_.empty()) trouble_ = trouble;
}

/// Writes an entry; returns what went wrong, or an empty string.
std::string CacheFolder::write(const std::string& name, const std::string& content) const {
  const std::uintmax_t limit = most_bytes_ / kLeastEntries;
  if (content.size() > limit) return "an entry of " + megabytes(content.size()) + " exceeds the limit of " + megabytes(limit);
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) return error.message();
  std::string temporary = (folder_ / kUnfinished).string() + "XXXXXX";
  const int descriptor = mkstemp(temporary.data());
  if (descriptor < 0) return std::strerror(errno);
  close(descriptor);
  std::ofstream out(temporary, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  const int reason = errno;
  if (out) fs::rename(temporary, folder_ / name, error);
  if (out && !error) return "";
  std::error_code ignored;
  fs::remove(temporary, ignored);
  return error ? error.message() : std::strerror(reason);
}

void CacheFolder::discard(const std::string& name) {
  std::error_code ignored;
  fs::remove(folder_ / name, ignored);
  const std::lock_guard<std::mutex> lock(mutex_);
  ++damaged_;
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
  if (damaged_ > 0) notes.push_back(place + " had " + std::to_string(damaged_) + " damaged entries, which were computed again");
  if (!trouble_.empty()) {
    notes.push_back(place + " could not store everything from this run: " + trouble_ +
                    "; set COLLISION_HULLS_CACHE to a writable folder, or turn the cache off");
  }
  return notes;
}

}  // namespace collision_hulls
