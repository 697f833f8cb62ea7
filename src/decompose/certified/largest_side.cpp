// For each of 18 directions: raise a plane to where the area below it just exceeds the best so far (bisection on the area, no hull needed).
// If the hull of what is below very likely fits, raise the plane further, by bisection on the hull, as long as it does: roughly in each
// direction, and finely in the best.
//
// Why: a score sees one split, and its best split may spoil the large convex body that one hull could have taken. This finds such bodies by
// brute force. It pays only where few hulls are left to argue about, so it is one way to split among several, not the rule.
// O(n) for the areas of a direction, as each of the 12 steps leaves about half of the triangles to the next; O(n log n) for its first hull
// of n vertices, and then at most 3 hulls per direction, and 5 more, of the corners so far and what lies above them.
#include "decompose/certified/largest_side.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <numeric>

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
    for (std::size_t t = 0; t < piece_.triangles.size(); ++t) sum += areaBelow(t, plane);
    return sum / area_;
  }

  /// A height just above that below which lies a share of `least` of the area, by bisection. Each step looks only at the triangles between
  /// the bounds that the last one left.
  double heightAbove(double least) const {
    double low = *std::min_element(height_.begin(), height_.end()), high = *std::max_element(height_.begin(), height_.end());
    std::vector<std::size_t> between(piece_.triangles.size());
    std::iota(between.begin(), between.end(), std::size_t{0});
    double below = 0;  // area of the triangles that are wholly below
    for (int i = 0; i < kAreaHalvings; ++i) {
      const double middle = (low + high) / 2;
      double sum = below;
      for (const std::size_t t : between) sum += areaBelow(t, middle);
      const bool is_low = sum / area_ <= least;
      (is_low ? low : high) = middle;
      const auto is_done = [&](std::size_t t) {
        const bool is_below = is_low && highest(t) <= middle;
        if (is_below) below += areas_[t];
        return is_below || (!is_low && lowest(t) >= middle);
      };
      between.erase(std::remove_if(between.begin(), between.end(), is_done), between.end());
    }
    return high;
  }

  /// Heights of two planes: below the first, the piece's hull fits the tolerance; below the second it may not.
  struct Limit {
    double fitting, beyond;
    std::vector<Eigen::Vector3d> corners;  // of the hull below the first
  };

  /// Roughly. nullopt: no hull fits below which more than `least` of the area lies.
  std::optional<Limit> limit(double least, ProtrusionOracle& oracle) const {
    const double high = *std::max_element(height_.begin(), height_.end());
    Limit limit{-std::numeric_limits<double>::infinity(), high, {}};
    const double start = heightAbove(least);
    if (!(start < high) || !raised(limit, start, oracle)) return std::nullopt;
    return closer(limit, kRoughHalvings, oracle);
  }

  Limit closer(Limit limit, int halvings, ProtrusionOracle& oracle) const {
    for (int i = 0; i < halvings; ++i) {
      const double middle = (limit.fitting + limit.beyond) / 2;
      if (!raised(limit, middle, oracle)) limit.beyond = middle;
    }
    return limit;
  }

 private:
  double corner(std::size_t t, std::size_t k) const { return height_[static_cast<std::size_t>(piece_.triangles[t][k])]; }
  double lowest(std::size_t t) const { return std::min({corner(t, 0), corner(t, 1), corner(t, 2)}); }
  double highest(std::size_t t) const { return std::max({corner(t, 0), corner(t, 1), corner(t, 2)}); }

  double areaBelow(std::size_t t, double plane) const {
    std::array<double, 3> h{corner(t, 0) - plane, corner(t, 1) - plane, corner(t, 2) - plane};
    std::sort(h.begin(), h.end());
    if (h[2] <= 0) return areas_[t];
    if (h[1] <= 0 && h[0] < 0) return areas_[t] * (1 - h[2] * h[2] / ((h[2] - h[0]) * (h[2] - h[1])));
    return h[0] < 0 ? areas_[t] * h[0] * h[0] / ((h[1] - h[0]) * (h[2] - h[0])) : 0;
  }

  /// Raises the limit to a plane if the hull of what is below very likely fits. Of what lies below the limit, the corners suffice.
  bool raised(Limit& limit, double plane, ProtrusionOracle& oracle) const {
    std::vector<Eigen::Vector3d> points = limit.corners;
    for (std::size_t i = 0; i < height_.size(); ++i)
      if (height_[i] > limit.fitting && height_[i] <= plane) points.push_back(piece_.vertices[i]);
    for (const auto& [a, b] : edges_) {
      const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
      const double ha = height_[i] - plane, hb = height_[j] - plane;
      if (ha * hb < 0) points.push_back(piece_.vertices[i] + (ha / (ha - hb)) * (piece_.vertices[j] - piece_.vertices[i]));
    }
    if (oracle.refutes(points)) return false;
    ConvexHull hull = roughHull(points);
    if (!oracle.mayWellFit(hull)) return false;
    limit.fitting = plane;
    limit.corners = std::move(hull.vertices);
    return true;
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
  Beneath::Limit of_best{0, 0, {}};
  double most = kLeast;
  for (const Eigen::Vector3d& up : directions()) {
    beneath.setDirection(up);
    std::optional<Beneath::Limit> limit = beneath.limit(most, oracle);
    if (!limit || beneath.share(limit->fitting) > kMost) continue;
    best = up;
    most = beneath.share(limit->fitting);
    of_best = *std::move(limit);
  }
  if (!best) return std::nullopt;
  beneath.setDirection(*best);
  const double finely = beneath.closer(of_best, kFineHalvings, oracle).fitting;
  return HalfSpace{*best, beneath.share(finely) > kMost ? of_best.fitting : finely};
}

}  // namespace collision_hulls
