// Files of hull trees: the bytes as they are, and as the payload of a file whose checksum is right.
#include "collision_hulls/decompose/hull_tree_file.h"
#include "fuzz/target.h"
#include "geometry/bytes.h"

namespace collision_hulls::fuzz {
namespace {

void takeHullTree(const std::string& input) {
  std::string bytes = input;
  const bool is_payload = firstOf(bytes) % 2 == 1;
  static const std::string start = encodeHullTree({}).substr(0, sizeof(FileKind::magic) + sizeof(FileKind::version));
  FileKind kind{};
  fromBytes(start, kind.magic, kind.version);
  const HullTree tree = decodeHullTree(is_payload ? sealed(kind, bytes) : bytes, "input.tree");
  const std::string written = encodeHullTree(tree);
  expect(encodeHullTree(decodeHullTree(written, "again.tree")) == written, "what is written is read back");
}

const Registered kHullTree("hull_tree", takeHullTree);

}  // namespace
}  // namespace collision_hulls::fuzz
