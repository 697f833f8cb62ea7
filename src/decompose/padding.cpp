// The points within a distance r of a hull H are H with a ball at each of its points. Two ways make a polyhedron about them, and the one
// that adds less is taken:
// - A polyhedron about the ball in the ball's place gives a polyhedron again: the hull of that polyhedron's corners at each vertex of H. It
//   adds next to nothing, but has many vertices; to take them away again costs little while r is large beside H.
// - Each vertex of H moves beyond the planes of its faces, once they are moved by r. It needs no further vertices and adds little where the
//   faces at a vertex lean little towards each other: at round hulls.
//
// Whether a hull holds H with its ball is seen from its faces, whatever made it: each must lie r beyond all vertices of H.
#include "decompose/padding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "collision_hulls/decompose/reduce_vertices.h"
#include "collision_hulls/decompose/round_outward.h"

namespace collision_hulls {
namespace {

constexpr double kRounding = 1e-12;  // of the coordinates' size
constexpr double kLeastShare = 0.5;  // of the way of a moved vertex that leads away from each of its faces
constexpr int kSteps = 50;           // towards the middle of the normals of a vertex
constexpr int kParts = 4;            // that each edge of an icosahedron is divided into: 162 corners

/// An icosahedron's vertices, of length 1.
std::vector<Eigen::Vector3d> icosahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  std::vector<Eigen::Vector3d> corners;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden, golden})
      for (int axis = 0; axis < 3; ++axis) {
        Eigen::Vector3d corner = Eigen::Vector3d::Zero();
        corner[axis] = a;
        corner[(axis + 1) % 3] = b;
        corners.push_back(corner.normalized());
      }
  }
  return corners;
}

/// The corners of a polyhedron that holds the ball of radius 1 and little more.
std::vector<Eigen::Vector3d> aboutTheBall() {
  const ConvexHull coarse = convexHull(icosahedron());
  std::vector<Eigen::Vector3d> points;
  for (const Triangle& t : coarse.triangles) {
    const auto corner = [&](std::size_t k) { return coarse.vertices[static_cast<std::size_t>(t[k])]; };
    for (int i = 0; i <= kParts; ++i)
      for (int j = 0; i + j <= kParts; ++j) points.push_back((i * corner(0) + j * corner(1) + (kParts - i - j) * corner(2)).normalized());
  }
  const ConvexHull fine = convexHull(points);
  double least = 1;
  for (const HalfSpace& face : fine.faces) least = std::min(least, face.offset);
  std::vector<Eigen::Vector3d> corners = fine.vertices;
  for (Eigen::Vector3d& corner : corners) corner /= least;
  return corners;
}

double sizeOf(const ConvexHull& hull) {
  const Eigen::AlignedBox3d box = boundingBox(hull);
  return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

std::vector<Eigen::Vector3d> withBalls(const ConvexHull& hull, double radius) {
  static const std::vector<Eigen::Vector3d> ball = aboutTheBall();
  std::vector<Eigen::Vector3d> points;
  points.reserve(hull.vertices.size() * ball.size());
  for (const Eigen::Vector3d& vertex : hull.vertices)
    for (const Eigen::Vector3d& corner : ball) points.push_back(vertex + radius * corner);
  return points;
}

/// The middle of the smallest ball about unit vectors, approximately (Badoiu & Clarkson 2003): what leans least away from any of them.
Eigen::Vector3d middleOf(const std::vector<Eigen::Vector3d>& normals) {
  Eigen::Vector3d middle = normals.front();
  for (int i = 1; i <= kSteps; ++i) {
    const auto furthest =
        std::min_element(normals.begin(), normals.end(), [&](const auto& a, const auto& b) { return a.dot(middle) < b.dot(middle); });
    middle += (*furthest - middle) / (i + 1);
  }
  return middle;
}

/// Each vertex moved beyond the planes of its faces, moved by `radius`; none if that is too far.
std::vector<Eigen::Vector3d> withMovedVertices(const ConvexHull& hull, double radius) {
  std::vector<std::vector<Eigen::Vector3d>> normals(hull.vertices.size());
  for (const Triangle& t : hull.triangles) {
    const auto corner = [&](std::size_t k) { return hull.vertices[static_cast<std::size_t>(t[k])]; };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    for (const int v : t) normals[static_cast<std::size_t>(v)].push_back(normal);
  }
  std::vector<Eigen::Vector3d> points;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Eigen::Vector3d middle = middleOf(normals[v]);
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& normal : normals[v]) least = std::min(least, normal.dot(middle));
    if (!(least > kLeastShare * middle.norm())) return {};
    points.push_back(hull.vertices[v] + radius / least * middle);
  }
  return points;
}

}  // namespace

ConvexHull padded(const ConvexHull& hull, double padding, int max_vertices, const RunControl& control) {
  const double radius = padding + 4 * kRounding * (sizeOf(hull) + padding);
  const auto written = [&](const std::vector<Eigen::Vector3d>& points) {
    return roundOutward({convexHull(points, control)}, TriangleMesh(), 0, max_vertices, control).hulls.front();
  };
  const ConvexHull rounder = written(withBalls(hull, radius));
  if (max_vertices == 0) return rounder;
  const std::vector<Eigen::Vector3d> moved = withMovedVertices(hull, radius);
  if (moved.empty()) return rounder;
  const ConvexHull sharper = written(moved);
  return holdsPadding(sharper, hull, padding) && addedDistance(sharper, hull, control) < addedDistance(rounder, hull, control) ? sharper
                                                                                                                               : rounder;
}

bool holdsPadding(const ConvexHull& outer, const ConvexHull& inner, double padding) {
  const double rounding = kRounding * sizeOf(outer);
  return std::all_of(outer.faces.begin(), outer.faces.end(), [&](const HalfSpace& face) {
    return std::all_of(inner.vertices.begin(), inner.vertices.end(),
                       [&](const Eigen::Vector3d& v) { return face.distance(v) <= rounding - padding; });
  });
}

}  // namespace collision_hulls
