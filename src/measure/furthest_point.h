// The point of a surface that is furthest from the union of convex bodies, by branch and bound over pieces of the surface.
//
// The distance to one convex body is a convex function, so its maximum over a piece is at a corner, and so is that of the mean of two such
// distances, which bounds the smaller one. A surface in the middle between two bodies converges by the mean, one in a body by the single
// distance.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// `Bodies` has boxes(), one for each body; convexDistance(body, p), which is convex in p; and distance(p), to the nearest body, 0 inside.
template <class Bodies>
class FurthestPoint {
 public:
  explicit FurthestPoint(const Bodies& bodies) : bodies_(bodies) {}

  /// Adds a convex polygon to the surface.
  void add(const std::vector<Eigen::Vector3d>& polygon) {
    for (const Eigen::Vector3d& p : polygon) visit(p);
    for (std::size_t i = 2; i < polygon.size(); ++i)
      push({{polygon[0], polygon[i - 1], polygon[i]}, std::numeric_limits<double>::infinity()});
  }

  /// Ends when the bound exceeds what was found by 1 %, or by `gap` [m] if that is more; or else, with the bound that it has then, when
  /// `most_pieces` are halved.
  void search(int most_pieces, double gap, const RunControl& control = {}) {
    const auto enough = [&] { return found_ + std::max(gap, kGap * found_); };
    for (int pieces = 0; pieces < most_pieces && !queue_.empty() && queue_.top().bound > enough(); ++pieces) {
      if (pieces % kPiecesBetweenChecks == 0) control.check();
      halve();
    }
  }

  double found() const { return found_; }                                                          ///< [m]
  const Eigen::Vector3d& where() const { return where_; }                                          ///< a point at this distance
  double bound() const { return queue_.empty() ? found_ : std::max(found_, queue_.top().bound); }  ///< [m] no point is further

 private:
  static constexpr double kGap = 0.01;
  static constexpr int kPiecesBetweenChecks = 256;
  static constexpr std::size_t kNearBodies = 4;  // that bound a piece

  struct Piece {
    std::array<Eigen::Vector3d, 3> corner;
    double bound;
    bool operator<(const Piece& other) const { return bound < other.bound; }
  };

  void visit(const Eigen::Vector3d& p) {
    const double d = bodies_.distance(p);
    if (d > found_) found_ = d, where_ = p;
  }

  /// The bodies nearest to p.
  std::vector<std::size_t> nearest(const Eigen::Vector3d& p) const {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t b = 0; b < bodies_.boxes().size(); ++b) {
      if (near.size() == kNearBodies && bodies_.boxes()[b].exteriorDistance(p) >= near.back().first) continue;
      near.emplace_back(bodies_.convexDistance(b, p), b);
      std::sort(near.begin(), near.end());
      if (near.size() > kNearBodies) near.pop_back();
    }
    std::vector<std::size_t> result;
    for (const auto& item : near) result.push_back(item.second);
    return result;
  }

  void push(Piece piece) {
    const Eigen::Vector3d centre = (piece.corner[0] + piece.corner[1] + piece.corner[2]) / 3;
    visit(centre);
    const std::vector<std::size_t> near = nearest(centre);
    std::array<Eigen::Array3d, kNearBodies> distances;
    for (std::size_t i = 0; i < near.size(); ++i) {
      for (int k = 0; k < 3; ++k) distances[i][k] = bodies_.convexDistance(near[i], piece.corner[static_cast<std::size_t>(k)]);
      for (std::size_t j = 0; j <= i; ++j) piece.bound = std::min(piece.bound, (distances[i] + distances[j]).maxCoeff() / 2);
    }
    if (piece.bound > found_) queue_.push(piece);
  }

  void halve() {
    Piece piece = queue_.top();
    queue_.pop();
    std::size_t a = 0;
    const auto length = [&](std::size_t i) { return (piece.corner[i] - piece.corner[(i + 1) % 3]).squaredNorm(); };
    for (std::size_t i = 1; i < 3; ++i)
      if (length(i) > length(a)) a = i;
    const std::size_t b = (a + 1) % 3;
    const Eigen::Vector3d middle = (piece.corner[a] + piece.corner[b]) / 2;
    visit(middle);
    Piece other = piece;
    piece.corner[b] = other.corner[a] = middle;
    push(piece);
    push(other);
  }

  const Bodies& bodies_;
  double found_ = 0;
  Eigen::Vector3d where_ = Eigen::Vector3d::Zero();
  std::priority_queue<Piece> queue_;
};

}  // namespace collision_hulls
