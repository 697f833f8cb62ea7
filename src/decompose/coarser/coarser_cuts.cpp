// A leaf is a hull as it was written, with what is proved of all. A node above has its hull in the tree, which covers the mesh up to the
// margin, and its bound there, with the margin on top.
#include "decompose/coarser/coarser_cuts.h"

#include <algorithm>
#include <map>
#include <vector>

#include "decompose/hulls_of_tree.h"

namespace collision_hulls {
namespace {

constexpr double kRounding = 1e-6;  // [m]

/// Whether `hull` is what rounding a node's hull outward made of it: it moved by less than `far` [m].
bool isFrom(const ConvexHull& node, const ConvexHull& hull, double far) {
  const Eigen::AlignedBox3d before = boundingBox(node), after = boundingBox(hull);
  return (before.min() - after.min()).cwiseAbs().maxCoeff() < far && (before.max() - after.max()).cwiseAbs().maxCoeff() < far;
}

}  // namespace

std::shared_ptr<const HullTree> coarserCuts(const HullTree& tree, const CutHulls& made) {
  TreeCutter cutter(tree, made.max_vertices);
  const std::vector<int> cut = cutter.cut(firstAim(made.tolerance, made.margin), made.max_hulls).nodes;
  if (cut.size() != made.hulls.size()) return nullptr;
  auto above = std::make_shared<HullTree>();
  above->tolerance = made.bound;
  std::map<int, int> places;  // in `above`, by node
  for (std::size_t i = 0; i < cut.size(); ++i) {
    if (!isFrom(cutter.hull(cut[i]), made.hulls[i], 4 * (made.margin + made.nudge) + kRounding)) return nullptr;
    places[cut[i]] = static_cast<int>(i);
    above->nodes.push_back({made.hulls[i], made.bound, -1, -1, -1});
  }
  const std::vector<double> bounds = cutter.mergedBounds();
  auto bound = bounds.begin();
  for (std::size_t id = 0; id < tree.nodes.size(); ++id) {  // children before their parents
    const HullNode& node = tree.nodes[id];
    if (node.left < 0) continue;
    const double own = *bound++ + made.margin;
    const auto left = places.find(node.left), right = places.find(node.right);
    if (left == places.end() || right == places.end()) continue;
    HullNode &a = above->nodes[static_cast<std::size_t>(left->second)], &b = above->nodes[static_cast<std::size_t>(right->second)];
    const int place = static_cast<int>(above->nodes.size());
    a.parent = b.parent = places[static_cast<int>(id)] = place;
    const double most = std::max({own, a.protrusion, b.protrusion});
    above->nodes.push_back({cutter.hull(static_cast<int>(id)), most, -1, left->second, right->second});
  }
  return above;
}

}  // namespace collision_hulls
