// Sorts the half-edges that have no counterpart, adds them up edge by edge, and walks what is left. O(n log n).
#include "measure/rim.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/looks.h"

namespace collision_hulls {
namespace {

/// Whether a half-edge and its twin, the only other one on its edge, run in opposite directions.
bool isPaired(const std::vector<Triangle>& triangles, const Edges& edges, int h) {
  const int twin = edges.twin[static_cast<std::size_t>(h)];
  return twin >= 0 && startOf(triangles, twin) == endOf(triangles, h);
}

/// The edges of a rim that are not walked yet.
class Onward {
 public:
  Onward(const std::vector<Eigen::Vector3d>& vertices, const Rim& rim)
      : vertices_(vertices), first_(vertices.size(), 0), last_(vertices.size(), 0), ends_(rim.size()) {
    for (const auto& [from, to] : rim) ++last_[index(from)];
    std::partial_sum(last_.begin(), last_.end(), last_.begin());
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] = last_[v - 1];
    last_ = first_;
    for (const auto& [from, to] : rim) ends_[last_[index(from)]++] = to;
  }

  bool any(int v) const { return first_[index(v)] < last_[index(v)]; }

  /// Takes the edge from v that turns back most, and returns its end.
  int take(int before, int v) {
    const Eigen::Vector3d back = at(before) - at(v);
    const auto turn = [&](int end) { return (at(end) - at(v)).normalized().dot(back); };
    const auto first = ends_.begin() + static_cast<std::ptrdiff_t>(first_[index(v)]);
    const auto last = ends_.begin() + static_cast<std::ptrdiff_t>(last_[index(v)]--);
    auto taken = last - 1;
    if (before != v && last - first > 1) taken = std::max_element(first, last, [&](int a, int b) { return turn(a) < turn(b); });
    const int next = *taken;
    std::move(taken + 1, last, taken);
    return next;
  }

 private:
  static std::size_t index(int v) { return static_cast<std::size_t>(v); }
  const Eigen::Vector3d& at(int v) const { return vertices_[index(v)]; }

  const std::vector<Eigen::Vector3d>& vertices_;
  std::vector<std::size_t> first_, last_;  // per vertex: where in `ends_` the ends of its edges are
  std::vector<int> ends_;
};

}  // namespace

Rim rimOf(const RepairedMesh& mesh, const Edges& edges, const RunControl& control) {
  const std::vector<Triangle>& triangles = mesh.mesh.triangles;
  Looks look(control);
  Rim unpaired;
  for (int h = 0; h < static_cast<int>(edges.twin.size()); ++h) {
    look();
    if (!isPaired(triangles, edges, h) && !mesh.sheet[static_cast<std::size_t>(h / 3)])
      unpaired.push_back({startOf(triangles, h), endOf(triangles, h)});
  }
  const auto undirected = [](const auto& edge) { return std::minmax({edge[0], edge[1]}); };
  std::sort(unpaired.begin(), unpaired.end(), [&](const auto& a, const auto& b) { return look(), undirected(a) < undirected(b); });
  Rim rim;
  for (auto edge = unpaired.begin(); edge != unpaired.end();) {
    const std::pair<int, int> ends = undirected(*edge);
    int surplus = 0;
    for (; edge != unpaired.end() && undirected(*edge) == ends; ++edge) look(), surplus += (*edge)[0] == ends.first ? 1 : -1;
    for (int i = 0; i < surplus; ++i) rim.push_back({ends.first, ends.second});
    for (int i = 0; i < -surplus; ++i) rim.push_back({ends.second, ends.first});
  }
  return rim;
}

std::vector<Loop> loopsOf(const std::vector<Eigen::Vector3d>& vertices, const Rim& rim, const RunControl& control) {
  Onward onward(vertices, rim);
  std::vector<Loop> loops;
  std::vector<int> place(vertices.size(), -1);  // on the path; -1: not there
  Looks look(control);
  for (const auto& [from, to] : rim) {
    Loop path;
    for (int v = from;;) {
      look();
      int& mine = place[static_cast<std::size_t>(v)];
      if (mine >= 0) {
        loops.emplace_back(path.begin() + mine, path.end());
        for (int u : loops.back()) place[static_cast<std::size_t>(u)] = -1;
        path.resize(path.size() - loops.back().size());
      }
      if (!onward.any(v)) break;
      mine = static_cast<int>(path.size());
      path.push_back(v);
      v = onward.take(path.size() > 1 ? path[path.size() - 2] : v, v);
    }
  }
  return loops;
}

}  // namespace collision_hulls
