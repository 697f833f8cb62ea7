// Sweeps a hull joint by joint, from the link towards the root. An arc of a rotation is enclosed by the polygon of its tangents, so a sweep
// only ever grows; vertices are capped after each joint, which also only grows the body.
#include "reach/sweep.h"

#include <algorithm>
#include <cmath>

#include "collision_hulls/decompose/reduce_vertices.h"
#include "geometry/pi.h"

namespace collision_hulls {
namespace {

constexpr double kArc = kPi / 8;           // longest piece of an arc [rad]; the corners of such pieces lie 2 % of the radius further out
constexpr std::size_t kMostVertices = 64;  // of a swept body; capped() replaces more by fewer that lie further out
constexpr std::size_t kMostOfLink = 256;   // the same for a link itself

std::vector<Eigen::Vector3d> hullPoints(const std::vector<Eigen::Vector3d>& points, std::size_t most) {
  return capped(convexHull(points), static_cast<int>(most)).vertices;
}

PointMatrix toMatrix(const std::vector<Eigen::Vector3d>& points) {
  PointMatrix matrix(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) matrix.col(static_cast<Eigen::Index>(i)) = points[i];
  return matrix;
}

/// Turns about the joint's axis, in its frame, and stretches away from the axis.
Eigen::Affine3d turnedOut(const ChainJoint& joint, double angle, double stretch) {
  const Eigen::Matrix3d along = joint.axis * joint.axis.transpose();
  Eigen::Affine3d result(motion(joint, angle));
  result.linear() = result.linear() * (stretch * Eigen::Matrix3d::Identity() + (1 - stretch) * along);
  return result;
}

/// Transforms whose images of a point enclose, by their hull, every place to which the joint takes the point. An arc lies in the triangle
/// of its ends and the corner at which the tangents of its ends meet; with pieces of equal length, inner ends lie between two corners.
std::vector<Eigen::Affine3d> places(const ChainJoint& joint, const JointRange& range) {
  const double length = range.upper - range.lower;
  if (!joint.turns) return {Eigen::Affine3d(motion(joint, range.lower)), Eigen::Affine3d(motion(joint, range.upper))};
  const bool whole = length >= 2 * kPi;
  const double turn = std::min(length, 2 * kPi);
  const int pieces = std::max(1, static_cast<int>(std::ceil(turn / kArc)));
  const double half = turn / pieces / 2;
  std::vector<Eigen::Affine3d> result;
  const double from = whole ? 0 : range.lower;  // a lower limit far out would swallow the steps
  for (int i = 0; i < pieces; ++i) result.push_back(turnedOut(joint, from + (2 * i + 1) * half, 1 / std::cos(half)));
  if (!whole) result.insert(result.end(), {turnedOut(joint, range.lower, 1), turnedOut(joint, range.upper, 1)});
  return result;
}

}  // namespace

JointRange rangeOf(const ChainJoint& joint, const std::vector<JointVariable>& variables) {
  const JointVariable& variable = variables[joint.variable];
  const double a = joint.multiplier * variable.lower + joint.offset, b = joint.multiplier * variable.upper + joint.offset;
  return {std::min(a, b), std::max(a, b)};
}

std::vector<Eigen::Vector3d> swept(const std::vector<Eigen::Vector3d>& points, const ChainJoint& joint, const JointRange& range) {
  std::vector<Eigen::Vector3d> result;
  for (const Eigen::Affine3d& place : places(joint, range)) {
    const Eigen::Affine3d in_parent = joint.origin * place;
    for (const Eigen::Vector3d& p : points) result.push_back(in_parent * p);
  }
  return result;
}

std::vector<PointMatrix> sweeps(const ConvexHull& hull, const Chain& chain, const std::vector<JointVariable>& variables) {
  std::vector<PointMatrix> result(chain.joints.size() + 1);
  if (hull.vertices.empty()) return result;
  std::vector<Eigen::Vector3d> points = hullPoints(hull.vertices, kMostOfLink);
  for (Eigen::Vector3d& p : points) p = chain.end * p;
  result.back() = toMatrix(points);
  for (std::size_t k = chain.joints.size(); k-- > 0;) {
    points = hullPoints(swept(points, chain.joints[k], rangeOf(chain.joints[k], variables)), kMostVertices);
    result[k] = toMatrix(points);
  }
  return result;
}

}  // namespace collision_hulls
