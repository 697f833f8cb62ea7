// Walks down from the root: cutAt() by bounds, cutTo() by a queue of the furthest protruding nodes. Linear, or O(n log n), in the nodes
// visited.
#include "collision_hulls/decompose/hull_tree.h"

#include <algorithm>
#include <queue>
#include <string>
#include <utility>

#include "collision_hulls/error.h"

namespace collision_hulls {

std::vector<int> HullTree::cutAt(double tolerance) const {
  std::vector<int> cut, open;
  if (!nodes.empty()) open.push_back(static_cast<int>(nodes.size()) - 1);
  while (!open.empty()) {
    const int id = open.back();
    open.pop_back();
    const HullNode& node = nodes[static_cast<std::size_t>(id)];
    if (node.protrusion <= tolerance || node.left < 0) {
      cut.push_back(id);
    } else {
      open.push_back(node.left);
      open.push_back(node.right);
    }
  }
  std::sort(cut.begin(), cut.end());
  return cut;
}

std::vector<int> HullTree::cutTo(int hulls) const {
  std::priority_queue<std::pair<double, int>> openable;  // furthest protruding first; the later node on a tie
  std::vector<int> cut;
  const auto add = [&](int id) {
    const HullNode& node = nodes[static_cast<std::size_t>(id)];
    if (node.left < 0)
      cut.push_back(id);
    else
      openable.push({node.protrusion, id});
  };
  if (!nodes.empty()) add(static_cast<int>(nodes.size()) - 1);
  while (!openable.empty() && static_cast<int>(cut.size() + openable.size()) < hulls) {
    const HullNode& node = nodes[static_cast<std::size_t>(openable.top().second)];
    openable.pop();
    add(node.left);
    add(node.right);
  }
  for (; !openable.empty(); openable.pop()) cut.push_back(openable.top().second);
  std::sort(cut.begin(), cut.end());
  return cut;
}

bool HullTree::isCut(const std::vector<int>& cut) const {
  std::vector<char> chosen(nodes.size(), 0);
  for (int id : cut) {
    if (id < 0 || static_cast<std::size_t>(id) >= nodes.size() || chosen[static_cast<std::size_t>(id)]) return false;
    chosen[static_cast<std::size_t>(id)] = 1;
  }
  for (std::size_t leaf = 0; leaf < nodes.size(); ++leaf) {
    if (nodes[leaf].left >= 0) continue;
    int above = 0;
    for (int id = static_cast<int>(leaf); id >= 0; id = nodes[static_cast<std::size_t>(id)].parent)
      above += chosen[static_cast<std::size_t>(id)];
    if (above != 1) return false;
  }
  return true;
}

std::vector<ConvexHull> HullTree::hullsOf(const std::vector<int>& cut) const {
  std::vector<ConvexHull> hulls;
  for (int id : cut) {
    if (id < 0 || static_cast<std::size_t>(id) >= nodes.size())
      throw Error(ErrorCode::kIndexOutOfRange, "the cut has node " + std::to_string(id) + ", but the tree has " +
                                                   std::to_string(nodes.size()) + ", counted from 0; give a cut of this tree");
    hulls.push_back(nodes[static_cast<std::size_t>(id)].hull);
  }
  return hulls;
}

}  // namespace collision_hulls
