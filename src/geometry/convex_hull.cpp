// Builds a hull in three attempts: quickhull (fast, refuses where rounding would decide), Qhull (slow, merges facets, joggles the input if
// it has to), and for flat sets or when both refuse, a plate around all points. Then finish() merges coplanar faces and moves each one out
// until it holds every vertex: the guarantee rests on this measurement, not on the builders.
#include "collision_hulls/geometry/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "base/decimal.h"
#include "base/looks.h"
#include "collision_hulls/error.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "geometry/hull_support.h"
#include "geometry/qhull.h"
#include "geometry/quickhull.h"

namespace collision_hulls {

namespace {

// Planes that differ by less than this, in normal and in offset as a share of the extent, are the same.
constexpr double kSamePlane = 1e-10;
constexpr double kUnitLength = 1e-6;  // by which a normal's length may differ from 1

using Points = std::vector<Eigen::Vector3d>;

// Least thickness of a hull as a share of its extent. In a body this thin, double precision still distinguishes the face normals, and
// single precision keeps the two sides apart after rounding outward.
constexpr double kLeastThickness = 1e-6;
// The same as a share of the coordinates' size, for small bodies far from the origin; and for a lone point at the origin [m].
constexpr double kLeastThicknessFar = 1e-12, kLeastThicknessAtOrigin = 1e-9;

// Points closer to a line than this share of its length lie on it.
constexpr double kCollinear = 1e-12;
// Rounding error of a round trip into a frame and back, as a share of the coordinates' size.
constexpr double kFrameRounding = 4e-15;

/// An orthonormal frame whose axes follow a point set's length, breadth and thickness, in this order.
struct Frame {
  Eigen::Vector3d origin, middle;
  Eigen::Matrix3d axes;                              // columns
  Eigen::Vector3d extent = Eigen::Vector3d::Zero();  // along the axes

