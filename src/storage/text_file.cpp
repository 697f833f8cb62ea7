// Reads whole text files, with a limit, since a path may lead to a device that never ends.
#include "storage/text_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "collision_hulls/error.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20;

void checkReadable(const std::string& path, const std::string& kind) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw Error(ErrorCode::kFileNotFound, "'" + path + "' does not exist; give the path of a " + kind);
  if (fs::is_directory(status)) throw Error(ErrorCode::kFileNotFound, "'" + path + "' is a folder; give the " + kind + " in it");
}

}  // namespace

std::string readTextFile(const std::string& path, const std::string& kind) {
  checkReadable(path, kind);
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(ErrorCode::kFileNotFound, "'" + path + "' cannot be read: " + std::strerror(errno));
  std::string text;
  char buffer[65536];
  while (in.read(buffer, sizeof buffer) || in.gcount() > 0) {
    text.append(buffer, static_cast<std::size_t>(in.gcount()));
    if (text.size() > kMostBytes) {
      throw Error(ErrorCode::kTooLarge,
                  "'" + path + "' has more than " + std::to_string(kMostBytes) + " bytes, which is too large for a " + kind);
    }
  }
  return text;
}

}  // namespace collision_hulls
