// Most of the time of a bound goes into these pairs, so whatever tells without a test helps: two points in one hull of a cover that is
// proved to stay within the tolerance are never apart.
#include "decompose/least/pairs.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"

namespace collision_hulls {

PairTest::PairTest(const Points& points, const std::vector<ConvexHull>& known, const Apart& apart)
    : points_(points), apart_(apart), holders_(points.size(), NodeSet(known.size())), known_(0) {
  forEach(points.size(), [&](std::size_t i) {
    for (std::size_t h = 0; h < known.size(); ++h)
      if (holds(known[h], points[i])) holders_[i].add(h);
  });
}

bool PairTest::operator()(std::size_t a, std::size_t b) const {
  if (std::max(a, b) < known_.size()) return known_.connected(a, b);
  return a != b && !holders_[a].meets(holders_[b]) && apart_(points_[a], points_[b]);
}

const Graph& PairTest::graphOf(std::size_t count, const RunControl& control) {
  std::vector<std::vector<std::size_t>> found(count);
  forEach(count, [&](std::size_t i) {
    control.check();
    for (std::size_t j = 0; j < i; ++j)
      if ((*this)(i, j)) found[i].push_back(j);
  });
  Graph graph(count);
  for (std::size_t i = 0; i < count; ++i)
    for (const std::size_t j : found[i]) graph.connect(i, j);
  return known_ = std::move(graph);
}

}  // namespace collision_hulls