  Eigen::Vector3d local(const Eigen::Vector3d& p) const { return axes.transpose() * (p - origin); }
};

/// The point that maximises f; the first one on a tie.
template <class F>
const Eigen::Vector3d& furthest(const Points& points, F f) {
  std::size_t best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double value = f(points[i]);
    if (value > most) most = value, best = i;
  }
  return points[best];
}

/// Axes along a longest chord, toward the point furthest from it, and normal to both.
Frame spanningFrame(const Points& points) {
  Frame frame;
  const Eigen::Vector3d a = furthest(points, [&](const auto& p) { return (p - points[0]).squaredNorm(); });
  const Eigen::Vector3d b = furthest(points, [&](const auto& p) { return (p - a).squaredNorm(); });
  frame.origin = a;
  Eigen::Vector3d x = b - a;
  if (x.isZero(0)) x = Eigen::Vector3d::UnitX();
  x.normalize();
  const Eigen::Vector3d c = furthest(points, [&](const auto& p) { return (p - a - x * x.dot(p - a)).squaredNorm(); });
  Eigen::Vector3d y = c - a - x * x.dot(c - a);
  y -= x * x.dot(y);
  // Below this share of the length, y is rounding and may point anywhere, even along x.
  if (!(y.norm() > kCollinear * (b - a).norm())) y = x.unitOrthogonal();
  y.normalize();
  frame.axes << x, y, x.cross(y).normalized();
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(frame.local(p));
  frame.extent = box.sizes();
  frame.middle = frame.origin + frame.axes * box.center();
  return frame;
}

double largestCoordinate(const Points& points) {
  double size = 0;
  for (const Eigen::Vector3d& p : points) size = std::max(size, p.cwiseAbs().maxCoeff());
  return size;
}

double leastThickness(double size, const Frame& frame) {
  return std::max(
      {kLeastThickness * frame.extent.maxCoeff(), kLeastThicknessFar * size, frame.extent.maxCoeff() > 0 ? 0 : kLeastThicknessAtOrigin});
}

/// Corners of the 2D convex hull, counter-clockwise (Andrew's monotone chain). Drops points that stand out less than `flat` beyond their
/// neighbours' chord, sideways or past its ends; no dropped point lies further than that beyond the outline. (Rounding may order the points
/// of an edge across the sweep at random; the furthest of them is then the middle one of three.)
std::vector<Eigen::Vector2d> hull2d(std::vector<Eigen::Vector2d> p, double flat) {
  struct Corner {
    Eigen::Vector2d at;
    double lost = 0;  // how far dropped points lie beyond the edge that ends here
  };
  std::sort(p.begin(), p.end(), [](const auto& a, const auto& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  std::vector<Corner> chain;
  const auto walk = [&](const Eigen::Vector2d& at, std::size_t fixed) {
    Corner next{at, 0};
    while (chain.size() > fixed && chain.size() >= 2) {
      const Eigen::Vector2d u = chain.back().at - chain[chain.size() - 2].at, v = at - chain[chain.size() - 2].at;
      const double length = v.norm(), height = (u.x() * v.y() - u.y() * v.x()) / length, along = u.dot(v) / length;
      const double out = height > 0 ? std::max({height, -along, along - length}) : 0;
      const double lost = std::max(chain.back().lost, next.lost) + out;
      if (out > 0 && lost > flat) break;
      next.lost = lost;
      chain.pop_back();
    }
    chain.push_back(next);
  };
  for (const auto& c : p) walk(c, 1);
  const std::size_t lower = chain.size();
  for (std::size_t i = p.size(); i-- > 0;) walk(p[i], lower);
  chain.pop_back();
  std::vector<Eigen::Vector2d> corners;
  for (const Corner& c : chain) corners.push_back(c.at);
  return corners;
}

/// A flat set as a plate: its outline in the frame's plane, between two planes at least `thickness` apart.
Points plate(const Points& points, const Frame& frame, double thickness) {
  std::vector<Eigen::Vector2d> flat;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Eigen::Vector3d& p : points) {
    Eigen::Vector3d q = frame.local(p);
    low = std::min(low, q.z()), high = std::max(high, q.z());
    flat.emplace_back(q.x(), q.y());
    if (frame.extent.y() < thickness) {  // a line or a point: add breadth, and for a point length too
      const double along = frame.extent.x() < thickness ? thickness / 2 : 0;
      flat.back() += Eigen::Vector2d(along, thickness / 2);
      flat.emplace_back(q.x() - along, q.y() - thickness / 2);
      if (along > 0) flat.emplace_back(q.x() + along, q.y() - thickness / 2);
    }
  }
  const double grow = std::max(0.0, thickness - (high - low)) / 2;
  Points corners;
  for (const Eigen::Vector2d& c : hull2d(std::move(flat), kCollinear * frame.extent.x()))
    for (double z : {low - grow, high + grow}) corners.push_back(frame.origin + frame.axes * Eigen::Vector3d(c.x(), c.y(), z));
  return corners;
}

/// A prism over the corners from plate(), where bottom and top alternate. Its planes lie `slack` outside them to allow for points that
/// rounding left beyond.
ConvexHull prism(const Points& corners, const Frame& frame, double slack) {
  ConvexHull hull;
  hull.vertices = corners;
  const auto add = [&](const Triangle& t, const Eigen::Vector3d& normal) {
    hull.triangles.push_back(t);
    hull.faces.push_back({normal, normal.dot(corners[static_cast<std::size_t>(t[0])]) + slack});
  };
  const int n = static_cast<int>(corners.size()) / 2;
  const Eigen::Vector3d up = frame.axes.col(2);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n, a = 2 * i, b = 2 * j;
    const Eigen::Vector3d normal = (corners[static_cast<std::size_t>(b)] - corners[static_cast<std::size_t>(a)]).cross(up).normalized();
    add({a, b, b + 1}, normal);
    add({a, b + 1, a + 1}, normal);
    if (i >= 1 && i + 1 < n) {
      add({0, b, a}, -up);
      add({1, a + 1, b + 1}, up);
    }
  }
  return hull;
}

/// Merges faces that lie in the same plane, keeping the outermost. Expects one face per triangle and returns, per triangle, which of the
/// remaining faces is its own.
std::vector<std::size_t> joinCoplanarFaces(ConvexHull& hull, Looks& look) {
  const double extent = largestCoordinate(hull.vertices);
  // Equal planes are neighbours in the order along any direction. Along this odd one, few CAD models have other planes between them.
  const Eigen::Vector3d direction = Eigen::Vector3d(0.5773, 0.3141, 0.7541).normalized();
  std::vector<double> along;
  for (const HalfSpace& face : hull.faces) along.push_back(direction.dot(face.normal));
  std::vector<std::size_t> order(hull.faces.size()), joined(hull.faces.size()), first;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return look(), along[a] < along[b]; });
  std::vector<HalfSpace> kept;
  for (std::size_t f : order) {
    const HalfSpace& face = hull.faces[f];
    std::size_t same = kept.size();
    for (std::size_t i = kept.size(); look(), i-- > 0 && along[f] - along[first[i]] <= 2 * kSamePlane && same == kept.size();)
      if ((kept[i].normal - face.normal).cwiseAbs().maxCoeff() <= kSamePlane &&
          std::abs(kept[i].offset - face.offset) <= kSamePlane * extent)
        same = i;
    if (same == kept.size()) kept.push_back(face), first.push_back(f);
    kept[same].offset = std::max(kept[same].offset, face.offset);
    joined[f] = same;
  }
  hull.faces = std::move(kept);
  return joined;
}

