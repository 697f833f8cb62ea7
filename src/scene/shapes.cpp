// Convex hulls of the primitive shapes. Round shapes are polyhedra around the true shape, never inside it, so that a planner that checks
// against them misses no collision.
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>

#include "base/counted.h"
#include "base/decimal.h"
#include "collision_hulls/error.h"
#include "collision_hulls/scene/scene.h"
#include "geometry/box_hull.h"
#include "geometry/pi.h"

namespace collision_hulls {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kLargest = 1e6;  // [m]

void expectSizes(const char* shape, std::initializer_list<double> sizes) {
  std::string text;
  for (const double size : sizes) text += (text.empty() ? "" : " x ") + decimal(size);
  for (const double size : sizes) {
    if (size > 0 && size <= kLargest) continue;
    throw Error(ErrorCode::kBadScene, std::string(shape) + " of " + text + " m; sizes must be above 0 and at most 1e6 m");
  }
}

/// Enough sides that a polygon around a circle protrudes by at most kRoundness of the radius.
int sidesOfCircle() {
  return static_cast<int>(std::ceil(kPi / std::acos(1 / (1 + SceneBody::kRoundness))));
}

Points circumscribedCircle(double radius, double z) {
  const int sides = sidesOfCircle();
  Points points;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * kPi * i / sides, out = radius / std::cos(kPi / sides);
    points.emplace_back(out * std::cos(angle), out * std::sin(angle), z);
  }
  return points;
}

void subdivide(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, int times, Points& points) {
  if (times == 0) return points.insert(points.end(), {a, b, c}), void();
  const Eigen::Vector3d ab = (a + b).normalized(), bc = (b + c).normalized(), ca = (c + a).normalized();
  subdivide(a, ab, ca, times - 1, points);
  subdivide(ab, b, bc, times - 1, points);
  subdivide(ca, bc, c, times - 1, points);
  subdivide(ab, bc, ca, times - 1, points);
}

/// A polyhedron around the unit sphere: an icosahedron subdivided three times, whose faces are then within 0.4 % of its corners.
ConvexHull aboutUnitSphere() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  Points corners;
  for (int i = 0; i < 3; ++i) {
    for (const double s : {-1.0, 1.0}) {
      for (const double t : {-golden, golden}) corners.push_back(s * Eigen::Vector3d::Unit(i) + t * Eigen::Vector3d::Unit((i + 1) % 3));
    }
  }
  const ConvexHull icosahedron = convexHull(corners);
  Points points;
  for (const Triangle& t : icosahedron.triangles) {
    std::array<Eigen::Vector3d, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = icosahedron.vertices[static_cast<std::size_t>(t[k])].normalized();
    subdivide(p[0], p[1], p[2], 3, points);
  }
  const ConvexHull inscribed = convexHull(points);
  double least = 1;
  for (const HalfSpace& face : inscribed.faces) least = std::min(least, face.offset);
  for (Eigen::Vector3d& p : points) p /= least;
  return convexHull(points);
}

}  // namespace

ConvexHull boxShape(const Eigen::Vector3d& sides) {
  expectSizes("a box", {sides.x(), sides.y(), sides.z()});
  return hullOfBox(sides);
}

ConvexHull sphereShape(double radius) {
  expectSizes("a sphere", {radius});
  static const ConvexHull unit = aboutUnitSphere();
  Points points = unit.vertices;
  for (Eigen::Vector3d& p : points) p *= radius;
  return convexHull(points);
}

ConvexHull cylinderShape(double radius, double length) {
  expectSizes("a cylinder", {radius, length});
  Points points = circumscribedCircle(radius, -length / 2);
  const Points top = circumscribedCircle(radius, length / 2);
  points.insert(points.end(), top.begin(), top.end());
  return convexHull(points);
}

ConvexHull coneShape(double radius, double length) {
  expectSizes("a cone", {radius, length});
  Points points = circumscribedCircle(radius, -length / 2);
  points.emplace_back(0, 0, length / 2);
  return convexHull(points);
}

PlacedShape planeShape(const Eigen::Vector3d& normal, double d) {
  const double length = normal.norm();
  if (!(length > 0 && std::isfinite(length) && std::abs(d) <= kLargest * length)) {
    throw Error(ErrorCode::kBadScene, "a plane with the normal (" + decimal(normal.x()) + ", " + decimal(normal.y()) + ", " +
                                          decimal(normal.z()) + ") and d = " + decimal(d) +
                                          "; the normal must not be zero, and the plane must pass within 1e6 m of the origin");
  }
  const Eigen::Vector3d up = normal / length;
  PlacedShape result{boxShape({kPlaneSide, kPlaneSide, kPlaneDepth})};
  result.pose.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), up).toRotationMatrix();
  result.pose.translation() = -(d / length + kPlaneDepth / 2) * up;
  return result;
}

std::size_t sizesOf(const std::string& kind) {
  static const std::map<std::string, std::size_t> kSizes{{"box", 3}, {"sphere", 1}, {"cylinder", 2}, {"cone", 2}, {"plane", 4}};
  const auto found = kSizes.find(kind);
  return found == kSizes.end() ? 0 : found->second;
}

void setShape(SceneBody& body, const std::string& kind, const std::vector<double>& s) {
  const std::size_t needed = sizesOf(kind);
  if (needed > 0 && s.size() != needed)
    throw Error(ErrorCode::kBadScene, "a " + kind + " of " + counted(s.size(), "size") + " was given; it takes " + std::to_string(needed));
  if (kind == "box") {
    body.shape = boxShape({s[0], s[1], s[2]});
  } else if (kind == "sphere") {
    body.shape = sphereShape(s[0]);
  } else if (kind == "cylinder") {
    body.shape = cylinderShape(s[0], s[1]);
  } else if (kind == "cone") {
    body.shape = coneShape(s[0], s[1]);
  } else if (kind == "plane") {
    const PlacedShape slab = planeShape({s[0], s[1], s[2]}, s[3]);
    body.shape = slab.shape;
    body.pose = body.pose * slab.pose;
  } else {
    throw Error(ErrorCode::kBadScene, "'" + kind + "' is not a shape; supported are box, sphere, cylinder, cone and plane");
  }
}

}  // namespace collision_hulls
