// A node of a binary map is 16 bits, two per child: 0 unknown, 1 free, 2 occupied, 3 has children of its own. A node of a full map is its
// log-odds value, further data that depends on the kind of tree, and one bit per child. Children follow depth first; the bits 1, 2, 4 of a
// child's number mean that it lies further along x, y, z.
#include "collision_hulls/scene/octomap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

#include "base/decimal.h"
#include "base/finite_number.h"
#include "base/in_context.h"
#include "base/looks.h"
#include "collision_hulls/error.h"
#include "scene/reading.h"
#include "storage/text_file.h"

namespace collision_hulls {
namespace {

constexpr int kDepth = 16;
constexpr std::size_t kMostBoxes = 100'000;
constexpr std::size_t kMostCells = 20'000'000;

[[noreturn]] void fail(const std::string& reason) {
  throw Error(ErrorCode::kBadScene, "the map " + reason);
}

/// A box of cells, in integer multiples of the smallest cell from the map's middle.
struct CellRange {
  std::array<int, 3> low, high;
};

class OctomapReader {
 public:
  OctomapReader(const Octomap& map, const RunControl& control) : data_(map.data), look_(control) {
    static const std::map<std::string, std::size_t> kBeyondValue{{"OcTree", 0}, {"ColorOcTree", 3}};  // bytes per node
    const auto found = kBeyondValue.find(map.id);
    if (found == kBeyondValue.end()) fail("is of the unknown kind '" + map.id + "'; supported are OcTree and ColorOcTree");
    beyond_value_ = found->second;
    if (data_.empty()) return;
    if (map.binary)
      readBinary({0, 0, 0}, kDepth);
    else
      readFull({0, 0, 0}, kDepth);
    if (at_ != data_.size()) fail("has " + std::to_string(data_.size() - at_) + " bytes after its last node; it is damaged");
  }

  std::vector<CellRange> take() { return std::move(occupied_); }

 private:
  using Corner = std::array<int, 3>;

  const char* bytes(std::size_t count) {
    look_();
    if (data_.size() - at_ < count) fail("ends in the middle of a node, after " + std::to_string(data_.size()) + " bytes; it is damaged");
    at_ += count;
    return data_.data() + at_ - count;
  }

  static Corner child(const Corner& corner, int index, int level) {
    const int half = 1 << (level - 1);
    return {corner[0] + (index & 1 ? half : 0), corner[1] + (index & 2 ? half : 0), corner[2] + (index & 4 ? half : 0)};
  }

  /// Reads a node that is 2^level cells wide.
  void readBinary(const Corner& corner, int level) {
    const auto* both = reinterpret_cast<const unsigned char*>(bytes(2));
    const unsigned bits = both[0] | unsigned{both[1]} << 8;
    for (int i = 0; i < 8; ++i) {
      const unsigned kind = bits >> (2 * i) & 3;
      if (kind != 0 && level == 0) fail("has nodes below its 16th level; it is damaged");
      if (kind == 2) add(child(corner, i, level), level - 1);
      if (kind == 3) readBinary(child(corner, i, level), level - 1);
    }
  }

  void readFull(const Corner& corner, int level) {
    float log_odds = 0;
    std::memcpy(&log_odds, bytes(sizeof log_odds), sizeof log_odds);
    bytes(beyond_value_);
    const auto children = static_cast<unsigned char>(*bytes(1));
    if (std::isnan(log_odds)) fail("has a node whose value is not a number; it is damaged");
    if (children == 0 && log_odds >= 0) add(corner, level);
    if (children != 0 && level == 0) fail("has nodes below its 16th level; it is damaged");
    for (int i = 0; i < 8; ++i)
      if (children >> i & 1) readFull(child(corner, i, level), level - 1);
  }

  void add(const Corner& corner, int level) {
    constexpr int kMiddle = 1 << (kDepth - 1);
    if (occupied_.size() == kMostCells)
      throw Error(ErrorCode::kTooLarge, "the map has more than 20 million occupied cells; make a coarser one");
    CellRange cells;
    for (std::size_t k = 0; k < 3; ++k) cells.low[k] = corner[k] - kMiddle, cells.high[k] = cells.low[k] + (1 << level);
    occupied_.push_back(cells);
  }

