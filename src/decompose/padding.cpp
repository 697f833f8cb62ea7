// The points within a distance r of a hull H are H with a ball at each of its points. A polyhedron about the ball in the ball's place gives
// a polyhedron again: the hull of that polyhedron's corners at each vertex of H. The nearer the polyhedron is to the ball, the less is
// added where H is sharp; its faces add nothing, as each is moved by r alone. Most of what is added comes from the limit on vertices.
//
// Whether a hull holds H with its ball is seen from its faces, whatever made it: each must lie r beyond all vertices of H.
//
// Tried and given up: moving each vertex beyond the planes of its faces, moved by r, with balls at the sharpest vertices alone. It needs no
// further limit on vertices, but hulls then reach up to half of r too far.
#include "decompose/padding.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "collision_hulls/decompose/round_outward.h"

namespace collision_hulls {
namespace {

constexpr double kRounding = 1e-12;  // of the coordinates' size
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

}  // namespace

ConvexHull padded(const ConvexHull& hull, double padding, int max_vertices) {
  static const std::vector<Eigen::Vector3d> ball = aboutTheBall();
  const double radius = padding + 4 * kRounding * (sizeOf(hull) + padding);
  std::vector<Eigen::Vector3d> points;
  points.reserve(hull.vertices.size() * ball.size());
  for (const Eigen::Vector3d& vertex : hull.vertices)
    for (const Eigen::Vector3d& corner : ball) points.push_back(vertex + radius * corner);
  return roundOutward({convexHull(points)}, TriangleMesh(), 0, max_vertices).hulls.front();
}

bool holdsPadding(const ConvexHull& outer, const ConvexHull& inner, double padding) {
  const double rounding = kRounding * sizeOf(outer);
  return std::all_of(outer.faces.begin(), outer.faces.end(), [&](const HalfSpace& face) {
    return std::all_of(inner.vertices.begin(), inner.vertices.end(),
                       [&](const Eigen::Vector3d& v) { return face.distance(v) <= rounding - padding; });
  });
}

}  // namespace collision_hulls
