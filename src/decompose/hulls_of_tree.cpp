// A node's bound is of its hull with all its vertices. Fewer vertices let the hull protrude further, so a node within the tolerance may
// have to be opened after all: it is replaced by its children until each hull keeps the tolerance as it will be returned.
#include "decompose/hulls_of_tree.h"

#include <algorithm>
#include <utility>

#include "collision_hulls/decompose/reduce_vertices.h"

namespace collision_hulls {
namespace {

// The first aim is below the tolerance by this many margins, for the margin and rounding, but never below this share of the tolerance.
constexpr double kMargins = 3, kLeastAim = 0.5;

}  // namespace

double firstAim(double tolerance, double margin, double more) {
  return std::max(kLeastAim * tolerance, tolerance - (kMargins * margin + more));
}

double toleranceForAim(double aim, double margin) {
  return std::min(aim / kLeastAim, aim + kMargins * margin);
}

const TreeCutter::Reduced& TreeCutter::reduced(int id) {
  std::optional<Reduced>& known = known_[static_cast<std::size_t>(id)];
  if (known) return *known;
  const HullNode& node = tree_.nodes[static_cast<std::size_t>(id)];
  if (!exceedsCap(node.hull, max_vertices_)) return known.emplace(Reduced{node.hull, node.protrusion});
  Reduced result{reduceVertices(node.hull, max_vertices_)};
  result.bound = node.protrusion + addedDistance(result.hull, node.hull);
  return known.emplace(std::move(result));
}

std::vector<double> TreeCutter::mergedBounds() {
  std::vector<double> bounds;
  for (std::size_t id = 0; id < known_.size(); ++id)
    if (tree_.nodes[id].left >= 0) bounds.push_back(reduced(static_cast<int>(id)).bound);
  return bounds;
}

std::vector<int> TreeCutter::cutWithin(double tolerance) {
  std::vector<int> open = tree_.cutAt(tolerance), cut;
  while (!open.empty()) {
    const int id = open.back();
    const HullNode& node = tree_.nodes[static_cast<std::size_t>(id)];
    open.pop_back();
    if (node.left < 0 || reduced(id).bound <= tolerance)
      cut.push_back(id);
    else
      open.insert(open.end(), {node.left, node.right});
  }
  return cut;
}

TreeCutter::Cut TreeCutter::cut(double tolerance, int max_hulls) {
  Cut result;
  result.nodes = cutWithin(tolerance);
  result.capped = max_hulls > 0 && result.nodes.size() > static_cast<std::size_t>(max_hulls);
  if (result.capped) result.nodes = tree_.cutTo(max_hulls);
  for (const int id : result.nodes) result.bound = std::max(result.bound, reduced(id).bound);
  return result;
}

Decomposition hullsOfTree(const HullTree& tree, const DecomposeOptions& options) {
  TreeCutter cutter(tree, options.max_vertices);
  const TreeCutter::Cut cut = cutter.cut(options.tolerance, options.max_hulls);
  Decomposition result;
  result.capped = cut.capped;
  for (const int id : cut.nodes) result.hulls.push_back(cutter.hull(id));
  return result;
}

}  // namespace collision_hulls
