// Puts half-edges into one bucket per lower end (a counting sort) and sorts each small bucket by upper end: no hashing, no global sort. A
// union-find over the shared edges then gives the components.
#include "mesh/edges.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "base/looks.h"

namespace collision_hulls {
namespace {

/// Half-edges with lower end v are in [begin[v], begin[v + 1]), sorted by upper end, then by number.
struct Buckets {
  struct Entry {
    int upper;
    int half_edge;
  };
  std::vector<int> begin;
  std::vector<Entry> entries;
};

Buckets fillBuckets(const std::vector<Triangle>& triangles, std::size_t vertices, const RunControl& control) {
  Buckets buckets;
  const int half_edges = static_cast<int>(3 * triangles.size());
  const auto lower = [&](int h) { return static_cast<std::size_t>(std::min(startOf(triangles, h), endOf(triangles, h))); };
  buckets.begin.assign(vertices + 1, 0);
  Looks look(control);
  for (int h = 0; h < half_edges; ++h) look(), ++buckets.begin[lower(h) + 1];
  std::partial_sum(buckets.begin.begin(), buckets.begin.end(), buckets.begin.begin());
  buckets.entries.resize(static_cast<std::size_t>(half_edges));
  std::vector<int> end(buckets.begin.begin(), buckets.begin.end() - 1);
  for (int h = 0; h < half_edges; ++h) {
    look();
    buckets.entries[static_cast<std::size_t>(end[lower(h)]++)] = {std::max(startOf(triangles, h), endOf(triangles, h)), h};
  }
  const auto order = [](const Buckets::Entry& a, const Buckets::Entry& b) {
    return a.upper != b.upper ? a.upper < b.upper : a.half_edge < b.half_edge;
  };
  for (std::size_t v = 0; v < vertices; ++v) {
    look();
    std::sort(buckets.entries.begin() + buckets.begin[v], buckets.entries.begin() + buckets.begin[v + 1], order);
  }
  return buckets;
}

/// Records one edge, with half-edges [first, last).
void record(const Buckets::Entry* first, const Buckets::Entry* last, Edges* edges, DisjointSets* sets) {
  const auto count = last - first;
  if (count == 1) ++edges->open;
  if (count > 2) ++edges->nonmanifold;
  for (const Buckets::Entry* e = first; e != last; ++e) {
    int& twin = edges->twin[static_cast<std::size_t>(e->half_edge)];
    twin = count == 1 ? Edges::kOpen : count > 2 ? Edges::kNonManifold : (e == first ? first + 1 : first)->half_edge;
    sets->join(first->half_edge / 3, e->half_edge / 3);
  }
}

void numberComponents(const RunControl& control, DisjointSets* sets, Edges* edges) {
  Looks look(control);
  for (std::size_t t = 0; t < edges->component.size(); ++t) {
    look();
    const auto root = static_cast<std::size_t>(sets->find(static_cast<int>(t)));
    edges->component[t] = root == t ? static_cast<int>(edges->components++) : edges->component[root];
  }
}

}  // namespace

Edges findEdges(const std::vector<Triangle>& triangles, std::size_t vertices, const RunControl& control) {
  Edges edges;
  edges.twin.resize(3 * triangles.size());
  edges.component.resize(triangles.size());
  DisjointSets sets(triangles.size());
  const Buckets buckets = fillBuckets(triangles, vertices, control);
  Looks look(control);
  for (std::size_t v = 0; v < vertices; ++v) {
    look();
    const Buckets::Entry* const end = buckets.entries.data() + buckets.begin[v + 1];
    for (const Buckets::Entry* first = buckets.entries.data() + buckets.begin[v]; first != end;) {
      const Buckets::Entry* last = first;
      while (last != end && last->upper == first->upper) ++last;
      record(first, last, &edges, &sets);
      first = last;
    }
  }
  numberComponents(control, &sets, &edges);
  return edges;
}

}  // namespace collision_hulls