/// Merges coplanar faces, moves each out until all vertices lie below it, and records how far they then lie off their faces.
void finish(ConvexHull& hull, const RunControl& control) {
  Looks look(control, kLargeItemsBetweenLooks);
  for (HalfSpace& face : hull.faces) face.normal.normalize();
  const std::vector<std::size_t> face_of = joinCoplanarFaces(hull, look);
  const HullSupport support(hull);
  for (std::size_t t = 0; t < hull.triangles.size(); ++t) {
    look();
    HalfSpace& face = hull.faces[face_of[t]];
    const int highest = support.furthest(face.normal, hull.triangles[t][0]);
    face.offset = std::max(face.normal.dot(hull.vertices[static_cast<std::size_t>(highest)]), face.offset);
  }
  for (std::size_t t = 0; t < hull.triangles.size(); ++t)
    for (int v : hull.triangles[t])
      hull.slack = std::max(hull.slack, std::abs(hull.faces[face_of[t]].distance(hull.vertices[static_cast<std::size_t>(v)])));
}

/// Works about the middle of the set, where double precision is finest.
std::optional<ConvexHull> spatialHull(const Points& points, const Eigen::Vector3d& middle, const RunControl& control) {
  Points centred(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) centred[i] = points[i] - middle;
  std::optional<ConvexHull> hull = quickhull(centred, control);
  if (!hull) hull = qhull(centred, control);
  if (!hull) return hull;
  finish(*hull, control);
  for (Eigen::Vector3d& v : hull->vertices) v += middle;
  for (HalfSpace& face : hull->faces) face.offset += face.normal.dot(middle);
  return hull;
}

void requireFinite(const Points& points) {
  if (points.empty()) throw Error(ErrorCode::kEmptyMesh, "convex hull of an empty point set; give at least one point");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!points[i].allFinite())
      throw Error(ErrorCode::kNonFiniteCoordinate, "convex hull: point " + std::to_string(i) + " is not finite; remove it");
}

}  // namespace

ConvexHull convexHull(const Points& points, const RunControl& control) {
  requireFinite(points);
  const Frame frame = spanningFrame(points);
  const double size = largestCoordinate(points), least = leastThickness(size, frame);
  if (frame.extent.z() >= least) {
    if (auto hull = spatialHull(points, frame.middle, control)) return *hull;
  }
  // Flat, or so nearly flat that Qhull gave up: a plate holds everything.
  ConvexHull hull = prism(plate(points, frame, least), frame, kCollinear * frame.extent.x() + kFrameRounding * size);
  hull.thickness = least;
  finish(hull, control);
  return hull;
}

