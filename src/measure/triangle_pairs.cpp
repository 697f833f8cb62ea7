// Each case is proved by a plane. No common corner: a plane between the two triangles, normal to one of them, to two of their edges, or to
// one and an edge (if the triangles are disjoint there is one among these). One common corner: a plane through it with both triangles
// strictly on different sides. A common edge: the triangles are not folded onto each other. Corners are exact, so their differences are
// precise to the last digit, and the margins exceed what rounding can do to the few products that follow.
#include "measure/triangle_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace collision_hulls {

namespace {

constexpr double kAngleMargin = 1e-9;      // [rad] least angle between a triangle and the plane that shows it apart
constexpr double kDistanceMargin = 1e-12;  // least gap, as a share of the extent
constexpr double kNearlyParallel = 1e-6;   // unit vectors with a shorter cross product give no direction

using Corners = std::array<Eigen::Vector3d, 3>;

/// How many corners two triangles share, and for each triangle which of its corners comes first: a shared one if there is just one, the
/// one that is not shared if there are two.
struct Shared {
  int count = 0;
  std::size_t first = 0, second = 0;
};

Shared sharedCorners(const Triangle& t, const Triangle& u) {
  Shared shared;
  std::size_t sum_t = 0, sum_u = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (t[i] == u[j]) ++shared.count, sum_t += i, sum_u += j;
  shared.first = shared.count == 2 ? 3 - sum_t : sum_t;
  shared.second = shared.count == 2 ? 3 - sum_u : sum_u;
  return shared;
}

/// The gap between the triangles along a direction; negative if they overlap there.
double gapAlong(const Eigen::Vector3d& direction, const Corners& a, const Corners& b) {
  const auto range = [&](const Corners& c) { return std::minmax({direction.dot(c[0]), direction.dot(c[1]), direction.dot(c[2])}); };
  const auto [low_a, high_a] = range(a);
  const auto [low_b, high_b] = range(b);
  return std::max(low_b - high_a, low_a - high_b) / direction.norm();
}

Corners unitEdges(const Corners& c) {
  return {(c[1] - c[0]).normalized(), (c[2] - c[1]).normalized(), (c[0] - c[2]).normalized()};
}

bool areDisjoint(const Corners& a, const Corners& b, double margin) {
  const auto separates = [&](const Eigen::Vector3d& direction) {
    return direction.norm() > kNearlyParallel && gapAlong(direction, a, b) > margin;
  };
  const Corners edges_a = unitEdges(a), edges_b = unitEdges(b);
  const Eigen::Vector3d normal_a = edges_a[0].cross(edges_a[1]), normal_b = edges_b[0].cross(edges_b[1]);
  if (separates(normal_a) || separates(normal_b)) return true;
  for (const Eigen::Vector3d& e : edges_a)
    if (separates(normal_a.cross(e)) || separates(normal_b.cross(e))) return true;
  for (const Eigen::Vector3d& e : edges_b)
    if (separates(normal_a.cross(e)) || separates(normal_b.cross(e))) return true;
  for (const Eigen::Vector3d& e : edges_a)
    for (const Eigen::Vector3d& f : edges_b)
      if (separates(e.cross(f))) return true;
  return false;
}

/// Whether a plane through the origin has a1 and a2 strictly on one side, b1 and b2 strictly on the other. The best such plane touches one,
/// two or three of the cones about them.
bool areApartAtCorner(const Eigen::Vector3d& a1, const Eigen::Vector3d& a2, const Eigen::Vector3d& b1, const Eigen::Vector3d& b2) {
  const std::array<Eigen::Vector3d, 4> rays{a1.normalized(), a2.normalized(), -b1.normalized(), -b2.normalized()};
  const auto parts = [&](const Eigen::Vector3d& normal) {
    const double least = std::min({normal.dot(rays[0]), normal.dot(rays[1]), normal.dot(rays[2]), normal.dot(rays[3])});
    return least > kAngleMargin * normal.norm();
  };
  if (parts(rays[0] + rays[1] + rays[2] + rays[3])) return true;  // the usual case, quickly
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (parts(rays[i] + rays[j])) return true;
      for (std::size_t k = 0; k < j; ++k) {
        const Eigen::Vector3d normal = (rays[i] - rays[j]).cross(rays[j] - rays[k]);
        if (normal.norm() > kNearlyParallel && (parts(normal) || parts(-normal))) return true;
      }
    }
  return false;
}

/// Whether two triangles on an edge from the origin, with their third corners at a and b, are not folded onto each other.
bool areUnfolded(const Eigen::Vector3d& edge, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double margin) {
  const Eigen::Vector3d along = edge.normalized(), height_a = a - along * along.dot(a), height_b = b - along * along.dot(b);
  const double least = std::min(height_a.norm(), height_b.norm());
  return (height_a.normalized() - height_b.normalized()).norm() * least > margin;
}

}  // namespace

bool meetOnlyAsNeighbours(const TriangleMesh& mesh, int t, int u, double extent) {
  const double margin = kDistanceMargin * extent;
  const Shared shared = sharedCorners(mesh.triangles[static_cast<std::size_t>(t)], mesh.triangles[static_cast<std::size_t>(u)]);
  if (shared.count > 2) return false;
  if (shared.count == 0) {
    const Eigen::Vector3d origin = mesh.corner(t, 0);
    Corners a, b;
    for (std::size_t k = 0; k < 3; ++k)
      a[k] = mesh.corner(t, static_cast<int>(k)) - origin, b[k] = mesh.corner(u, static_cast<int>(k)) - origin;
    return areDisjoint(a, b, margin);
  }
  const auto ofT = [&](std::size_t step) -> const Eigen::Vector3d& { return mesh.corner(t, static_cast<int>((shared.first + step) % 3)); };
  const auto ofU = [&](std::size_t step) -> const Eigen::Vector3d& { return mesh.corner(u, static_cast<int>((shared.second + step) % 3)); };
  if (shared.count == 1) return areApartAtCorner(ofT(1) - ofT(0), ofT(2) - ofT(0), ofU(1) - ofT(0), ofU(2) - ofT(0));
  return areUnfolded(ofT(2) - ofT(1), ofT(0) - ofT(1), ofU(0) - ofT(1), margin);
}

}  // namespace collision_hulls
