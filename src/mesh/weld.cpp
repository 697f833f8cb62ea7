// A hash grid of the representatives. Its cells are much wider than the tolerance, so most queries look into one cell, and much smaller
// than the mesh, so few representatives share a cell. Buckets may mix cells: distances decide. Near-linear.
#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/looks.h"
#include "mesh/hash.h"

namespace collision_hulls {
namespace {

constexpr double kCellPerTolerance = 16;
constexpr double kSmallestCellPerExtent = 1e-6;

class Grid {
 public:
  Grid(const TriangleMesh& mesh, double tolerance) : vertices_(mesh.vertices), tolerance_(tolerance), next_(mesh.vertices.size(), -1) {
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    if (!box.isEmpty()) origin_ = box.min();
    const double extent = box.isEmpty() ? 0 : box.sizes().maxCoeff();
    const double cell = std::max(kCellPerTolerance * tolerance, kSmallestCellPerExtent * extent);
    per_cell_ = std::isnormal(cell) ? 1 / cell : 0;  // of smaller ones, the inverse is infinite
    std::size_t buckets = 64;
    while (buckets < vertices_.size()) buckets *= 2;
    head_.assign(buckets, -1);
  }

  /// The nearest representative within the tolerance, the earlier one on a tie; -1 if there is none.
  int nearest(const Eigen::Vector3d& p, double* distance) const {
    const Cell low = cellOf(p.array() - tolerance_);
    const Cell high = cellOf(p.array() + tolerance_);
    int best = -1;
    double best_squared = tolerance_ * tolerance_;
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z) search(bucket({x, y, z}), p, &best, &best_squared);
    *distance = std::sqrt(best_squared);
    return best;
  }

  void insert(int vertex) {
    int& head = head_[bucket(cellOf(vertices_[static_cast<std::size_t>(vertex)].array()))];
    next_[static_cast<std::size_t>(vertex)] = head;
    head = vertex;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cellOf(const Eigen::Array3d& p) const {
    const Eigen::Array3d cell = ((p - origin_.array()) * per_cell_).floor();
    return {static_cast<std::int64_t>(cell.x()), static_cast<std::int64_t>(cell.y()), static_cast<std::int64_t>(cell.z())};
  }

  std::size_t bucket(const Cell& cell) const { return bucketOf(cell, head_.size()); }

  void search(std::size_t bucket, const Eigen::Vector3d& p, int* best, double* best_squared) const {
    for (int v = head_[bucket]; v >= 0; v = next_[static_cast<std::size_t>(v)]) {
      const double squared = (vertices_[static_cast<std::size_t>(v)] - p).squaredNorm();
      if (squared < *best_squared || (squared == *best_squared && (*best < 0 || v < *best))) {
        *best = v;
        *best_squared = squared;
      }
    }
  }

  const std::vector<Eigen::Vector3d>& vertices_;
  double tolerance_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double per_cell_ = 0;
  std::vector<int> head_;  // per bucket: the representative inserted last
  std::vector<int> next_;  // per representative: the one inserted before it into the same bucket
};

}  // namespace

Welding weld(const TriangleMesh& mesh, double tolerance, const RunControl& control) {
  Welding result;
  result.representative.assign(mesh.vertices.size(), -1);
  Looks look(control);
  for (const Triangle& triangle : mesh.triangles) {
    look();
    for (const int v : triangle) result.representative[static_cast<std::size_t>(v)] = v;
  }

  Grid grid(mesh, tolerance);
  for (int& representative : result.representative) {
    look();
    if (representative < 0) continue;
    double distance = 0;
    const int earlier = grid.nearest(mesh.vertices[static_cast<std::size_t>(representative)], &distance);
    if (earlier < 0) {
      grid.insert(representative);
    } else {
      representative = earlier;
      ++result.joined;
      result.distance = std::max(result.distance, distance);
    }
  }
  return result;
}

}  // namespace collision_hulls
