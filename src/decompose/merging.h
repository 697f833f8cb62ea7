// Bottom up: leaves merged, cheapest first, into a tree of hulls.
#pragma once

#include <functional>
#include <vector>

#include "collision_hulls/decompose/hull_tree.h"
#include "decompose/cutting.h"

namespace collision_hulls {

/// Merges leaves while the hull of a merge stays within the oracle's tolerance, then all the rest up to a single root where
/// `to_root` is set; otherwise the nodes left over are the last ones without a parent. Deterministic.
HullTree merged(const std::vector<Leaf>& leaves, ProtrusionOracle& oracle, bool to_root, const std::function<void(double)>& progress);

/// The nodes without a parent, ascending.
std::vector<int> rootsOf(const HullTree& tree);

}  // namespace collision_hulls
