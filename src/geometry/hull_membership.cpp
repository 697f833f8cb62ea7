// Portal refinement (Snethen, "XenoCollide: Complex Collision Made Simple", Game Programming Gems 7, 2008), for a point and a point set:
//
//   a ray runs from the middle of the points through p; a *portal* is a triangle of three of the points that it passes
//   find a portal, from support points
//   until p is on this side of the portal (inside) or no point lies further out than p along the portal's normal (outside):
//     add the support point beyond it, and keep that of the three new triangles which the ray passes
//
// All coordinates are relative to p, so that the ray runs from the middle through the origin.
#include "geometry/hull_membership.h"

#include <Eigen/Geometry>
#include <utility>

namespace collision_hulls {

namespace {

constexpr double kRounding = 1e-12;  // of the size of the points
constexpr int kMostSteps = 40;       // of each of the two loops; hulls of hundreds of points take ten

}  // namespace

HullMembership::HullMembership(const std::vector<Eigen::Vector3d>& points) : points_(points.size(), 3), heights_(points.size()) {
  const Eigen::Map<const Eigen::Matrix3Xd> all(points.front().data(), 3, static_cast<Eigen::Index>(points.size()));
  middle_ = all.rowwise().mean();
  points_ = (all.colwise() - middle_).transpose();
  low_ = points_.colwise().minCoeff();
  high_ = points_.colwise().maxCoeff();
  size_ = (high_ - low_).norm();
}

Eigen::Vector3d HullMembership::furthest(const Eigen::Vector3d& direction, const Eigen::Vector3d& p) {
  heights_.noalias() = points_ * direction;
  Eigen::Index place = 0;
  heights_.maxCoeff(&place);
  return points_.row(place).transpose() - p;
}

bool HullMembership::holds(const Eigen::Vector3d& point) {
  const Eigen::Vector3d p = point - middle_;
  if (!((p - low_).minCoeff() > 0 && (high_ - p).minCoeff() > 0)) return false;
  const Eigen::Vector3d middle = -p;
  const auto none = [this](const Eigen::Vector3d& normal) { return normal.norm() <= kRounding * size_ * size_; };

  Eigen::Vector3d a = furthest(p, p);
  Eigen::Vector3d normal = a.cross(middle);
  if (a.dot(p) <= 0 || none(normal)) return false;
  Eigen::Vector3d b = furthest(normal, p);
  if (b.dot(normal) <= 0) return false;
  normal = (a - middle).cross(b - middle);
  if (normal.dot(middle) > 0) {
    std::swap(a, b);
    normal = -normal;
  }
  Eigen::Vector3d c;
  for (int step = 0;; ++step) {
    if (step == kMostSteps || none(normal)) return false;
    c = furthest(normal, p);
    if (c.dot(normal) <= 0) return false;
    if (a.cross(c).dot(middle) < 0)
      b = c;
    else if (c.cross(b).dot(middle) < 0)
      a = c;
    else
      break;
    normal = (a - middle).cross(b - middle);
  }

  for (int step = 0; step < kMostSteps; ++step) {
    normal = (b - a).cross(c - a);
    if (none(normal)) return false;
    if (normal.dot(a) > kRounding * size_ * normal.norm()) return true;
    const Eigen::Vector3d next = furthest(normal, p);
    if (next.dot(normal) <= 0 || (next - a).dot(normal) <= kRounding * size_ * normal.norm()) return false;
    const Eigen::Vector3d side = next.cross(middle);
    if (a.dot(side) > 0)
      (b.dot(side) > 0 ? a : c) = next;
    else
      (c.dot(side) > 0 ? b : a) = next;
  }
  return false;
}

}  // namespace collision_hulls
