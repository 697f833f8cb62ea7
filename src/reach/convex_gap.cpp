// Finds the point of the bodies' Minkowski difference that is nearest to the origin:
//
//   v = any point of the difference
//   until the support plane against v proves almost |v|:
//     add its support point to the simplex; v = the simplex's point nearest to the origin; keep the triangle that contains v
//
// Usually a dozen steps, each linear in the number of points.
#include "reach/convex_gap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "collision_hulls/geometry/triangle_bvh.h"

namespace collision_hulls {
namespace {

constexpr double kGap = 1e-6;        // of the distance
constexpr double kTouching = 1e-12;  // of the bodies' size: bodies nearer than this touch
constexpr double kFlat = 1e-13;      // of the bodies' size cubed: volume of a degenerate tetrahedron
constexpr int kMostSteps = 100;

using Triangle3 = std::array<Eigen::Vector3d, 3>;

/// The support point of a - b against `direction`.
Eigen::Vector3d furthestAgainst(const Eigen::Ref<const PointMatrix>& a, const Eigen::Ref<const PointMatrix>& b,
                                const Eigen::Vector3d& direction) {
  Eigen::Index i = 0, k = 0;
  (direction.transpose() * a).minCoeff(&i);
  (direction.transpose() * b).maxCoeff(&k);
  return a.col(i) - b.col(k);
}

double volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return a.dot(b.cross(c));
}

/// Whether the tetrahedron of a triangle and a point contains the origin: putting it in place of any corner keeps the volume's sign.
bool holdsOrigin(const Triangle3& t, const Eigen::Vector3d& w, double size) {
  const double whole = volume(t[0] - w, t[1] - w, t[2] - w);
  if (std::abs(whole) <= kFlat * size * size * size) return false;
  const std::array<double, 4> parts{volume(t[0], t[1], t[2]), -volume(w, t[1], t[2]), volume(w, t[0], t[2]), -volume(w, t[0], t[1])};
  return std::all_of(parts.begin(), parts.end(), [&](double part) { return part / whole >= 0; });
}

/// The point of the tetrahedron's surface nearest to the origin; `triangle` becomes the face that contains it.
Eigen::Vector3d nearestOnSurface(Triangle3& triangle, const Eigen::Vector3d& w) {
  const Triangle3 old = triangle;
  Eigen::Vector3d best = closestPoint(old[0], old[1], old[2], Eigen::Vector3d::Zero());
  for (std::size_t left_out = 0; left_out < 3; ++left_out) {
    Triangle3 face = old;
    face[left_out] = w;
    const Eigen::Vector3d v = closestPoint(face[0], face[1], face[2], Eigen::Vector3d::Zero());
    if (v.squaredNorm() < best.squaredNorm()) best = v, triangle = face;
  }
  return best;
}

}  // namespace

Gap convexGap(const Eigen::Ref<const PointMatrix>& a, const Eigen::Ref<const PointMatrix>& b, double enough) {
  const double size = std::max((a.colwise() - a.col(0)).cwiseAbs().maxCoeff(), (b.colwise() - b.col(0)).cwiseAbs().maxCoeff());
  Eigen::Vector3d v = a.col(0) - b.col(0);
  Triangle3 triangle{v, v, v};
  Gap gap;
  gap.at_most = v.norm();
  for (int step = 0; step < kMostSteps && gap.at_most > kTouching * size; ++step) {
    const Eigen::Vector3d w = furthestAgainst(a, b, v);
    const double apart = v.dot(w) / gap.at_most;
    if (apart > gap.at_least) gap.at_least = apart, gap.direction = v / gap.at_most;
    if (gap.at_least >= enough || gap.at_least >= (1 - kGap) * gap.at_most) break;
    if (holdsOrigin(triangle, w, size)) return {0, 0, Eigen::Vector3d::Zero()};
    v = nearestOnSurface(triangle, w);
    if (v.norm() >= gap.at_most) break;  // as near as rounding allows
    gap.at_most = v.norm();
  }
  return gap;
}

}  // namespace collision_hulls
