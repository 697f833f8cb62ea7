// The sphere is the smallest one, the box that of orientedBox(). For a given axis the smallest cylinder stands on the smallest circle in
// the plane across it. A capsule takes the same circle; along the axis its two balls lie as near to each other as the points allow. The
// axis is the best of a few candidates, refined by pattern search.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "collision_hulls/error.h"
#include "collision_hulls/primitives/primitive.h"
#include "decompose/bounding_box.h"
#include "primitives/smallest_ball.h"

namespace collision_hulls {
namespace {

using Kind = PrimitiveKind;
using Points = std::vector<Eigen::Vector3d>;

constexpr double kSizeRounding = 1e-7;                // of a hull's size and distance from its origin: how much larger primitives are made
constexpr std::size_t kLongestEdges = 8;              // tried as an axis
constexpr double kFirstTurn = 0.1, kLastTurn = 1e-3;  // [rad] steps in the search for an axis

/// A cylinder or capsule.
struct Bar {
  Eigen::Vector3d axis, centre;
  double radius = 0, length = 0;
  double size = 0;  // proportional to the volume
};

/// The points' places along an axis and across it, and the smallest circle there.
struct Across {
  std::vector<double> along;
  Points flat;
  Ball circle;
};
Across across(const Points& points, const Eigen::Vector3d& axis, const RunControl& control) {
  Across result;
  for (const Eigen::Vector3d& p : points) {
    result.along.push_back(axis.dot(p));
    result.flat.push_back(p - result.along.back() * axis);
  }
  result.circle = smallestBall(result.flat, control);
  return result;
}

Bar cylinderAlong(const Points& points, const Eigen::Vector3d& axis, const RunControl& control) {
  const Across view = across(points, axis, control);
  const auto [low, high] = std::minmax_element(view.along.begin(), view.along.end());
  const double radius = std::sqrt(view.circle.squared_radius), length = *high - *low;
  return {axis, view.circle.centre + (*low + *high) / 2 * axis, radius, length, radius * radius * length};
}

/// A point at height z and distance s from the axis lies above the lower ball's end if that ball's centre is at z + sqrt(r^2 - s^2) at
/// most, and below the upper one's if that is at z - sqrt(r^2 - s^2) at least.
Bar capsuleAlong(const Points& points, const Eigen::Vector3d& axis, const RunControl& control) {
  const Across view = across(points, axis, control);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double reach = std::sqrt(std::max(0.0, view.circle.squared_radius - (view.flat[i] - view.circle.centre).squaredNorm()));
    low = std::min(low, view.along[i] + reach);
    high = std::max(high, view.along[i] - reach);
  }
  const double radius = std::sqrt(view.circle.squared_radius), length = std::max(0.0, high - low);
  return {axis, view.circle.centre + (low + high) / 2 * axis, radius, length, radius * radius * (length + 4 * radius / 3)};
}

Points longestEdges(const ConvexHull& hull) {
  Points edges;
  for (const Triangle& t : hull.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = t[k], to = t[(k + 1) % 3];
      if (from < to) edges.push_back(hull.vertices[static_cast<std::size_t>(to)] - hull.vertices[static_cast<std::size_t>(from)]);
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.squaredNorm() > b.squaredNorm(); });
  edges.resize(std::min(edges.size(), kLongestEdges));
  return edges;
}

using Along = std::function<Bar(const Points&, const Eigen::Vector3d&, const RunControl&)>;

/// Turns the axis in shrinking steps as long as that makes the bar smaller.
Bar turned(const Points& points, Bar best, const Along& along, const RunControl& control) {
  for (double turn = kFirstTurn; turn > kLastTurn;) {
    const Eigen::Vector3d u = best.axis.unitOrthogonal(), v = best.axis.cross(u), axis = best.axis;
    const double before = best.size;
    for (const Eigen::Vector3d& aside : {u, v, Eigen::Vector3d(-u), Eigen::Vector3d(-v)}) {
      const Bar other = along(points, (axis + turn * aside).normalized(), control);
      if (other.size < best.size) best = other;
    }
    if (best.size >= before) turn /= 2;
  }
  return best;
}

/// The box's axes, right-handed; the principal axes if the box is too thin to have six faces.
Eigen::Matrix3d axesOf(const ConvexHull& box) {
  Eigen::Matrix3d axes = principalAxes(box.vertices);
  if (box.faces.size() == 6) {
    axes.col(0) = box.faces[0].normal;
    for (const HalfSpace& face : box.faces)
      if (std::abs(face.normal.dot(axes.col(0))) < 0.5) axes.col(1) = face.normal;
  }
  axes.col(2) = axes.col(0).cross(axes.col(1)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

Primitive primitiveOf(Kind kind, const Eigen::Vector3d& size, const Eigen::Vector3d& middle, const Eigen::Quaterniond& turn) {
  return {kind, size, Eigen::Translation3d(middle) * turn.normalized()};
}

Primitive boxAbout(const ConvexHull& hull, const RunControl& control) {
  const Eigen::Matrix3d axes = axesOf(orientedBox(hull, control));
  Eigen::AlignedBox3d extent;
  for (const Eigen::Vector3d& v : hull.vertices) extent.extend(Eigen::Vector3d(axes.transpose() * v));
  return primitiveOf(Kind::kBox, extent.sizes(), axes * extent.center(), Eigen::Quaterniond(axes));
}

Primitive sphereAbout(const ConvexHull& hull, const RunControl& control) {
  const Ball ball = smallestBall(hull.vertices, control);
  return primitiveOf(Kind::kSphere, Eigen::Vector3d::UnitX() * std::sqrt(ball.squared_radius), ball.centre, Eigen::Quaterniond::Identity());
}

Primitive barAbout(Kind kind, const ConvexHull& hull, const RunControl& control) {
  const Along along = kind == Kind::kCylinder ? cylinderAlong : capsuleAlong;
  const Eigen::Matrix3d box = axesOf(orientedBox(hull, control)), principal = principalAxes(hull.vertices);
  Points axes = longestEdges(hull);
  for (int k = 0; k < 3; ++k) axes.insert(axes.end(), {box.col(k), principal.col(k)});
  Bar best = along(hull.vertices, Eigen::Vector3d::UnitZ(), control);
  for (const Eigen::Vector3d& axis : axes) {
    const Bar bar = along(hull.vertices, axis.normalized(), control);
    if (bar.size < best.size) best = bar;
  }
  best = turned(hull.vertices, best, along, control);
  if (best.axis.z() < 0) best.axis = -best.axis;  // a rotation by nearly half a turn would be imprecise
  return primitiveOf(kind, {best.radius, best.length, 0}, best.centre,
                     Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), best.axis));
}

}  // namespace

Primitive enclosingPrimitive(PrimitiveKind kind, const ConvexHull& hull, const RunControl& control) {
  if (hull.vertices.empty())
    throw Error(ErrorCode::kEmptyMesh, "a hull without vertices has no enclosing primitive; give one of convexHull(), or leave it out");
  const Eigen::AlignedBox3d bounds = boundingBox(hull);
  const double more = kSizeRounding * (bounds.diagonal().norm() + bounds.center().norm());
  Primitive result = kind == Kind::kSphere ? sphereAbout(hull, control)
                     : kind == Kind::kBox  ? boxAbout(hull, control)
                                           : barAbout(kind, hull, control);
  result.size += Eigen::Vector3d::Constant(2 * more);
  for (const Eigen::Vector3d& v : hull.vertices)
    if (nearestPoint(result, v) != v) throw Error(ErrorCode::kInternal, "a primitive does not enclose the hull that it was built for");
  return result;
}

}  // namespace collision_hulls
