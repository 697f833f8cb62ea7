// Which pairs of points are apart.
#pragma once

#include <cstddef>
#include <vector>

#include "decompose/least/apart.h"
#include "decompose/least/clique.h"
#include "decompose/least/witnesses.h"

namespace collision_hulls {

/// Tests pairs of points. Points that a hull within the tolerance holds together need no test.
class PairTest {
 public:
  /// `known`: hulls within the tolerance. All arguments must outlive this.
  PairTest(const Points& points, const std::vector<ConvexHull>& known, const Apart& apart);

  bool operator()(std::size_t a, std::size_t b) const;

  /// Tests the pairs of the first `count` points now, and never again.
  const Graph& graphOf(std::size_t count, const RunControl& control);

 private:
  const Points& points_;
  const Apart& apart_;
  std::vector<NodeSet> holders_;  // per point: the hulls that hold it
  Graph known_;
};

}  // namespace collision_hulls
