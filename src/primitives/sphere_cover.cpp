// A piece of a triangle with all corners in one sphere is covered, since balls are convex. Any other is halved at its longest edge, unless
// its middle is in no sphere, less a little depth: then that is a gap. So the search ends: once a piece is shorter than the depth, its
// corners are in the sphere that holds its middle.
#include "primitives/sphere_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "base/parallel.h"

namespace collision_hulls {

namespace {

constexpr int kTrianglesOfBlock = 64;                      // consecutive ones share a selection of spheres
constexpr std::size_t kMostGaps = 20'000, kLeastGaps = 4;  // in all, and of some triangles: no more are sought
constexpr double kRadiusRounding = 1e-12;                  // of the coordinates' size: by how much radii are lowered

using Corners = std::array<Eigen::Vector3d, 3>;

/// The search over some triangles.
class Gaps {
 public:
  Gaps(const std::vector<Sphere>& spheres, const CoverSearch& search, double rounding, std::size_t most)
      : spheres_(spheres), search_(search), rounding_(rounding), most_(most) {}

  /// Those that the box meets.
  void select(const Eigen::AlignedBox3d& box) {
    near_.clear();
    for (std::size_t s = 0; s < spheres_.size(); ++s)
      if (box.exteriorDistance(spheres_[s].centre) <= spheres_[s].radius) near_.push_back(s);
  }

  void search(const Corners& piece) { search(piece, 0, near_.size()); }

  std::vector<Eigen::Vector3d> found;

 private:
  bool holds(std::size_t sphere, const Eigen::Vector3d& p, double depth) const {
    const double radius = spheres_[sphere].radius - depth - rounding_;
    return radius >= 0 && (p - spheres_[sphere].centre).squaredNorm() <= radius * radius;
  }

  /// near_[begin, end): the spheres that the piece may meet.
  void search(const Corners& piece, std::size_t begin, std::size_t end) {
    if (found.size() >= most_) return;
    for (std::size_t i = begin; i < end; ++i)
      if (holds(near_[i], piece[0], 0) && holds(near_[i], piece[1], 0) && holds(near_[i], piece[2], 0)) return;
    const Eigen::Vector3d middle = (piece[0] + piece[1] + piece[2]) / 3;
    std::size_t a = 0;
    const auto length = [&](std::size_t k) { return (piece[k] - piece[(k + 1) % 3]).norm(); };
    for (std::size_t k = 1; k < 3; ++k)
      if (length(k) > length(a)) a = k;
    const std::size_t last = near_.size();
    bool held = false;
    for (std::size_t i = begin; i < end; ++i) {
      if (holds(near_[i], middle, -length(a))) near_.push_back(near_[i]);
      held = held || holds(near_[i], middle, search_.depth);
    }
    if (!held && (length(a) <= search_.grain || near_.size() == last)) {
      found.push_back(middle);
    } else {
      const std::size_t b = (a + 1) % 3, narrowed = near_.size();
      Corners one = piece, other = piece;
      one[b] = other[a] = (piece[a] + piece[b]) / 2;
      search(one, last, narrowed);
      search(other, last, narrowed);
    }
    near_.resize(last);
  }

  const std::vector<Sphere>& spheres_;
  const CoverSearch search_;
  const double rounding_;
  const std::size_t most_;
  std::vector<std::size_t> near_;  // as a stack: of the current piece and those that it is part of
};

}  // namespace

std::vector<Eigen::Vector3d> gapsIn(const TriangleMesh& mesh, const std::vector<Sphere>& spheres, const CoverSearch& search,
                                    const RunControl& control) {
  const Eigen::AlignedBox3d all = boundingBox(mesh);
  const double rounding = all.isEmpty() ? 0 : kRadiusRounding * all.min().cwiseAbs().cwiseMax(all.max().cwiseAbs()).maxCoeff();
  const int triangles = static_cast<int>(mesh.triangles.size()), blocks = (triangles + kTrianglesOfBlock - 1) / kTrianglesOfBlock;
  std::vector<std::vector<Eigen::Vector3d>> found(static_cast<std::size_t>(blocks));
  forEach(found.size(), [&](std::size_t block) {
    control.check();
    const int begin = static_cast<int>(block) * kTrianglesOfBlock, end = std::min(begin + kTrianglesOfBlock, triangles);
    Eigen::AlignedBox3d box;
    for (int t = begin; t < end; ++t) box.extend(mesh.corner(t, 0)).extend(mesh.corner(t, 1)).extend(mesh.corner(t, 2));
    Gaps gaps(spheres, search, rounding, std::max(kLeastGaps, kMostGaps / found.size()));
    gaps.select(box);
    for (int t = begin; t < end; ++t) gaps.search({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
    found[block] = std::move(gaps.found);
  });
  std::vector<Eigen::Vector3d> result;
  for (std::vector<Eigen::Vector3d>& part : found) std::move(part.begin(), part.end(), std::back_inserter(result));
  return result;
}

}  // namespace collision_hulls
