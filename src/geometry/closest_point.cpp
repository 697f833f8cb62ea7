// Nearest point of a triangle: Ericson's classification of p by Voronoi regions of corners, edges and face. His barycentric areas cancel
// for slivers, so these take a slower path through the edges and a frame in their plane.
#include <algorithm>

#include "collision_hulls/geometry/triangle_bvh.h"

namespace collision_hulls {

namespace {

constexpr double kThin = 1e-6;  // a triangle whose squared height is below this share of its squared length is a sliver

Eigen::Vector3d closestOnEdge(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p) {
  const Eigen::Vector3d ab = b - a;
  const double along = ab.dot(p - a), length = ab.squaredNorm();
  return along <= 0 ? a : along >= length ? b : Eigen::Vector3d(a + ab * (along / length));
}

/// closestPoint() for triangles so thin that Ericson's areas are mere rounding: the best of the edges and the foot of the perpendicular
/// from p. The foot is found in a frame along the longest edge, where thinness blurs nothing but a rotation about that edge.
Eigen::Vector3d closestOnSliver(Eigen::Vector3d a, Eigen::Vector3d b, Eigen::Vector3d c, const Eigen::Vector3d& p) {
  while ((b - a).squaredNorm() < std::max((c - b).squaredNorm(), (a - c).squaredNorm())) {
    std::swap(a, b);
    std::swap(b, c);
  }
  Eigen::Vector3d best = closestOnEdge(a, b, p);
  for (const Eigen::Vector3d& q : {closestOnEdge(b, c, p), closestOnEdge(c, a, p)})
    if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
  const double length = (b - a).norm();
  const Eigen::Vector3d x = (b - a) / length;
  Eigen::Vector3d y = c - a - x * x.dot(c - a);
  const double height = y.norm();
  if (!(height > 0)) return best;
  y = (y / height - x * x.dot(y / height)).normalized();
  const double v = y.dot(p - a) / height, u = x.dot(p - a) / length - v * x.dot(c - a) / length;
  if (!(u > 0 && v > 0 && u + v < 1)) return best;
  const Eigen::Vector3d foot = a + (b - a) * u + (c - a) * v;
  return (foot - p).squaredNorm() < (best - p).squaredNorm() ? foot : best;
}

}  // namespace

Eigen::Vector3d closestPoint(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& p) {
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Eigen::Vector3d bp = p - b, cp = p - c;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double bb = d1 - d3, cc = d2 - d6, bc = d2 - d4;  // ab . ab, ac . ac and ab . ac
  if (bb * cc - bc * bc < kThin * std::max(bb, cc) * std::max(bb, cc)) return closestOnSliver(a, b, c, p);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / bb);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / cc);
  const double va = d3 * d6 - d5 * d4;
  const double along = d4 - d3, back = d5 - d6;
  if (va <= 0 && along >= 0 && back >= 0) return b + (c - b) * (along / (along + back));
  const double sum = va + vb + vc;
  return a + ab * (vb / sum) + ac * (vc / sum);
}

}  // namespace collision_hulls
