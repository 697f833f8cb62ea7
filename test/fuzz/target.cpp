// What fuzz targets share.
#include "fuzz/target.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "collision_hulls/error.h"

namespace collision_hulls::fuzz {
namespace {

/// In memory where the system has such a place; removed at the end.
class WorkFolder {
 public:
  WorkFolder() {
    const std::filesystem::path shared = "/dev/shm";
    const std::filesystem::path parent = std::filesystem::is_directory(shared) ? shared : std::filesystem::temp_directory_path();
    path_ = parent / ("fuzz-" + std::to_string(getpid()));
    std::filesystem::create_directory(path_);
  }
  ~WorkFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

void feed(const Target& target, const std::string& bytes) {
  try {
    target.take(bytes);
  } catch (const Error& error) {
    expect(error.code() != ErrorCode::kInternal && *error.what() != '\0', "bad input is refused with a reason");
  }
}

std::string fileOf(const std::string& bytes, const std::string& extension) {
  static const WorkFolder folder;
  const std::filesystem::path file = folder.path() / ("input" + extension);
  std::ofstream(file, std::ios::binary) << bytes;
  return file.string();
}

unsigned char firstOf(std::string& bytes) {
  if (bytes.empty()) return 0;
  const auto first = static_cast<unsigned char>(bytes.front());
  bytes.erase(0, 1);
  return first;
}

}  // namespace collision_hulls::fuzz
