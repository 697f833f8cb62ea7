// Which lids close an opening does not matter to the winding number, but small ones are told from afar at less cost: an opening is divided
// along its shortest diagonals into parts of few edges, each of which gets a cone of triangles. What runs there and back, such as an
// unstitched seam, is zipped up; a round opening gets small lids at its rim and larger ones toward the middle. O(n log n) for n edges.
#include "measure/lids.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "base/looks.h"
#include "geometry/segment_distance.h"

namespace collision_hulls {

namespace {

constexpr double kApexAside = 0.05;      // as a share of a part's extent
constexpr std::size_t kEdgesOfRest = 6;  // an opening of this many edges or fewer is not divided

/// [m] An upper bound on the distance of the loop, and of any surface spanning it, from a segment along which the loop runs there and back.
double widthOf(const std::vector<Eigen::Vector3d>& vertices, const Loop& loop) {
  const auto at = [&](int v) -> const Eigen::Vector3d& { return vertices[static_cast<std::size_t>(v)]; };
  const auto furthestFrom = [&](int v) {
    return *std::max_element(loop.begin(), loop.end(), [&](int a, int b) { return (at(a) - at(v)).norm() < (at(b) - at(v)).norm(); });
  };
  const int end = furthestFrom(loop[0]);
  const int other = furthestFrom(end);
  double squared = 0;
  for (const int v : loop) squared = std::max(squared, squaredSegmentDistance(at(v), at(end), at(other)));
  return std::sqrt(squared);
}

/// A loop that is shortened by cutting off three edges at a time, those whose ends are nearest to each other.
class Shortening {
 public:
  Shortening(const std::vector<Eigen::Vector3d>& vertices, const Loop& loop, Looks& look)
      : vertices_(vertices), loop_(loop), look_(look), next_(loop.size()), before_(loop.size()), left_(loop.size()) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t next = (i + 1) % loop.size();
      next_[i] = next, before_[next] = i;
    }
  }

  /// Loops of four edges, and one of at most kEdgesOfRest. Their edges are the loop's, and diagonals that two of them use in opposite
  /// directions.
  std::vector<Loop> parts() {
    std::vector<Loop> parts;
    std::size_t first = 0;
    if (left_ > kEdgesOfRest)
      for (std::size_t i = 0; i < loop_.size(); ++i) propose(i);
    while (left_ > kEdgesOfRest) {
      look_();
      const Cut cut = cuts_.top();
      cuts_.pop();
      if (cut.corners != from(cut.corners[0])) continue;  // another cut took one of its edges
      const auto [a, b, c, d] = cut.corners;
      parts.push_back({loop_[a], loop_[b], loop_[c], loop_[d]});
      next_[a] = d, before_[d] = a;
      next_[b] = b;  // so that nothing begins there any more
      next_[c] = c;
      left_ -= 2;
      first = a;
      for (std::size_t i = a, k = 0; k < 3; ++k, i = before_[i]) propose(i);
    }
    Loop rest;
    for (std::size_t i = first; rest.size() < left_; i = next_[i]) rest.push_back(loop_[i]);
    parts.push_back(std::move(rest));
    return parts;
  }

 private:
  struct Cut {
    double length;  // [m] of the diagonal from the first of the corners to the last
    std::array<std::size_t, 4> corners;
    bool operator<(const Cut& other) const { return length > other.length || (!(length < other.length) && corners[0] > other.corners[0]); }
  };

  std::array<std::size_t, 4> from(std::size_t i) const {
    const std::size_t b = next_[i], c = next_[b];
    return {i, b, c, next_[c]};
  }

  void propose(std::size_t i) {
    look_();
    const std::array<std::size_t, 4> corners = from(i);
    cuts_.push({(at(corners[3]) - at(corners[0])).norm(), corners});
  }

  const Eigen::Vector3d& at(std::size_t i) const { return vertices_[static_cast<std::size_t>(loop_[i])]; }

  const std::vector<Eigen::Vector3d>& vertices_;
  const Loop& loop_;
  Looks& look_;
  std::vector<std::size_t> next_, before_;
  std::size_t left_;
  std::priority_queue<Cut> cuts_;  // the shortest first
};

/// Adds a cone with its apex near the loop's middle, but off the plane that the loop may lie in, where queries are most frequent.
void addCone(const Loop& loop, Lids& lids) {
  const Eigen::Vector3d aside = Eigen::Vector3d(0.6180339887, -0.4142135624, 0.7320508076).normalized();
  Eigen::AlignedBox3d box;
  for (const int v : loop) box.extend(lids.vertices[static_cast<std::size_t>(v)]);
  const int apex = static_cast<int>(lids.vertices.size());
  lids.vertices.push_back(box.center() + kApexAside * box.diagonal().norm() * aside);
  for (std::size_t i = 0; i < loop.size(); ++i) lids.of_openings.push_back({loop[(i + 1) % loop.size()], loop[i], apex});
}

}  // namespace

Lids lidsOf(const TriangleMesh& mesh, const Rim& rim, const RunControl& control) {
  Lids lids;
  if (rim.empty()) return lids;
  lids.vertices = mesh.vertices;
  const double widest_crack = RepairOptions{}.weld_tolerance * boundingBox(mesh).sizes().maxCoeff();
  Looks look(control);
  for (const Loop& loop : loopsOf(mesh.vertices, rim, control)) {
    const double width = widthOf(mesh.vertices, loop);
    if (width <= widest_crack) {
      for (std::size_t i = 2; i < loop.size(); ++i) look(), lids.of_cracks.push_back({loop[i], loop[i - 1], loop[0]});
      lids.crack_width = std::max(lids.crack_width, width);
      continue;
    }
    for (std::size_t i = 0; i < loop.size(); ++i) look(), lids.rim_of_openings.push_back({loop[i], loop[(i + 1) % loop.size()]});
    for (const Loop& part : Shortening(mesh.vertices, loop, look).parts()) look(), addCone(part, lids);
  }
  return lids;
}

}  // namespace collision_hulls
