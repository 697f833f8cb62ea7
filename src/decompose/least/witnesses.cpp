// Farthest-point sampling (Gonzalez, "Clustering to minimize the maximum intercluster distance", 1985), in O(count * choice).
#include "decompose/least/witnesses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace collision_hulls {

namespace {

/// As a mesh that was read may have several vertices in one place, up to six for each that is wanted are looked at.
Points someVertices(const TriangleMesh& mesh, std::size_t most) {
  const std::size_t corners = 3 * mesh.triangles.size(), stride = std::max<std::size_t>(1, corners / (6 * most));
  Points points;
  for (std::size_t i = 0; i < corners; i += stride) points.push_back(mesh.corner(static_cast<int>(i / 3), static_cast<int>(i % 3)));
  const auto before = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() <= most) return points;
  Points thinned;
  for (std::size_t i = 0; i < most; ++i) thinned.push_back(points[i * points.size() / most]);
  return thinned;
}

/// Spread over the triangles in proportion to their areas, by the additive sequence of the plastic number.
void addByArea(const TriangleMesh& mesh, std::size_t count, Points& points) {
  constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;
  const double each = area(mesh) / static_cast<double>(count);
  double due = 0, u = 0.5, v = 0.5;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()) && each > 0; ++t) {
    const Eigen::Vector3d &a = mesh.corner(t, 0), along = mesh.corner(t, 1) - a, across = mesh.corner(t, 2) - a;
    for (due += along.cross(across).norm() / 2; due >= each; due -= each) {
      u = std::fmod(u + kFirst, 1), v = std::fmod(v + kSecond, 1);
      const bool beyond = u + v > 1;
      points.push_back(a + (beyond ? 1 - u : u) * along + (beyond ? 1 - v : v) * across);
    }
  }
}

/// Takes the point that is furthest from those taken so far.
class Spreading {
 public:
  explicit Spreading(Points points) : points_(std::move(points)), squared_(points_.size(), std::numeric_limits<double>::infinity()) {}

  void tell(const Eigen::Vector3d& taken) {
    for (std::size_t i = 0; i < points_.size(); ++i) squared_[i] = std::min(squared_[i], (points_[i] - taken).squaredNorm());
  }

  /// Null if there is none left.
  const Eigen::Vector3d* furthest() const {
    const auto found = std::max_element(squared_.begin(), squared_.end());
    return found == squared_.end() || *found <= 0 ? nullptr : &points_[static_cast<std::size_t>(found - squared_.begin())];
  }

 private:
  const Points points_;
  std::vector<double> squared_;  // distance to the nearest point that was taken
};

}  // namespace

SurfacePoints surfacePoints(const TriangleMesh& mesh, std::size_t count) {
  SurfacePoints points{someVertices(mesh, count)};
  points.vertices = points.all.size();
  addByArea(mesh, count, points.all);
  return points;
}

Points ownPoints(const Points& points, const std::vector<ConvexHull>& hulls) {
  if (hulls.size() < 2) return {};
  Points own(hulls.size());
  std::vector<double> furthest(hulls.size());  // from other hulls, in terms of planeDistance()
  for (const Eigen::Vector3d& p : points) {
    double least = std::numeric_limits<double>::infinity(), second = least;
    std::size_t nearest = 0;
    for (std::size_t h = 0; h < hulls.size(); ++h) {
      const double distance = planeDistance(hulls[h], p);
      if (distance < least)
        second = least, least = distance, nearest = h;
      else
        second = std::min(second, distance);
      if (second <= 0) break;
    }
    if (second > furthest[nearest]) furthest[nearest] = second, own[nearest] = p;
  }
  Points result;
  for (std::size_t h = 0; h < hulls.size(); ++h)
    if (furthest[h] > 0) result.push_back(own[h]);
  return result;
}

Points spreadOf(const Points& points, std::size_t most) {
  if (points.size() <= most) return points;
  Spreading others(points);
  Points chosen;
  while (chosen.size() < most) {
    const Eigen::Vector3d* const next = others.furthest();
    if (!next) break;
    chosen.push_back(*next);
    others.tell(chosen.back());
  }
  return chosen;
}

void addSpread(const SurfacePoints& points, std::size_t count, Points& chosen) {
  Spreading vertices({points.all.begin(), points.all.begin() + static_cast<std::ptrdiff_t>(points.vertices)}), everywhere(points.all);
  const auto tell = [&](const Eigen::Vector3d& p) { vertices.tell(p), everywhere.tell(p); };
  for (const Eigen::Vector3d& p : chosen) tell(p);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d* const next = (i % 2 == 0 ? vertices : everywhere).furthest();
    if (!next) continue;
    chosen.push_back(*next);
    tell(chosen.back());
  }
}

}  // namespace collision_hulls
