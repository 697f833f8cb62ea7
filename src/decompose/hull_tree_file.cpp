// A tree's fields in the frame of geometry/bytes.h. Loading checks everything that the library later relies on, so that a damaged file
// cannot crash it.
#include "collision_hulls/decompose/hull_tree_file.h"

#include <unistd.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/read_file.h"
#include "collision_hulls/error.h"
#include "geometry/bytes.h"

namespace collision_hulls {

template <typename Archive>
void fields(Archive& archive, HullNode& node) {
  archive(node.parent, node.left, node.right, node.protrusion, node.hull);
}

template <typename Archive>
void fields(Archive& archive, HullTree& tree) {
  archive(tree.tolerance, tree.nodes);
}

namespace {

namespace fs = std::filesystem;

constexpr FileKind kKind{{'C', 'H', 'U', 'L', 'T', 'R', 'E', 'E'}, 1};
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;

/// A length, or a bound on one.
bool isLength(double value) {
  return std::isfinite(value) && value >= 0;
}

/// The fault functions say what is wrong, worded to end a sentence; an empty text means nothing is.
std::string fault(const ConvexHull& hull) {
  for (const Eigen::Vector3d& v : hull.vertices) {
    if (!v.allFinite()) return "a vertex is not finite";
  }
  for (const HalfSpace& face : hull.faces) {
    if (!face.normal.allFinite() || !std::isfinite(face.offset)) return "a face is not finite";
  }
  for (const Triangle& triangle : hull.triangles) {
    for (const int v : triangle) {
      if (v >= 0 && static_cast<std::size_t>(v) < hull.vertices.size()) continue;
      return "a triangle names vertex " + std::to_string(v) + " of " + std::to_string(hull.vertices.size());
    }
  }
  if (!isLength(hull.thickness) || !isLength(hull.slack)) return "thickness or slack is not a length";
  return hull.vertices.empty() ? "its hull has no vertices" : "";
}

std::string childFault(const HullTree& tree, int id, int child) {
  if (child < 0 || child >= id) return "child " + std::to_string(child) + " does not precede it";
  const HullNode& node = tree.nodes[static_cast<std::size_t>(id)];
  const HullNode& below = tree.nodes[static_cast<std::size_t>(child)];
  if (below.parent != id) return "child " + std::to_string(child) + " has another parent, " + std::to_string(below.parent);
  if (below.protrusion > node.protrusion) return "its protrusion is smaller than that of child " + std::to_string(child);
  return "";
}

std::string nodeFault(const HullTree& tree, int id) {
  const int count = static_cast<int>(tree.nodes.size());
  const HullNode& node = tree.nodes[static_cast<std::size_t>(id)];
  if (!isLength(node.protrusion)) return "its protrusion is not a length";
  const bool is_root = id == count - 1;
  // The parent's side of the relation is checked at the parent: its two children are different nodes, and they name it as their parent.
  if (is_root ? node.parent != -1 : node.parent <= id || node.parent >= count)
    return "its parent cannot be node " + std::to_string(node.parent);
  if (const std::string wrong = fault(node.hull); !wrong.empty()) return wrong;
  if (node.left == -1 && node.right == -1) return "";
  if (node.left == node.right) return "its two children are the same node";
  const std::string wrong = childFault(tree, id, node.left);
  return wrong.empty() ? childFault(tree, id, node.right) : wrong;
}

std::string fault(const HullTree& tree) {
  if (!isLength(tree.tolerance)) return "its tolerance is not a length";
  std::size_t named = 0;  // as children
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (const std::string wrong = nodeFault(tree, static_cast<int>(i)); !wrong.empty()) return "node " + std::to_string(i) + ": " + wrong;
    if (tree.nodes[i].left >= 0) named += 2;
  }
  return tree.nodes.empty() || named + 1 == tree.nodes.size() ? "" : "a node is not a child of the parent it names";
}

[[noreturn]] void throwUnwritable(const std::string& file) {
  throw Error(ErrorCode::kUnwritableOutput,
              "cannot write the hull tree '" + file + "'; choose another path, or check permissions and free space");
}

}  // namespace

std::string encodeHullTree(const HullTree& tree) {
  if (const std::string wrong = fault(tree); !wrong.empty()) throw Error(ErrorCode::kInternal, "a hull tree is invalid: " + wrong);
  return sealed(kKind, toBytes(tree));
}

HullTree decodeHullTree(const std::string& bytes, const std::string& name) try {
  HullTree tree;
  fromBytes(opened(kKind, bytes), tree);
  if (const std::string wrong = fault(tree); !wrong.empty()) throw ByteFault(wrong);
  return tree;
} catch (const ByteFault& wrong) {
  throw Error(ErrorCode::kNotAHullTree, "'" + name + "' is not a usable hull tree: " + wrong.what() + "; create it again");
}

void saveHullTree(const HullTree& tree, const std::string& file) {
  const std::string bytes = encodeHullTree(tree);
  static std::atomic<unsigned> made{0};  // files of this process: threads may save to the same one
  const std::string temporary = file + ".part-" + std::to_string(getpid()) + "-" + std::to_string(made++);
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  std::error_code error;
  if (out) fs::rename(temporary, file, error);
  if (out && !error) return;
  fs::remove(temporary, error);
  throwUnwritable(file);
}

HullTree loadHullTree(const std::string& file) {
  return decodeHullTree(readFile(file, "hull tree", kMostBytes), file);
}

}  // namespace collision_hulls
