// Sorts all triangle sides by mesh edge and connects the triangles in each run of equal edges.
#include "decompose/hacd/dual_graph.h"

#include <algorithm>
#include <tuple>

namespace collision_hulls {

namespace {

constexpr std::size_t kFanReach = 8;  // pairs per triangle at a non-manifold edge

/// A triangle's side, identified by its mesh edge.
struct Side {
  int low, high, triangle;
  bool operator<(const Side& o) const { return std::tie(low, high, triangle) < std::tie(o.low, o.high, o.triangle); }
};

std::vector<Side> sortedSides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      sides.push_back({low, high, static_cast<int>(t)});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Merges the edges of each pair and adds up their borders: two triangles may share two mesh edges.
std::vector<DualEdge> joined(std::vector<DualEdge> edges) {
  std::sort(edges.begin(), edges.end(), [](const DualEdge& a, const DualEdge& b) { return std::tie(a.v, a.w) < std::tie(b.v, b.w); });
  std::vector<DualEdge> result;
  for (const DualEdge& edge : edges) {
    if (!result.empty() && result.back().v == edge.v && result.back().w == edge.w)
      result.back().border += edge.border;
    else
      result.push_back(edge);
  }
  return result;
}

}  // namespace

std::vector<DualEdge> dualGraph(const TriangleMesh& mesh) {
  const std::vector<Side> sides = sortedSides(mesh);
  std::vector<DualEdge> edges;
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].low == sides[first].low && sides[end].high == sides[first].high) ++end;
    const std::size_t before = edges.size();
    for (std::size_t i = first; i < end; ++i)
      for (std::size_t j = i + 1; j < std::min(end, i + 1 + kFanReach); ++j)
        if (sides[i].triangle != sides[j].triangle) edges.push_back({sides[i].triangle, sides[j].triangle, 0});
    const double length = (mesh.vertices[sides[first].low] - mesh.vertices[sides[first].high]).norm();
    const double share = static_cast<double>(end - first) / (2.0 * static_cast<double>(edges.size() - before));
    for (std::size_t e = before; e < edges.size(); ++e) edges[e].border = share * length;
  }
  return joined(std::move(edges));
}

}  // namespace collision_hulls
