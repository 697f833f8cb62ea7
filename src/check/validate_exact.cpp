// Brute-force distances between triangles, hulls and points, in double precision. A triangle meets a body if clipping it by all the body's
// faces leaves something.
#include "check/validate_exact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "collision_hulls/geometry/triangle_bvh.h"

namespace collision_hulls {

namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

Corners corners(const TriangleMesh& mesh, int triangle) {
  return {mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)};
}

/// Squared distance between the segments ab and cd (Ericson, Real-Time Collision Detection, 5.1.9). Either may be a point.
double squaredSegmentDistance(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  const Eigen::Vector3d u = b - a, v = d - c, r = a - c;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), ur = u.dot(r), vr = v.dot(r);
  const auto clamp01 = [](double x) { return std::min(std::max(x, 0.0), 1.0); };
  const double cross = uu * vv - uv * uv;
  double s = cross > 0 ? clamp01((uv * vr - ur * vv) / cross) : 0;
  double t = vv > 0 ? (uv * s + vr) / vv : 0;
  if (t < 0 || t > 1 || vv == 0) {
    t = clamp01(t);
    s = uu > 0 ? clamp01((uv * t - ur) / uu) : 0;
  }
  return (r + u * s - v * t).squaredNorm();
}

/// Squared distance between two triangles that do not intersect: attained between two edges, or a corner and a face.
double squaredTriangleDistance(const Corners& a, const Corners& b) {
  double least = kFurthest;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) least = std::min(least, squaredSegmentDistance(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
    least = std::min(least, (closestPoint(b[0], b[1], b[2], a[i]) - a[i]).squaredNorm());
    least = std::min(least, (closestPoint(a[0], a[1], a[2], b[i]) - b[i]).squaredNorm());
  }
  return least;
}

/// The part of a polygon below a plane (Sutherland & Hodgman 1974).
std::vector<Eigen::Vector3d> clipped(const std::vector<Eigen::Vector3d>& polygon, const HalfSpace& face) {
  std::vector<Eigen::Vector3d> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double dp = face.distance(p), dq = face.distance(q);
    if (dp <= 0) result.push_back(p);
    if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) result.push_back(p + (q - p) * (dp / (dp - dq)));
  }
  return result;
}

/// A lower bound on the distance between a triangle and a body: how far the triangle lies beyond one of the body's planes; below 0 if it
/// does not.
double gapBetween(const Corners& triangle, const ConvexHull& body) {
  double most = -kFurthest;
  for (const HalfSpace& face : body.faces)
    most = std::max(most, std::min({face.distance(triangle[0]), face.distance(triangle[1]), face.distance(triangle[2])}));
  return most;
}

bool meets(const Corners& triangle, const ConvexHull& body) {
  std::vector<Eigen::Vector3d> polygon(triangle.begin(), triangle.end());
  for (const HalfSpace& face : body.faces) {
    polygon = clipped(polygon, face);
    if (polygon.empty()) return false;
  }
  return true;
}

}  // namespace

Eigen::Vector3d nearestPoint(const ConvexHull& hull, const Eigen::Vector3d& p) {
  if (planeDistance(hull, p) <= 0) return p;
  const TriangleMesh skin = surface(hull);
  Eigen::Vector3d nearest = hull.vertices[0];
  for (int t = 0; t < static_cast<int>(skin.triangles.size()); ++t) {
    const Eigen::Vector3d q = closestPoint(skin.corner(t, 0), skin.corner(t, 1), skin.corner(t, 2), p);
    if ((q - p).squaredNorm() < (nearest - p).squaredNorm()) nearest = q;
  }
  return nearest;
}

double pointDistance(const ConvexHull& hull, const Eigen::Vector3d& p) {
  return (nearestPoint(hull, p) - p).norm();
}

std::vector<Eigen::Vector3d> commonPoints(const ConvexHull& a, const ConvexHull& b) {
  std::vector<Eigen::Vector3d> points;
  for (const auto& [body, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const TriangleMesh skin = surface(*body);
    for (int t = 0; t < static_cast<int>(skin.triangles.size()); ++t) {
      std::vector<Eigen::Vector3d> polygon = {skin.corner(t, 0), skin.corner(t, 1), skin.corner(t, 2)};
      for (const HalfSpace& face : other->faces) polygon = clipped(polygon, face);
      points.insert(points.end(), polygon.begin(), polygon.end());
    }
  }
  if (points.empty()) return points;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) sum += p;
  points.push_back(sum / static_cast<double>(points.size()));
  return points;
}

double distanceToBody(const TriangleMesh& mesh, const ConvexHull& body, double limit) {
  const Eigen::AlignedBox3d box = boundingBox(body);
  const TriangleMesh skin = surface(body);
  double least = limit * limit;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Corners triangle = corners(mesh, t);
    const Eigen::AlignedBox3d triangle_box(triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]),
                                           triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]));
    if (triangle_box.squaredExteriorDistance(box) > least) continue;
    const double gap = gapBetween(triangle, body);
    if (gap > 0 && gap * gap > least) continue;
    if (gap <= 0 && meets(triangle, body)) return 0;
    for (int face = 0; face < static_cast<int>(skin.triangles.size()); ++face)
      least = std::min(least, squaredTriangleDistance(triangle, corners(skin, face)));
  }
  return std::sqrt(least);
}

double bodyDistance(const ConvexHull& a, const ConvexHull& b) {
  // Either some of a's surface is in b, or b is wholly inside a, or they are apart.
  if (planeDistance(a, b.vertices[0]) <= 0) return 0;
  return distanceToBody(surface(a), b);
}

bool proved(const FclAnswer& answer, const ConvexHull& first, const ConvexHull& second, double tolerance) {
  if (answer.status != FclAnswer::Status::kDistance || !(answer.distance > tolerance)) return false;
  const Eigen::Vector3d between = answer.on_second - answer.on_first;
  if (!(std::abs(between.norm() - answer.distance) <= tolerance)) return false;
  const Eigen::Vector3d axis = between.normalized();
  double highest = -kFurthest, lowest = kFurthest;
  for (const Eigen::Vector3d& v : first.vertices) highest = std::max(highest, axis.dot(v));
  for (const Eigen::Vector3d& v : second.vertices) lowest = std::min(lowest, axis.dot(v));
  return lowest - highest >= answer.distance - tolerance && planeDistance(first, answer.on_first) <= tolerance &&
         planeDistance(second, answer.on_second) <= tolerance;
}

}  // namespace collision_hulls
