// The sphere is the smallest one, by Welzl's algorithm with move to front. The box is that of orientedBox(). For a given axis the smallest
// cylinder is Welzl's circle in the plane across it; the axis is the best of a few candidates, refined by pattern search.
#include "fit/enclosing.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "collision_hulls/error.h"
#include "collision_hulls/scene/scene.h"
#include "decompose/bounding_box.h"
#include "geometry/pi.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;
using Points = std::vector<Eigen::Vector3d>;

constexpr double kRounding = 1e-7;                    // of a hull's size and distance from its origin: how much larger primitives are made
constexpr double kOnBorder = 1e-12;                   // of a ball's squared radius: points no further out than this are on its border
constexpr std::size_t kLongestEdges = 8;              // tried as a cylinder's axis
constexpr double kFirstTurn = 0.1, kLastTurn = 1e-3;  // [rad] steps in the search for a cylinder's axis

struct Ball {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double squared_radius = -1;  // -1: empty
};

/// The smallest ball with up to four given points on its border; its centre lies in their affine span.
Ball ballThrough(const Points& border) {
  if (border.empty()) return {};
  if (border.size() == 1) return {border.front(), 0};
  const auto n = static_cast<Eigen::Index>(border.size()) - 1;
  Eigen::MatrixXd spans(3, n);
  for (Eigen::Index i = 0; i < n; ++i) spans.col(i) = border[static_cast<std::size_t>(i) + 1] - border.front();
  const Eigen::MatrixXd products = spans.transpose() * spans;
  const Eigen::VectorXd shares = (2 * products).colPivHouseholderQr().solve(products.diagonal());
  const Eigen::Vector3d to_centre = spans * shares;
  return {border.front() + to_centre, to_centre.squaredNorm()};
}

/// The smallest ball around the first `count` points that has `border` on its border. Welzl 1991; points found on the border move to the
/// front.
Ball smallestBall(Points& points, std::size_t count, Points& border) {
  Ball ball = ballThrough(border);
  if (border.size() == 4) return ball;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d p = points[i];
    if ((p - ball.centre).squaredNorm() <= (1 + kOnBorder) * ball.squared_radius) continue;
    border.push_back(p);
    ball = smallestBall(points, i, border);
    border.pop_back();
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i), points.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  return ball;
}

Ball ballAbout(Points points) {
  Points border;
  Ball ball = smallestBall(points, points.size(), border);
  for (const Eigen::Vector3d& p : points) ball.squared_radius = std::max(ball.squared_radius, (p - ball.centre).squaredNorm());
  return ball;
}

struct Cylinder {
  Eigen::Vector3d axis, centre;
  double radius = 0, length = 0;
  double size() const { return radius * radius * length; }
};

