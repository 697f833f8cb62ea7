// For each of 18 directions: raise a plane to where the area below it just exceeds the best so far (bisection on the area, no hull needed).
// If the hull of what is below very likely fits, raise the plane further, by bisection on the hull, as long as it does: roughly in each
// direction, and finely in the best.
//
// Why: a score sees one split, and its best split may spoil the large convex body that one hull could have taken. This finds such bodies by
// brute force. It pays only where few hulls are left to argue about, so it is one way to split among several, not the rule.
// O(n) for each area and O(n log n) for each hull of n vertices; at most 12 areas and 4 hulls per direction,
// and 5 hulls more.
#include "decompose/certified/largest_side.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace collision_hulls {

namespace {

// Largest piece to try: larger ones take long, and simplifying them would blur where the hull stops fitting.
constexpr std::size_t kMostVertices = 4000;
constexpr double kLeast = 0.15, kMost = 0.95;  // shares of the area that make a split worthwhile
constexpr int kAreaHalvings = 12;              // bisections to reach a given share of the area,
constexpr int kRoughHalvings = 3;              // from there on in each direction,
constexpr int kFineHalvings = 5;               // and then in the best

/// A piece, divided by planes normal to one direction.
class Beneath {
 public:
  explicit Beneath(const SurfacePiece& piece) : piece_(piece), edges_(edgesOf(piece_)), height_(piece_.vertices.size()) {
    for (const Triangle& t : piece_.triangles) {
      const auto at = [&](std::size_t k) { return piece_.vertices[static_cast<std::size_t>(t[k])]; };
      areas_.push_back((at(1) - at(0)).cross(at(2) - at(0)).norm() / 2);
      area_ += areas_.back();
    }
  }

  double area() const { return area_; }

  void setDirection(const Eigen::Vector3d& up) {
    for (std::size_t i = 0; i < height_.size(); ++i) height_[i] = up.dot(piece_.vertices[i]);
  }

  /// The share of the area below the plane at some height.
  double share(double plane) const {
    double sum = 0;
    for (std::size_t t = 0; t < piece_.triangles.size(); ++t) {
      std::array<double, 3> h{};
      for (std::size_t k = 0; k < 3; ++k) h[k] = height_[static_cast<std::size_t>(piece_.triangles[t][k])] - plane;
      std::sort(h.begin(), h.end());
      if (h[2] <= 0)
        sum += areas_[t];
      else if (h[1] <= 0 && h[0] < 0)
        sum += areas_[t] * (1 - h[2] * h[2] / ((h[2] - h[0]) * (h[2] - h[1])));
      else if (h[0] < 0)
        sum += areas_[t] * h[0] * h[0] / ((h[1] - h[0]) * (h[2] - h[0]));
    }
    return sum / area_;
  }

  /// Heights of two planes: below the first, the piece's hull fits the tolerance; below the second it may not.
  struct Limit {
    double fitting, beyond;
  };

  /// Roughly. nullopt: no hull fits below which more than `least` of the area lies.
  std::optional<Limit> limit(double least, ProtrusionOracle& oracle) const {
    double low = *std::min_element(height_.begin(), height_.end()), high = *std::max_element(height_.begin(), height_.end());
    Limit limit{high, high};
    halve(low, limit.fitting, kAreaHalvings, [&](double plane) { return share(plane) <= least; });
    if (!(limit.fitting < high) || !oracle.mayWellFit(hull(limit.fitting))) return std::nullopt;
    return closer(limit, kRoughHalvings, oracle);
  }

  Limit closer(Limit limit, int halvings, ProtrusionOracle& oracle) const {
    halve(limit.fitting, limit.beyond, halvings, [&](double plane) { return oracle.mayWellFit(hull(plane)); });
    return limit;
  }

 private:
  /// Bisects towards the point where `lower` becomes false.
  template <class F>
  static void halve(double& low, double& high, int times, F lower) {
    for (int i = 0; i < times; ++i) {
      const double middle = (low + high) / 2;
      (lower(middle) ? low : high) = middle;
    }
  }

  ConvexHull hull(double plane) const {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < height_.size(); ++i)
      if (height_[i] <= plane) points.push_back(piece_.vertices[i]);
    for (const auto& [a, b] : edges_) {
      const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
      const double ha = height_[i] - plane, hb = height_[j] - plane;
      if (ha * hb < 0) points.push_back(piece_.vertices[i] + (ha / (ha - hb)) * (piece_.vertices[j] - piece_.vertices[i]));
    }
    return roughHull(points);
  }

  const SurfacePiece& piece_;
  const std::vector<std::pair<int, int>> edges_;
  std::vector<double> areas_, height_;
  double area_ = 0;
};

/// The axes and the face diagonals of a cube, each in both directions; axes first.
std::vector<Eigen::Vector3d> directions() {
  std::vector<Eigen::Vector3d> axes, diagonals;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const int count = std::abs(x) + std::abs(y) + std::abs(z);
        if (count == 1) axes.emplace_back(x, y, z);
        if (count == 2) diagonals.push_back(Eigen::Vector3d(x, y, z).normalized());
      }
  axes.insert(axes.end(), diagonals.begin(), diagonals.end());
  return axes;
}

}  // namespace

std::optional<HalfSpace> largestSide(const SurfacePiece& piece, ProtrusionOracle& oracle) {
  if (piece.vertices.size() > kMostVertices) return std::nullopt;
  Beneath beneath(piece);
  if (!(beneath.area() > 0)) return std::nullopt;
  std::optional<Eigen::Vector3d> best;
  Beneath::Limit of_best{0, 0};
  double most = kLeast;
  for (const Eigen::Vector3d& up : directions()) {
    beneath.setDirection(up);
    const std::optional<Beneath::Limit> limit = beneath.limit(most, oracle);
    if (!limit || beneath.share(limit->fitting) > kMost) continue;
    best = up;
    of_best = *limit;
    most = beneath.share(limit->fitting);
  }
  if (!best) return std::nullopt;
  beneath.setDirection(*best);
  const double finely = beneath.closer(of_best, kFineHalvings, oracle).fitting;
  return HalfSpace{*best, beneath.share(finely) > kMost ? of_best.fitting : finely};
}

}  // namespace collision_hulls
