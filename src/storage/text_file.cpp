// One limit for all texts that people write: descriptions, scenes, lists.
#include "storage/text_file.h"

#include "base/read_file.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20;

}  // namespace

std::string readTextFile(const std::string& path, const std::string& kind, const RunControl& control) {
  return readFile(path, kind, kMostBytes, control);
}

std::string readTextFileOrPipe(const std::string& path, const std::string& kind, const RunControl& control) {
  return readFileOrPipe(path, kind, kMostBytes, control);
}

}  // namespace collision_hulls
