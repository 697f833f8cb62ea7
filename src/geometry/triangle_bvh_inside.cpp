// Inside or outside: ray crossings for closed surfaces, solid angles for open ones.
//
// How much dipoles err: a surface element at r from the query contributes n . G(r) to the solid angle, G(r) = r /
// |r|^3, and G's derivative has norm 2 / |r|^3. Moving all elements of a cluster (area A, within a radius R of its centre, which is at a
// distance D) to its centre therefore changes the solid angle by at most 2 A R / (D - R)^3, the winding number by 1 / (4 pi) of that.
// windingNumber() replaces a cluster if that is at most its area's share of kWindingError: the shares of disjoint clusters sum to no more
// than 1. roughWindingNumber() may err by more, and spends that where it saves most: on whatever cluster comes first, as long as that takes
// only a share of the error that is left. Clusters that are far, or whose areas are small, then cost hardly anything.
#include <algorithm>
#include <cmath>

#include "collision_hulls/geometry/triangle_bvh.h"
#include "geometry/pi.h"

namespace collision_hulls {

namespace {

constexpr double kShareOfError = 0.25;  // that one cluster may take of what is left
constexpr double kAside = 1e-9;         // bound on the offset of the ray from its point, as a share of the extent

/// The sum of many angles, each from -pi to pi. Multiplies complex numbers with these angles and counts full turns, so a single atan2 at
/// the end suffices.
class SumOfAngles {
 public:
  /// Adds the angle of the vector (x, y).
  void add(double x, double y) {
    const double re = x * x_ - y * y_, im = x * y_ + y * x_, size = std::abs(re) + std::abs(im);
    if (!(size > 0)) return;
    if (y >= 0 && y_ >= 0 && (im < 0 || (im == 0 && re > 0 && x < 0))) ++turns_;
    if (y < 0 && y_ < 0 && (im > 0 || (im == 0 && re < 0))) --turns_;
    const double scale = 1 / size;
    x_ = re * scale, y_ = im * scale;
  }
  double value() const { return std::atan2(y_, x_) + 2 * kPi * turns_; }

 private:
  double x_ = 1, y_ = 0;
  int turns_ = 0;
};

/// Adds half a triangle's signed solid angle seen from the origin (Van Oosterom & Strackee 1983).
void addHalfSolidAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, SumOfAngles& sum) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  sum.add(la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb, a.dot(b.cross(c)));
}

/// Twice the signed area of a, b and the origin, seen along z. Evaluated identically for both directions of an edge, so the two triangles
/// that share it agree on which side the origin lies.
double edgeSide(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const bool swap = b.x() < a.x() || (b.x() == a.x() && b.y() < a.y());
  const Eigen::Vector3d &u = swap ? b : a, &v = swap ? a : b;
  const double side = u.x() * v.y() - u.y() * v.x();
  return swap ? -side : side;
}

/// How the triangle crosses the z axis above the origin: 1 upward, -1 downward, 0 not at all.
int crossing(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double ab = edgeSide(a, b), bc = edgeSide(b, c), ca = edgeSide(c, a);
  const bool up = ab > 0 && bc > 0 && ca > 0, down = ab < 0 && bc < 0 && ca < 0;
  if (!up && !down) return 0;
  const double height = (a.z() * bc + b.z() * ca + c.z() * ab) / (ab + bc + ca);
  return height > 0 ? (up ? 1 : -1) : 0;
}

}  // namespace

double TriangleBvh::extent() const {
  return empty() ? 0 : box_.sizes().maxCoeff();
}

double TriangleBvh::blur() const {
  return kAside * extent();
}

Eigen::Vector3d TriangleBvh::aside(const Eigen::Vector3d& p) const {
  return p + blur() * Eigen::Vector3d(0.7548776662, 0.5698402910, 0);  // CAD coordinates do not share such an offset
}

int TriangleBvh::signedCrossings(const Eigen::Vector3d& p) const {
  if (empty()) return 0;
  const Eigen::Vector3d q = aside(p);
  const Eigen::Vector3f u = inUnits(q);
  int sum = 0, top = 0;
  int stack[kDeepestFours];
  stack[top++] = 0;
  while (top > 0) {
    const FourBoxes& four = fours_[static_cast<std::size_t>(stack[--top])];
    const Eigen::Array4f aside =
        (four.low[0] - u.x()).max(u.x() - four.high[0]).max(four.low[1] - u.y()).max(u.y() - four.high[1]).max(u.z() - four.high[2]);
    for (int i = 0; i < four.count; ++i) {
      if (aside[i] > 0) continue;
      const int child = four.child[static_cast<std::size_t>(i)];
      if (child >= 0) {
        stack[top++] = child;
        continue;
      }
      const auto& [a, b, c] = corners_[static_cast<std::size_t>(~child)];
      sum += crossing(a - q, b - q, c - q);
    }
  }
  return sum;
}

/// Clusters are replaced by dipoles where replace(cluster, gap) says so; `gap` is how far away they are at least, > 0.
template <class Replace>
double TriangleBvh::windingNumber(const Eigen::Vector3d& p, const Replace& replace) const {
  double sum = 0;      // half solid angles of dipoles
  SumOfAngles angles;  // half solid angles of triangles
  const auto add = [&](const std::array<Eigen::Vector3d, 3>& corners) {
    addHalfSolidAngle(corners[0] - p, corners[1] - p, corners[2] - p, angles);
  };
  int stack[kDeepest];
  int top = 0;
  if (clusters_.empty())
    std::for_each(corners_.begin(), corners_.end(), add);
  else
    stack[top++] = 0;
  while (top > 0) {
    const auto id = static_cast<std::size_t>(stack[--top]);
    const Node& node = nodes_[id];
    const Cluster& cluster = clusters_[id];
    const Eigen::Vector3d to = cluster.dipole_centre - p;
    const double distance = to.norm(), gap = distance - cluster.radius;
    if (gap > 0 && replace(cluster, gap)) {
      sum += cluster.dipole.dot(to) / (2 * distance * distance * distance);
    } else if (node.count > 0) {
      for (int k = node.first; k < node.first + node.count; ++k) add(corners_[static_cast<std::size_t>(k)]);
    } else {
      stack[top++] = node.first;
      stack[top++] = node.first + 1;
    }
  }
  return (sum + angles.value()) / (2 * kPi);
}

double TriangleBvh::windingNumber(const Eigen::Vector3d& p) const {
  const double allowed = clusters_.empty() || !(clusters_[0].area > 0) ? 0 : 2 * kPi * kWindingError / clusters_[0].area;
  return windingNumber(p, [&](const Cluster& cluster, double gap) { return cluster.radius <= allowed * gap * gap * gap; });
}

TriangleBvh::RoughWinding TriangleBvh::roughWindingNumber(const Eigen::Vector3d& p, double allowed) const {
  RoughWinding rough;
  rough.number = windingNumber(p, [&](const Cluster& cluster, double gap) {
    const double error = cluster.area * cluster.radius / (2 * kPi * gap * gap * gap);
    if (error > kShareOfError * (allowed - rough.error)) return false;
    rough.error += error;
    return true;
  });
  return rough;
}

}  // namespace collision_hulls
