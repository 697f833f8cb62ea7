// Distances and support points are closed formulas in the primitive's own frame. Polyhedra around round shapes have their vertices on a
// larger shape of the same kind; whether they contain the primitive is then checked face by face, by its support point, and not taken on
// trust.
#include "collision_hulls/primitives/primitive.h"

#include <algorithm>
#include <cmath>

#include "collision_hulls/error.h"
#include "geometry/pi.h"

namespace collision_hulls {

namespace {

using Kind = PrimitiveKind;
using Points = std::vector<Eigen::Vector3d>;

constexpr int kLeastSides = 8, kMostSides = 160;  // of a polygon about a circle
constexpr int kGrowths = 8;                       // of a polyhedron that falls short of its primitive by rounding

/// Sides of a regular polygon about a circle whose corners are within `excess` of it.
int sidesAround(double radius, double excess) {
  const double sides = std::ceil(kPi / std::acos(radius / (radius + excess)));
  return static_cast<int>(std::clamp(sides, double{kLeastSides}, double{kMostSides}));
}

Points prismAround(double radius, double length, double excess) {
  const int n = sidesAround(radius, excess);
  const double corner = radius / std::cos(kPi / n);
  Points points;
  for (int i = 0; i < n; ++i)
    for (const double z : {-length / 2, length / 2})
      points.emplace_back(corner * std::cos(2 * kPi * i / n), corner * std::sin(2 * kPi * i / n), z);
  return points;
}

/// The corners of a grid of latitudes and longitudes. A cell's corners are at most half a step of each away from its middle, so no point of
/// the unit sphere is further than the root of 2 times that angle from one.
Points ballAround(double radius, double excess) {
  const int n = sidesAround(radius, excess / 2);  // an angle larger by the root of 2 doubles the excess
  const int rings = (n + 1) / 2;
  const double corner = radius / std::cos(std::sqrt(2.0) * kPi / n);
  Points points{{0, 0, corner}, {0, 0, -corner}};
  for (int j = 1; j < rings; ++j) {
    const double polar = kPi * j / rings;
    for (int i = 0; i < n; ++i) {
      const double turn = 2 * kPi * i / n;
      points.push_back(corner * Eigen::Vector3d(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)));
    }
  }
  return points;
}

Points pointsAround(const Primitive& primitive, double excess) {
  const Eigen::Vector3d& size = primitive.size;
  Points points;
  switch (primitive.kind) {
    case Kind::kBox:
      for (int k = 0; k < 8; ++k)
        points.emplace_back(Eigen::Vector3d(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1).cwiseProduct(size) / 2);
      break;
    case Kind::kSphere: return ballAround(size.x(), excess);
    case Kind::kCylinder: return prismAround(size.x(), size.y(), excess);
    case Kind::kCapsule:
      for (const Eigen::Vector3d& p : ballAround(size.x(), excess))
        for (const double z : {-size.y() / 2, size.y() / 2}) points.emplace_back(p.x(), p.y(), p.z() + z);
      break;
  }
  return points;
}

}  // namespace

const char* name(PrimitiveKind kind) {
  switch (kind) {
    case Kind::kSphere: return "sphere";
    case Kind::kCapsule: return "capsule";
    case Kind::kBox: return "box";
    case Kind::kCylinder: return "cylinder";
  }
  return "";
}

std::optional<PrimitiveKind> primitiveKindNamed(const std::string& text) {
  for (const Kind kind : allPrimitiveKinds())
    if (text == name(kind)) return kind;
  return std::nullopt;
}

const std::vector<PrimitiveKind>& allPrimitiveKinds() {
  static const std::vector<Kind> kinds{Kind::kSphere, Kind::kCapsule, Kind::kBox, Kind::kCylinder};
  return kinds;
}

double volume(const Primitive& primitive) {
  const Eigen::Vector3d& size = primitive.size;
  const double ball = 4 * kPi / 3 * std::pow(size.x(), 3), bar = kPi * size.x() * size.x() * size.y();
  switch (primitive.kind) {
    case Kind::kBox: return size.prod();
    case Kind::kSphere: return ball;
    case Kind::kCylinder: return bar;
    case Kind::kCapsule: return ball + bar;
  }
  return 0;
}

Eigen::Vector3d nearestPoint(const Primitive& primitive, const Eigen::Vector3d& p) {
  const Eigen::Vector3d& size = primitive.size;
  const Eigen::Vector3d local = primitive.pose.inverse() * p;
  Eigen::Vector3d nearest = local;
  if (primitive.kind == Kind::kBox) {
    nearest = local.cwiseMax(-size / 2).cwiseMin(size / 2);
  } else if (primitive.kind == Kind::kCylinder) {
    nearest.head<2>() *= std::min(1.0, size.x() / local.head<2>().norm());
    nearest.z() = std::clamp(local.z(), -size.y() / 2, size.y() / 2);
  } else {
    const double half = primitive.kind == Kind::kCapsule ? size.y() / 2 : 0;
    const Eigen::Vector3d core(0, 0, std::clamp(local.z(), -half, half));
    if ((local - core).norm() > size.x()) nearest = core + size.x() * (local - core).normalized();
  }
  return nearest == local ? p : primitive.pose * nearest;
}

double distance(const Primitive& primitive, const Eigen::Vector3d& p) {
  return (nearestPoint(primitive, p) - p).norm();
}

double support(const Primitive& primitive, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d& size = primitive.size;
  const Eigen::Vector3d n = primitive.pose.linear().transpose() * direction;
  const double middle = direction.dot(primitive.pose.translation()), along = size.y() / 2 * std::abs(n.z());
  switch (primitive.kind) {
    case Kind::kBox: return middle + n.cwiseAbs().dot(size) / 2;
    case Kind::kSphere: return middle + size.x() * n.norm();
    case Kind::kCylinder: return middle + size.x() * n.head<2>().norm() + along;
    case Kind::kCapsule: return middle + size.x() * n.norm() + along;
  }
  return middle;
}

ConvexHull hullAround(const Primitive& primitive, double excess) {
  Points points = pointsAround(primitive, excess);
  for (int k = 0; k < kGrowths; ++k) {
    Points placed;
    for (const Eigen::Vector3d& p : points) placed.push_back(primitive.pose * p);
    ConvexHull hull = convexHull(placed);
    double lacking = 0, depth = std::numeric_limits<double>::infinity();
    for (const HalfSpace& face : hull.faces) {
      lacking = std::max(lacking, support(primitive, face.normal) - face.offset);
      depth = std::min(depth, -face.distance(primitive.pose.translation()));
    }
    if (lacking <= 0) return hull;
    if (!(depth > 0)) break;
    for (Eigen::Vector3d& p : points) p *= 1 + 2 * lacking / depth;
  }
  throw Error(ErrorCode::kInternal, std::string("a polyhedron does not contain the ") + name(primitive.kind) + " that it was built around");
}

}  // namespace collision_hulls
