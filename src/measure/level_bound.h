// An upper bound on the distance to a surface over a convex polytope; tight where that distance is nearly constant (level).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>

#include "collision_hulls/geometry/triangle_bvh.h"

namespace collision_hulls {

/// Lemma 3 of doc/certified.md. The distance f to the surface is at most the distance d_j to any of its triangles, so f <= min_j d_j <=
/// sum_j w_j d_j for any weights w
/// >= 0 that sum to 1. That sum is convex: its maximum over a polytope is at a corner. One triangle gives a good bound beside a wall, two
/// do so midway between walls. The best weights are those of a small matrix game, corner against triangle.
template <std::size_t Corners, std::size_t MostTriangles>
class LevelBound {
 public:
  LevelBound(const std::array<Eigen::Vector3d, Corners>& corners, const TriangleBvh& surface) : corners_(corners), surface_(surface) {}

  /// Adds a triangle of the surface; ignores -1, a triangle added before, and any beyond the capacity.
  void add(int triangle) {
    if (triangle < 0 || count_ == MostTriangles) return;
    for (std::size_t k = 0; k < count_; ++k)
      if (triangles_[k] == triangle) return;
    const auto& [a, b, c] = surface_.corners(triangle);
    const Eigen::Index column = static_cast<Eigen::Index>(count_);
    for (std::size_t i = 0; i < Corners; ++i)
      distance_(static_cast<Eigen::Index>(i), column) = (closestPoint(a, b, c, corners_[i]) - corners_[i]).norm();
    nearest_ = std::min(nearest_, distance_.col(column).maxCoeff());
    triangles_[count_++] = triangle;
  }

  /// Infinite without triangles.
  double value() const { return count_ > 1 ? std::min(nearest_, gameValue()) : nearest_; }

  /// Whether one triangle alone already gives value() <= distance; more triangles then do not matter.
  bool reaches(double distance) const { return nearest_ <= distance; }

 private:
  static constexpr int kRounds = 16;
  static constexpr int kRows = static_cast<int>(Corners), kColumns = static_cast<int>(MostTriangles);

  /// The minimum over weights of the maximum over corners, by fictitious play: any weights give an upper bound, good ones a tight one.
  double gameValue() const {
    const auto distance = distance_.leftCols(static_cast<Eigen::Index>(count_));
    Eigen::Matrix<double, kRows, 1> total = Eigen::Matrix<double, kRows, 1>::Zero();
    Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kColumns> against = distance.colwise().sum() / kRows;
    double best = std::numeric_limits<double>::infinity();
    for (int round = 1; round <= kRounds; ++round) {
      int triangle = 0, corner = 0;
      against.minCoeff(&triangle);
      total += distance.col(triangle);
      best = std::min(best, total.maxCoeff(&corner) / round);
      if (round == 1) against.setZero();
      against += distance.row(corner);
    }
    return best;
  }

  const std::array<Eigen::Vector3d, Corners> corners_;
  const TriangleBvh& surface_;
  Eigen::Matrix<double, kRows, kColumns> distance_;           // per corner (row) and triangle (column)
  double nearest_ = std::numeric_limits<double>::infinity();  // least over the triangles of the largest distance from a corner
  std::array<int, MostTriangles> triangles_{};
  std::size_t count_ = 0;
};

}  // namespace collision_hulls
