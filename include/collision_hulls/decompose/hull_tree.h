// The tree of hulls that merging leaves behind: every level of detail of a collision model at once.
#pragma once

#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// A node of the tree: a leaf is the hull of a piece of surface, an inner node the hull of its two children.
struct HullNode {
  ConvexHull hull;
  double protrusion = 0;      ///< [m] no point of the hull is further from the solid; never less than a child's
  int parent = -1;            ///< -1: the root
  int left = -1, right = -1;  ///< -1: a leaf
};

/// Binary; children stand before their parents, and the root, which holds everything, last. A cut (a set of nodes of which each leaf
/// has exactly one above it or is one) is a covering hull set. Immutable values are safe to share between threads.
struct HullTree {
  std::vector<HullNode> nodes;
  double tolerance = 0;  ///< [m] that the leaves were made for

  /// The coarsest cut whose nodes protrude no further than `tolerance` [m]; leaves where even they do. Nodes ascending.
  std::vector<int> cutAt(double tolerance) const;

  /// The cut of at most `hulls` (>= 1) nodes that opening the furthest protruding node, again and again, leads to.
  std::vector<int> cutTo(int hulls) const;

  /// Whether these nodes are a cut.
  bool isCut(const std::vector<int>& nodes) const;

  /// The hulls of a cut, in its order.
  std::vector<ConvexHull> hullsOf(const std::vector<int>& cut) const;
};

}  // namespace collision_hulls
