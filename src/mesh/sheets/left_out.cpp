// A queue of patches by area. One that is left out, or put back, makes its odd edges even and the others odd. At the latter it may now help
// to do the same with what it meets there, which is looked at again. Each step leaves fewer odd edges. O(n log n) in the patches at edges,
// but for edges where very many meet.
#include "mesh/sheets/left_out.h"

#include <cstddef>
#include <set>
#include <utility>

#include "base/at.h"

namespace collision_hulls {

std::vector<char> leftOut(const std::vector<std::vector<int>>& edges, const std::vector<double>& areas, Looks& look) {
  std::vector<std::vector<std::size_t>> edges_of(areas.size());
  std::vector<char> is_odd(edges.size(), 0);
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const int patch : edges[e]) {
      look();
      edges_of[at(patch)].push_back(e);
      is_odd[e] = !is_odd[e];
    }
  std::set<std::pair<double, int>> waiting;
  for (std::size_t p = 0; p < areas.size(); ++p) waiting.insert({areas[p], static_cast<int>(p)});
  std::vector<char> left_out(areas.size(), 0);
  while (!waiting.empty()) {
    const int patch = waiting.begin()->second;
    waiting.erase(waiting.begin());
    std::size_t odd = 0;
    for (const std::size_t e : edges_of[at(patch)]) look(), odd += is_odd[e] ? 1 : 0;
    if (2 * odd <= edges_of[at(patch)].size()) continue;
    left_out[at(patch)] = !left_out[at(patch)];
    for (const std::size_t e : edges_of[at(patch)]) {
      is_odd[e] = !is_odd[e];
      if (!is_odd[e]) continue;
      for (const int other : edges[e]) look(), waiting.insert({areas[at(other)], other});
    }
  }
  return left_out;
}

}  // namespace collision_hulls
