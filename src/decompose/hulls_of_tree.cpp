// A node's bound is of its hull with all its vertices. Fewer vertices let the hull protrude further, so a node within the tolerance may
// have to be opened after all: it is replaced by its children until each hull keeps the tolerance as it will be returned.
#include "decompose/hulls_of_tree.h"

#include "collision_hulls/decompose/reduce_vertices.h"

namespace collision_hulls {
namespace {

/// Whether a node's hull keeps the tolerance after its vertices are reduced.
bool keepsTolerance(const HullNode& node, const DecomposeOptions& options) {
  if (!exceedsCap(node.hull, options.max_vertices)) return node.protrusion <= options.tolerance;
  const ConvexHull reduced = reduceVertices(node.hull, options.max_vertices);
  return node.protrusion + addedDistance(reduced, node.hull) <= options.tolerance;
}

std::vector<int> cutWithin(const HullTree& tree, const DecomposeOptions& options) {
  std::vector<int> open = tree.cutAt(options.tolerance), cut;
  while (!open.empty()) {
    const int id = open.back();
    const HullNode& node = tree.nodes[static_cast<std::size_t>(id)];
    open.pop_back();
    if (node.left < 0 || keepsTolerance(node, options))
      cut.push_back(id);
    else
      open.insert(open.end(), {node.left, node.right});
  }
  return cut;
}

}  // namespace

Decomposition hullsOfTree(const HullTree& tree, const DecomposeOptions& options) {
  std::vector<int> cut = cutWithin(tree, options);
  Decomposition result;
  result.capped = options.max_hulls > 0 && cut.size() > static_cast<std::size_t>(options.max_hulls);
  if (result.capped) cut = tree.cutTo(options.max_hulls);
  result.hulls = tree.hullsOf(cut);
  for (ConvexHull& hull : result.hulls) hull = capped(hull, options.max_vertices);
  return result;
}

}  // namespace collision_hulls
