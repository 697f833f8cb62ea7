// What is known about the triangles of earlier hulls. Hulls that are asked about one after another, in merging and in local search, share
// most of their triangles, and these then need no second search.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Remembers upper bounds on the distance of triangles' points from one solid. Triangles are the same if their corners are, bit by bit.
class KnownFacets {
 public:
  /// For each of the hull's triangles, whether all its points are known to be within `distance` [m].
  std::vector<char> within(double distance, const ConvexHull& hull) const;
  std::size_t unknown(double distance, const ConvexHull& hull) const;  ///< the number of the others

  /// All points of the hull's triangles are within `bound` [m].
  void learn(const ConvexHull& hull, double bound);
  void learn(const KnownFacets& other);

 private:
  void learn(std::uint64_t key, double bound);

  std::unordered_map<std::uint64_t, double> bounds_;
};

}  // namespace collision_hulls
