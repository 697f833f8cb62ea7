// Tries the normals of the largest hull faces, the coordinate axes and the principal axes as one direction of the box, and finds the
// smallest rectangle across each exactly by rotating calipers: O(n log n) per direction. An exact search (O'Rourke 1985) would take O(n^3).
#include "decompose/bounding_box.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/looks.h"
#include "decompose/outline.h"

namespace collision_hulls {

namespace {

// Vertex projections that one search may spend; hulls of up to 2,000 vertices can try 500 faces or more.
constexpr std::size_t kMostProjections = 1'000'000;
constexpr std::size_t kLeastDirections = 20;

struct OrientedBox {
  Eigen::Matrix3d axes;  // columns
  Eigen::Vector3d low, high;
  double volume() const { return (high - low).prod(); }
};

/// The direction of a side of the smallest rectangle around a convex outline; one of its sides is flush with an edge. Rotating calipers:
/// the furthest corners along, across and against an edge advance together with the edge.
Eigen::Vector2d smallestRectangle(const Outline& corners) {
  const std::size_t n = corners.size();
  std::array<std::size_t, 3> far{1, 1, 1};
  Eigen::Vector2d best = Eigen::Vector2d::UnitX();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d side = (corners[(i + 1) % n] - corners[i]).normalized(), across(-side.y(), side.x());
    const std::array<Eigen::Vector2d, 3> directions{side, across, -side};
    for (std::size_t k = 0; k < 3; ++k) {
      if (k > 0 && i == 0) far[k] = far[k - 1];
      for (std::size_t step = 0; step < n && directions[k].dot(corners[(far[k] + 1) % n] - corners[far[k]]) > 0; ++step)
        far[k] = (far[k] + 1) % n;
    }
    const double area = side.dot(corners[far[0]] - corners[far[2]]) * across.dot(corners[far[1]] - corners[i]);
    if (area < least) least = area, best = side;
  }
  return best;
}

OrientedBox boxAlong(const std::vector<Eigen::Vector3d>& points, const Eigen::Matrix3d& axes) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(Eigen::Vector3d(axes.transpose() * p));
  return {axes, box.min(), box.max()};
}

/// The smallest box with a side normal to `direction`.
OrientedBox boxAcross(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d u = direction.unitOrthogonal(), v = direction.cross(u);
  std::vector<Eigen::Vector2d> flat;
  flat.reserve(points.size());
  for (const Eigen::Vector3d& p : points) flat.emplace_back(u.dot(p), v.dot(p));
  const Eigen::Vector2d side = smallestRectangle(outlineOf(std::move(flat)));
  const Eigen::Vector3d x = side.x() * u + side.y() * v;
  Eigen::Matrix3d axes;
  axes << x, direction.cross(x), direction;
  return boxAlong(points, axes);
}

/// Face normals, largest triangle first, each direction once.
std::vector<Eigen::Vector3d> faceNormals(const ConvexHull& hull, std::size_t most) {
  std::vector<std::pair<double, Eigen::Vector3d>> normals;
  for (const Triangle& t : hull.triangles) {
    const Eigen::Vector3d& a = hull.vertices[t[0]];
    const Eigen::Vector3d twice_area = (hull.vertices[t[1]] - a).cross(hull.vertices[t[2]] - a);
    if (twice_area.norm() > 0) normals.emplace_back(twice_area.norm(), twice_area.normalized());
  }
  std::stable_sort(normals.begin(), normals.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Eigen::Vector3d> result;
  for (const auto& [area, normal] : normals) {
    if (result.size() == most) break;
    constexpr double kSame = 1e-12;
    const auto same = [&n = normal](const Eigen::Vector3d& other) { return std::abs(n.dot(other)) > 1 - kSame; };
    if (std::none_of(result.begin(), result.end(), same)) result.push_back(normal);
  }
  return result;
}

std::vector<Eigen::Vector3d> corners(const OrientedBox& box, const Eigen::Vector3d& middle) {
  std::vector<Eigen::Vector3d> result;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d local(k & 1 ? box.high.x() : box.low.x(), k & 2 ? box.high.y() : box.low.y(), k & 4 ? box.high.z() : box.low.z());
    result.push_back(middle + box.axes * local);
  }
  return result;
}

}  // namespace

ConvexHull orientedBox(const ConvexHull& hull, const RunControl& control) {
  const Eigen::Vector3d middle = boundingBox(hull).center();
  std::vector<Eigen::Vector3d> points = hull.vertices;
  for (Eigen::Vector3d& p : points) p -= middle;
  std::vector<Eigen::Vector3d> directions = faceNormals(hull, std::max(kLeastDirections, kMostProjections / points.size()));
  const Eigen::Matrix3d principal = principalAxes(points);
  for (int k = 0; k < 3; ++k) directions.insert(directions.end(), {Eigen::Vector3d::Unit(k), principal.col(k)});
  const OrientedBox along_axes = boxAlong(points, Eigen::Matrix3d::Identity());
  OrientedBox best = along_axes;
  for (const Eigen::Vector3d& direction : directions) {
    control.check();
    const OrientedBox box = boxAcross(points, direction);
    if (box.volume() < best.volume()) best = box;
  }
  // Around a hull that is hardly larger than what its coordinates are rounded by, only a box along the axes is sure to hold it.
  std::optional<ConvexHull> result = hullHolding(corners(best, middle), hull.vertices, control);
  if (!result) result = hullHolding(corners(along_axes, middle), hull.vertices, control);
  if (!result) throw Error(ErrorCode::kInternal, "an oriented box does not contain the hull it was built around");
  result->thickness = std::max(result->thickness, hull.thickness);
  return *result;
}

Eigen::Matrix3d principalAxes(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) covariance += (p - mean) * (p - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
}

std::optional<ConvexHull> hullHolding(std::vector<Eigen::Vector3d> corners, const std::vector<Eigen::Vector3d>& held,
                                      const RunControl& control) {
  Looks look(control, kLargeItemsBetweenLooks);
  constexpr int kTries = 8;
  constexpr double kMostGrowth = 1e-6;  // as a share of the size; larger excesses are not due to rounding
  for (int k = 0; k < kTries; ++k) {
    ConvexHull hull = convexHull(corners, control);
    double excess = 0;
    for (const Eigen::Vector3d& p : held) look(), excess = std::max(excess, planeDistance(hull, p));
    if (excess <= 0) return hull;
    const Eigen::Vector3d middle = boundingBox(hull).center();
    const double depth = -planeDistance(hull, middle);
    if (!(depth > 0) || excess > kMostGrowth * boundingBox(hull).diagonal().norm()) return std::nullopt;
    for (Eigen::Vector3d& c : corners) c += (c - middle) * (2 * excess / depth);
  }
  return std::nullopt;
}

}  // namespace collision_hulls