Cylinder cylinderAlong(const Points& points, const Eigen::Vector3d& axis) {
  double low = axis.dot(points.front()), high = low;
  Points flat;
  for (const Eigen::Vector3d& p : points) {
    const double along = axis.dot(p);
    low = std::min(low, along);
    high = std::max(high, along);
    flat.push_back(p - along * axis);
  }
  const Ball circle = ballAbout(std::move(flat));
  return {axis, circle.centre + (low + high) / 2 * axis, std::sqrt(circle.squared_radius), high - low};
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

/// Turns the axis in shrinking steps as long as that makes the cylinder smaller.
Cylinder turned(const Points& points, Cylinder best) {
  for (double turn = kFirstTurn; turn > kLastTurn;) {
    const Eigen::Vector3d u = best.axis.unitOrthogonal(), v = best.axis.cross(u), axis = best.axis;
    const double before = best.size();
    for (const Eigen::Vector3d& aside : {u, v, Eigen::Vector3d(-u), Eigen::Vector3d(-v)}) {
      const Cylinder other = cylinderAlong(points, (axis + turn * aside).normalized());
      if (other.size() < best.size()) best = other;
    }
    if (best.size() >= before) turn /= 2;
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

GeometryElement elementOf(Kind kind, const Eigen::Vector3d& size, const Eigen::Vector3d& middle, const Eigen::Quaterniond& turn) {
  GeometryElement element;
  element.kind = kind;
  element.size = size;
  element.origin = Eigen::Translation3d(middle) * turn.normalized();
  return element;
}

GeometryElement boxAbout(const ConvexHull& hull) {
  const Eigen::Matrix3d axes = axesOf(orientedBox(hull));
  Eigen::AlignedBox3d extent;
  for (const Eigen::Vector3d& v : hull.vertices) extent.extend(Eigen::Vector3d(axes.transpose() * v));
  return elementOf(Kind::kBox, extent.sizes(), axes * extent.center(), Eigen::Quaterniond(axes));
}

GeometryElement sphereAbout(const ConvexHull& hull) {
  const Ball ball = ballAbout(hull.vertices);
  return elementOf(Kind::kSphere, Eigen::Vector3d::UnitX() * std::sqrt(ball.squared_radius), ball.centre, Eigen::Quaterniond::Identity());
}

GeometryElement cylinderAbout(const ConvexHull& hull) {
  const Eigen::Matrix3d box = axesOf(orientedBox(hull)), principal = principalAxes(hull.vertices);
  Points axes = longestEdges(hull);
  for (int k = 0; k < 3; ++k) axes.insert(axes.end(), {box.col(k), principal.col(k)});
  Cylinder best = cylinderAlong(hull.vertices, Eigen::Vector3d::UnitZ());
  for (const Eigen::Vector3d& axis : axes) {
    const Cylinder cylinder = cylinderAlong(hull.vertices, axis.normalized());
    if (cylinder.size() < best.size()) best = cylinder;
  }
  best = turned(hull.vertices, best);
  return elementOf(Kind::kCylinder, {best.radius, best.length, 0}, best.centre,
                   Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), best.axis));
}

}  // namespace

GeometryElement enclosingPrimitive(Kind kind, const ConvexHull& hull) {
  const Eigen::AlignedBox3d bounds = boundingBox(hull);
  const double more = kRounding * (bounds.diagonal().norm() + bounds.center().norm());
  GeometryElement result = kind == Kind::kSphere ? sphereAbout(hull) : kind == Kind::kCylinder ? cylinderAbout(hull) : boxAbout(hull);
  result.size += Eigen::Vector3d::Constant(2 * more);
  for (const Eigen::Vector3d& v : hull.vertices)
    if (nearestPoint(result, v) != v) throw Error(ErrorCode::kInternal, "a primitive does not enclose the hull that it was built for");
  return result;
}

double volume(const GeometryElement& primitive) {
  const Eigen::Vector3d& size = primitive.size;
  switch (primitive.kind) {
    case Kind::kBox: return size.prod();
    case Kind::kSphere: return 4 * kPi / 3 * std::pow(size.x(), 3);
    case Kind::kCylinder: return kPi * size.x() * size.x() * size.y();
    case Kind::kMesh:
    case Kind::kNone: break;
  }
  throw Error(ErrorCode::kInternal, "the volume of an element that is not a primitive");
}

Eigen::Vector3d nearestPoint(const GeometryElement& primitive, const Eigen::Vector3d& p) {
  const Eigen::Vector3d &size = primitive.size, local = primitive.origin.inverse() * p;
  Eigen::Vector3d nearest = local;
  if (primitive.kind == Kind::kBox) {
    nearest = local.cwiseMax(-size / 2).cwiseMin(size / 2);
  } else if (primitive.kind == Kind::kSphere) {
    nearest *= std::min(1.0, size.x() / local.norm());
  } else {
    nearest.head<2>() *= std::min(1.0, size.x() / local.head<2>().norm());
    nearest.z() = std::clamp(local.z(), -size.y() / 2, size.y() / 2);
  }
  return nearest == local ? p : primitive.origin * nearest;
}

ConvexHull hullAbout(const GeometryElement& primitive) {
  const Eigen::Vector3d& size = primitive.size;
  ConvexHull about;
  switch (primitive.kind) {
    case Kind::kBox: about = boxShape(size); break;
    case Kind::kSphere: about = sphereShape(size.x()); break;
    case Kind::kCylinder: about = cylinderShape(size.x(), size.y()); break;
    case Kind::kMesh:
    case Kind::kNone: throw Error(ErrorCode::kInternal, "the hull of an element that is not a primitive");
  }
  for (Eigen::Vector3d& v : about.vertices) v = primitive.origin * v;
  return convexHull(about.vertices);
}

}  // namespace collision_hulls