  const std::string_view data_;
  Looks look_;
  std::size_t at_ = 0, beyond_value_ = 0;
  std::vector<CellRange> occupied_;
};

/// Merges boxes that differ only along this axis and meet there.
void joinAlong(std::size_t axis, std::vector<CellRange>& boxes, const RunControl& control) {
  Looks look(control);
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto place = [&](const CellRange& c) { return std::array<int, 5>{c.low[u], c.high[u], c.low[v], c.high[v], c.low[axis]}; };
  std::sort(boxes.begin(), boxes.end(), [&](const CellRange& a, const CellRange& b) { return look(), place(a) < place(b); });
  std::size_t last = 0;
  for (std::size_t i = 1; i < boxes.size(); ++i) {
    look();
    std::array<int, 5> next = place(boxes[last]);
    next.back() = boxes[last].high[axis];
    if (place(boxes[i]) == next)
      boxes[last].high[axis] = boxes[i].high[axis];
    else
      boxes[++last] = boxes[i];
  }
  boxes.resize(std::min(boxes.size(), last + 1));
}

std::vector<CellRange> joined(std::vector<CellRange> boxes, const RunControl& control) {
  for (std::size_t before = boxes.size() + 1; boxes.size() < before;) {
    before = boxes.size();
    for (std::size_t axis = 0; axis < 3; ++axis) joinAlong(axis, boxes, control);
  }
  return boxes;
}

/// The value of a line "key value" in a file's header.
std::string headValue(std::string_view head, const std::string& key) {
  const std::size_t at = head.find("\n" + key + " ");
  if (at == std::string_view::npos) fail("has no line '" + key + " ...' before its data");
  const std::size_t from = at + key.size() + 2;
  return std::string(head.substr(from, head.find_first_of(" \r\n", from) - from));
}

}  // namespace

std::vector<Eigen::AlignedBox3d> occupiedBoxes(const Octomap& map, const RunControl& control) {
  if (!(map.resolution > 0 && std::isfinite(map.resolution)))
    fail("has a resolution of " + decimal(map.resolution) + " m; it must be a positive length");
  const std::vector<CellRange> all = joined(OctomapReader(map, control).take(), control);
  if (all.size() > kMostBoxes) {
    throw Error(ErrorCode::kTooLarge, "the map has " + std::to_string(all.size()) + " boxes of occupied cells, above the limit of " +
                                          std::to_string(kMostBoxes) + "; make a coarser one, or crop it to what the robot can reach");
  }
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const CellRange& c : all) {
    const Eigen::Vector3d low(c.low[0], c.low[1], c.low[2]), high(c.high[0], c.high[1], c.high[2]);
    boxes.emplace_back(map.resolution * low, map.resolution * high);
  }
  return boxes;
}

void addOctomap(Scene& scene, const std::string& name, const Octomap& map, const Eigen::Isometry3d& pose, const RunControl& control) {
  const std::vector<Eigen::AlignedBox3d> boxes = occupiedBoxes(map, control);
  SceneBuilder builder(scene);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    SceneBody body{name + "/" + std::to_string(i + 1), {}, pose * Eigen::Translation3d(boxes[i].center())};
    const Eigen::Vector3d sides = boxes[i].sizes();
    setShape(body, "box", {sides.x(), sides.y(), sides.z()});
    builder.add(std::move(body));
  }
}

Scene readOctomapScene(const std::string& file, const RunControl& control) {
  const std::string text = readTextFile(file, "map", control);
  Scene scene;
  inContext("'" + file + "'", [&] {
    constexpr std::string_view kData = "\ndata\n", kBinary = "# Octomap OcTree binary file", kFull = "# Octomap OcTree file";
    const std::size_t data = text.find(kData);
    const bool binary = text.compare(0, kBinary.size(), kBinary) == 0;
    if (data == std::string::npos || (!binary && text.compare(0, kFull.size(), kFull) != 0))
      fail("is not an OctoMap file: it must start with '" + std::string(kBinary) + "' or '" + std::string(kFull) +
           "' and have a line 'data'");
    const std::string_view head(text.data(), data + 1);
    Octomap map{binary, headValue(head, "id"), 0, std::string_view(text).substr(data + kData.size())};
    if (!parseFinite(headValue(head, "res"), map.resolution))
      fail("has the resolution '" + headValue(head, "res") + "', which is not a number");
    addOctomap(scene, "octomap", map, Eigen::Isometry3d::Identity(), control);
  });
  return scene;
}

}  // namespace collision_hulls
