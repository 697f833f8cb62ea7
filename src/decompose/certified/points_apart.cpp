// A lower bound on the number of hulls: two points of the surface whose connecting segment leaves the solid by more than the tolerance
// cannot be in one hull that fits, since hulls are convex. If there are K points that are pairwise apart, every cover needs K hulls. This
// holds for any splitting whatever, unlike leastPossible() in local_search.cpp, which speaks of the elements at hand.
//
// Backtracking over sample points, one per group of the cover; only points in no other group's hull are of use. Each pair's segment is
// sampled at up to seven points, and the answer is remembered. The number of steps is limited: no answer means nothing was found.
#include "decompose/certified/points_apart.h"

#include <algorithm>
#include <vector>

namespace collision_hulls {

namespace {

constexpr std::size_t kMostGroups = 8;      // with more it hardly ever succeeds
constexpr std::size_t kPoints = 16;         // per group
constexpr std::size_t kSamples = 2000;      // triangles sampled
constexpr int kHalvings = 3;                // of the segment between two points
constexpr std::size_t kMostSteps = 20'000;  // of the search

/// Searches for points, one per group, that are pairwise apart.
class Search {
 public:
  Search(const Cover& cover, const TriangleMesh& mesh, const Solid& solid, double tolerance) : solid_(solid), tolerance_(tolerance) {
    for (const std::vector<Eigen::Vector3d>& own : ownPoints(cover, mesh)) {
      first_.push_back(points_.size());
      const std::size_t count = std::min(kPoints, own.size());
      for (std::size_t i = 0; i < count; ++i) points_.push_back(own[i * own.size() / count]);
    }
    first_.push_back(points_.size());
    apart_.resize(points_.size() * points_.size(), -1);
  }

  /// Continues with the given group.
  bool run(std::size_t group = 0) {
    if (group + 1 == first_.size()) return true;
    for (std::size_t p = first_[group]; p < first_[group + 1] && ++steps_ < kMostSteps; ++p) {
      if (!std::all_of(chosen_.begin(), chosen_.end(), [&](std::size_t q) { return areApart(p, q); })) continue;
      chosen_.push_back(p);
      if (run(group + 1)) return true;
      chosen_.pop_back();
    }
    return false;
  }

 private:
  /// Per group, the sample points that lie in its hull and in no other: triangle centroids and corners.
  static std::vector<std::vector<Eigen::Vector3d>> ownPoints(const Cover& cover, const TriangleMesh& mesh) {
    std::vector<std::vector<Eigen::Vector3d>> own(cover.size());
    const auto add = [&](const Eigen::Vector3d& p) {
      std::size_t holders = 0, last = 0;
      for (std::size_t g = 0; g < cover.size(); ++g)
        if (holds(*cover[g].hull, p)) ++holders, last = g;
      if (holders == 1) own[last].push_back(p);
    };
    const std::size_t n = mesh.triangles.size(), stride = std::max<std::size_t>(1, n / kSamples);
    for (std::size_t t = 0; t < n; t += stride) {
      const auto at = [&](std::size_t k) -> const Eigen::Vector3d& { return mesh.corner(static_cast<int>(t), k); };
      add((at(0) + at(1) + at(2)) / 3);
      add(at(t % 3));
    }
    return own;
  }

  bool areApart(std::size_t p, std::size_t q) {
    signed char& known = apart_[p * points_.size() + q];
    if (known < 0) known = leavesSolid(points_[p], points_[q]);
    return known != 0;
  }

  /// Whether the segment between two points leaves the solid by more than the tolerance.
  bool leavesSolid(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    for (int parts = 2; parts <= 1 << kHalvings; parts *= 2)
      for (int i = 1; i < parts; i += 2)
        if (!solid_.isWithin(tolerance_, from + (static_cast<double>(i) / parts) * (to - from))) return true;
    return false;
  }

  const Solid& solid_;
  const double tolerance_;
  std::vector<Eigen::Vector3d> points_;  // grouped by group
  std::vector<std::size_t> first_;       // per group: its first point
  std::vector<signed char> apart_;       // per pair of points; -1: not evaluated yet
  std::vector<std::size_t> chosen_;      // points chosen so far, one per group
  std::size_t steps_ = 0;
};

}  // namespace

bool isLeast(const Cover& cover, const TriangleMesh& mesh, const Solid& solid, double tolerance) {
  return cover.size() <= 1 || (cover.size() <= kMostGroups && Search(cover, mesh, solid, tolerance).run());
}

}  // namespace collision_hulls
