// A body rests on a face of its hull if its centre of mass projects into the face's polygon; it tips at the angle between the vertical and
// the line from the nearest edge to the centre of mass.
#include "physics/resting.h"

#include <algorithm>
#include <cmath>

namespace collision_hulls {
namespace {

constexpr double kOnFace = 1e-6;        // of the body's size: vertices this near to a face's plane touch the table with it
constexpr double kSamePose = 0.939693;  // cosine of 20 degrees between faces

/// The corners of a face in its plane, counter-clockwise; the origin is the projection of the centre of mass.
std::vector<Eigen::Vector2d> footprint(const ConvexHull& hull, const HalfSpace& face, const Eigen::Matrix3d& down,
                                       const Eigen::Vector3d& center, double near) {
  std::vector<Eigen::Vector2d> corners;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& v : hull.vertices) {
    if (face.distance(v) < -near) continue;
    corners.emplace_back((down * (v - center)).head<2>());
    middle += corners.back();
  }
  middle /= static_cast<double>(corners.size());
  const auto angle = [&](const Eigen::Vector2d& p) { return std::atan2(p.y() - middle.y(), p.x() - middle.x()); };
  std::sort(corners.begin(), corners.end(), [&](const auto& a, const auto& b) { return angle(a) < angle(b); });
  return corners;
}

/// How deep the origin lies inside a convex polygon; negative outside.
double depth(const std::vector<Eigen::Vector2d>& polygon) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double length = (b - a).norm();
    if (length > 0) least = std::min(least, (a.x() * b.y() - a.y() * b.x()) / length);
  }
  return least;
}

}  // namespace

// Sums over the tetrahedra between a vertex and the triangles: the second moment of a tetrahedron with corners 0, a, b, c is
// V/20 (aa' + bb' + cc' + ss'), where s = a + b + c.
MassProperties massProperties(const ConvexHull& hull) {
  const Eigen::Vector3d origin = hull.vertices.front();
  double volume = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Triangle& t : hull.triangles) {
    const auto corner = [&](std::size_t k) -> Eigen::Vector3d { return hull.vertices[static_cast<std::size_t>(t[k])] - origin; };
    const Eigen::Vector3d a = corner(0), b = corner(1), c = corner(2), sum = a + b + c;
    const double v = a.dot(b.cross(c)) / 6;
    volume += v;
    first += v / 4 * sum;
    second += v / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  const Eigen::Vector3d mean = first / volume;
  const Eigen::Matrix3d spread = second / volume - mean * mean.transpose();
  return {origin + mean, spread.trace() * Eigen::Matrix3d::Identity() - spread};
}

std::vector<RestingPose> restingPoses(const ConvexHull& hull, const Eigen::Vector3d& center, std::size_t most) {
  const double near = kOnFace * boundingBox(hull).diagonal().norm() + hull.slack;
  std::vector<RestingPose> all;
  for (const HalfSpace& face : hull.faces) {
    RestingPose pose;
    pose.rotation = Eigen::Quaterniond::FromTwoVectors(face.normal, -Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const std::vector<Eigen::Vector2d> corners = footprint(hull, face, pose.rotation, center, near);
    pose.stability = corners.size() < 3 ? 0 : std::atan2(depth(corners), -face.distance(center));
    if (pose.stability > 0) all.push_back(pose);
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.stability > b.stability; });
  std::vector<RestingPose> chosen;
  for (const RestingPose& pose : all) {
    const auto same = [&](const RestingPose& other) { return pose.rotation.row(2).dot(other.rotation.row(2)) > kSamePose; };
    if (chosen.size() < most && std::none_of(chosen.begin(), chosen.end(), same)) chosen.push_back(pose);
  }
  return chosen;
}

}  // namespace collision_hulls