void check(const std::vector<ConvexHull>& hulls, const RunControl& control) {
  Looks look(control);
  const auto text = [](const Eigen::Vector3d& p) { return "[" + decimal(p.x()) + ", " + decimal(p.y()) + ", " + decimal(p.z()) + "]"; };
  for (std::size_t h = 0; h < hulls.size(); ++h) {
    const ConvexHull& hull = hulls[h];
    const auto refuse = [&](ErrorCode code, const std::string& fault) {
      throw Error(code, "hull " + std::to_string(h) + ": " + fault + "; make the hull from its points with convexHull()");
    };
    const std::size_t vertices = hull.vertices.size(), triangles = hull.triangles.size(), faces = hull.faces.size();
    if (vertices + triangles + faces == 0) continue;
    if (vertices == 0 || triangles == 0 || faces == 0)
      refuse(ErrorCode::kEmptyMesh, std::to_string(vertices) + " vertices, " + std::to_string(triangles) + " triangles and " +
                                        std::to_string(faces) + " faces, where a hull has all three");
    for (std::size_t v = 0; v < vertices; ++v)
      if (look(), !hull.vertices[v].allFinite())
        refuse(ErrorCode::kNonFiniteCoordinate, "vertex " + std::to_string(v) + " is " + text(hull.vertices[v]) + ", which is not finite");
    for (std::size_t t = 0; t < triangles; ++t)
      for (const int v : hull.triangles[t])
        if (look(), v < 0 || static_cast<std::size_t>(v) >= vertices)
          refuse(ErrorCode::kIndexOutOfRange, "triangle " + std::to_string(t) + " names vertex " + std::to_string(v) + ", but there are " +
                                                  std::to_string(vertices) + ", counted from 0");
    for (std::size_t f = 0; f < faces; ++f) {
      look();
      const HalfSpace& face = hull.faces[f];
      const bool is_finite = face.normal.allFinite() && std::isfinite(face.offset);
      if (!is_finite || std::abs(face.normal.norm() - 1) > kUnitLength)
        refuse(is_finite ? ErrorCode::kBadOption : ErrorCode::kNonFiniteCoordinate,
               "face " + std::to_string(f) + " has the normal " + text(face.normal) + " and the offset " + decimal(face.offset) +
                   ", where normals have unit length and offsets are finite");
    }
  }
}

double volume(const ConvexHull& hull) {
  return signedVolume(hull.vertices, hull.triangles);
}

Eigen::AlignedBox3d boundingBox(const ConvexHull& hull) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : hull.vertices) box.extend(v);
  return box;
}

bool holds(const ConvexHull& hull, const Eigen::Vector3d& p) {
  const auto holds_it = [&](const HalfSpace& face) { return face.distance(p) <= 0; };  // not so of NaN
  return !hull.faces.empty() && std::all_of(hull.faces.begin(), hull.faces.end(), holds_it);
}

ConvexHull transformed(const ConvexHull& hull, const Eigen::Isometry3d& pose) {
  ConvexHull result = hull;
  for (Eigen::Vector3d& v : result.vertices) v = pose * v;
  for (HalfSpace& face : result.faces) {
    face.normal = pose.linear() * face.normal;
    face.offset += face.normal.dot(pose.translation());
  }
  return result;
}

double planeDistance(const ConvexHull& hull, const Eigen::Vector3d& p) {
  if (!p.allFinite()) return std::numeric_limits<double>::quiet_NaN();  // which std::max() would drop
  if (hull.faces.empty()) return std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  for (const HalfSpace& face : hull.faces) most = std::max(most, face.distance(p));
  return most;
}

double distance(const ConvexHull& hull, const Eigen::Vector3d& p) {
  const double beyond = planeDistance(hull, p);
  if (!std::isfinite(beyond)) return beyond;
  if (beyond <= 0) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : hull.triangles) {
    const auto at = [&](std::size_t k) -> const Eigen::Vector3d& { return hull.vertices[static_cast<std::size_t>(t[k])]; };
    least = std::min(least, (closestPoint(at(0), at(1), at(2), p) - p).squaredNorm());
  }
  return std::sqrt(least);
}

TriangleMesh surface(const ConvexHull& hull) {
  return {hull.vertices, hull.triangles};
}

}  // namespace collision_hulls
