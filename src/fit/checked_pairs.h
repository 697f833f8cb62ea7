// Pairs of parts, and which of them a sample brings near each other.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "fit/assembly.h"

namespace collision_hulls {

/// Immutable, thread safe; keeps a reference to the assembly.
class CheckedPairs {
 public:
  /// The second part of a pair may be a body of the scene, the first is a link.
  CheckedPairs(const Assembly& assembly, std::vector<PartPair> pairs);

  const std::vector<PartPair>& all() const { return pairs_; }
  double clearance() const { return clearance_; }  ///< [m] the largest of a pair

  /// The pairs, as indices in ascending order, that may be within `distance` [m] of each other, judged by boxes around each link in the
  /// scene's frame, and by those around the scene's bodies.
  std::vector<std::size_t> near(const std::vector<Eigen::AlignedBox3d>& links, double distance) const;

 private:
  const Assembly& assembly_;
  std::vector<PartPair> pairs_;
  double clearance_ = 0;
  std::vector<std::size_t> of_links_;          // indices of pairs of two links
  std::vector<std::vector<int>> with_bodies_;  // for each link and body of the scene: the pair's index, or -1; empty: no such pair
};

}  // namespace collision_hulls
