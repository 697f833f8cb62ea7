// The tree of hulls that merging produces: every level of detail of a collision model at once.
//
// For example:
//
//     #include "collision_hulls/decompose/certified.h"
//
//     const HullTree tree = hullTree(repair(mesh), options);
//     const std::vector<ConvexHull> coarse = tree.hullsOf(tree.cutAt(0.05));  // within 5 cm
//     const std::vector<ConvexHull> few = tree.hullsOf(tree.cutTo(8));        // at most 8
//
// Nodes hold the hulls of the repaired mesh, whose bounds leave out what repair() moved.
// certifiedHulls() of a PreparedMesh with the tree gives the hulls of a cut with the whole promise.
#pragma once

#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// A node of the tree. A leaf is the hull of a piece of surface, an inner node the hull of its two
/// children.
struct HullNode {
  ConvexHull hull;
  /// [m] upper bound on the distance of the hull's points from the solid; never less than a child's
  double protrusion = 0;
  int parent = -1;            ///< -1: the root
  int left = -1, right = -1;  ///< -1: a leaf
};

/// A binary tree. Children precede their parents; the last node is the root, which contains
/// everything. A cut is a set of nodes with exactly one node on each path from the root to a leaf;
/// its hulls cover the mesh. A tree without nodes has one cut, the empty one.
struct HullTree {
  std::vector<HullNode> nodes;
  double tolerance = 0;  ///< [m] the tolerance of the leaves

  /// The coarsest cut whose nodes protrude no further than `tolerance` [m]. Only leaves may exceed
  /// it: they have no children. So a tolerance below the tree's own makes no finer cut. Nodes in
  /// ascending order.
  std::vector<int> cutAt(double tolerance) const;

  /// A cut of at most `hulls` nodes (less than 1 counts as 1): starts at the root and keeps
  /// replacing the furthest protruding node by its children. Nodes in ascending order.
  std::vector<int> cutTo(int hulls) const;

  /// Whether these nodes form a cut.
  bool isCut(const std::vector<int>& nodes) const;

  /// The hulls of a cut, in the cut's order. Throws kIndexOutOfRange for a node that is not there.
  std::vector<ConvexHull> hullsOf(const std::vector<int>& cut) const;
};

}  // namespace collision_hulls
