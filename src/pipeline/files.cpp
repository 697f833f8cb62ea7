#include "pipeline/files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "collision_hulls/error.h"

namespace collision_hulls {

namespace fs = std::filesystem;

std::string readText(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void writeText(const fs::path& file, const std::string& text) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) throwUnwritable(file.parent_path(), error.message());
  errno = 0;
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) throwUnwritable(file, errno ? std::strerror(errno) : "writing failed");
  if (readText(file) != text) throwUnwritable(file, "what is read back is not what was written");
}

void throwUnwritable(const fs::path& path, const std::string& why) {
  throw Error(ErrorCode::kUnwritableOutput,
              "cannot write '" + path.string() + "': " + why + "; choose another output folder, or check its permissions and free space");
}

}  // namespace collision_hulls
