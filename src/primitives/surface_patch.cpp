// Only the surface has to be covered: a body whose hull is a wedge, say, takes a box along each of its sides where boxes for the whole
// wedge would be many. A polygon that a plane divides has its new corners on both sides of it, so that no point of the surface is lost but
// by rounding, which enclosingPrimitive() makes up for.
#include "primitives/surface_patch.h"

#include <algorithm>
#include <limits>

namespace collision_hulls {
namespace {

constexpr double kCutRounding = 1e-9;  // of the size of a hull: what is cut off may lie in no other
constexpr double kWithin = 1e-6;       // of a primitive's size: what lies this far within it does so when its numbers are rounded
constexpr double kFlatShare = 1. / 8;  // of the area: a smaller flat part is not worth a body of its own

}  // namespace

SurfacePatch::SurfacePatch(const TriangleMesh& mesh, const ConvexHull& within) {
  const Eigen::AlignedBox3d box = boundingBox(within);
  const double margin = kCutRounding * (box.diagonal().norm() + box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff());
  ConvexPolygon scratch;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto corner = [&](int k) -> const Eigen::Vector3d& { return mesh.corner(static_cast<int>(i), k); };
    Polygon polygon{{corner(0), corner(1), corner(2)}, (corner(1) - corner(0)).cross(corner(2) - corner(0)).stableNormalized()};
    for (const HalfSpace& face : within.faces) {
      if (polygon.points.empty()) break;
      clip(
          polygon.points, [&](const Eigen::Vector3d& p) { return margin - face.distance(p); }, scratch);
    }
    if (!polygon.points.empty()) polygons_.push_back(std::move(polygon));
  }
}

ConvexHull SurfacePatch::hull(double depth) const {
  std::vector<Eigen::Vector3d> points;
  for (const Polygon& polygon : polygons_)
    for (const Eigen::Vector3d& p : polygon.points) {
      points.push_back(p);
      points.emplace_back(p - depth * polygon.normal);
    }
  return convexHull(points);
}

void SurfacePatch::dropWithin(const Primitive& primitive) {
  Primitive inner = primitive;
  inner.size = (primitive.size.array() - kWithin * primitive.size.maxCoeff()).max(0);
  const auto holds = [&](const Eigen::Vector3d& p) { return distance(inner, p) == 0; };
  const auto covered = [&](const Polygon& polygon) { return std::all_of(polygon.points.begin(), polygon.points.end(), holds); };
  polygons_.erase(std::remove_if(polygons_.begin(), polygons_.end(), covered), polygons_.end());
}

double SurfacePatch::area(const Polygon& polygon) {
  Eigen::Vector3d twice = Eigen::Vector3d::Zero();
  const ConvexPolygon& p = polygon.points;
  for (std::size_t i = 2; i < p.size(); ++i) twice += (p[i - 1] - p[0]).cross(p[i] - p[0]);
  return twice.norm() / 2;
}

std::array<SurfacePatch, 2> SurfacePatch::flatPartAndRest(double flatness) const {
  const auto smaller = [](const Polygon& a, const Polygon& b) { return area(a) < area(b); };
  const Polygon& largest = *std::max_element(polygons_.begin(), polygons_.end(), smaller);
  const HalfSpace plane{largest.normal, largest.normal.dot(largest.points.front())};
  const auto is_flat = [&](const Polygon& polygon) {
    return polygon.normal.dot(plane.normal) > 0.5 &&
           std::all_of(polygon.points.begin(), polygon.points.end(),
                       [&](const Eigen::Vector3d& p) { return std::abs(plane.distance(p)) <= flatness; });
  };
  std::array<SurfacePatch, 2> parts;
  double flat = 0, all = 0;
  for (const Polygon& polygon : polygons_) {
    const bool here = is_flat(polygon);
    all += area(polygon);
    flat += here ? area(polygon) : 0;
    parts[here ? 0 : 1].polygons_.push_back(polygon);
  }
  if (flat < kFlatShare * all) parts[0].polygons_.clear();
  return parts;
}

/// What lies in the plane is below it.
std::array<SurfacePatch, 2> SurfacePatch::halves(const HalfSpace& plane) const {
  std::array<SurfacePatch, 2> result;
  ConvexPolygon scratch;
  const auto is_above = [&](const Eigen::Vector3d& p) { return plane.distance(p) > 0; };
  const auto is_below = [&](const Eigen::Vector3d& p) { return plane.distance(p) < 0; };
  for (const Polygon& polygon : polygons_) {
    const ConvexPolygon& points = polygon.points;
    Polygon below = polygon, above = polygon;
    const bool any_above = std::any_of(points.begin(), points.end(), is_above),
               any_below = std::any_of(points.begin(), points.end(), is_below);
    if (any_above && any_below) {
      clip(
          below.points, [&](const Eigen::Vector3d& p) { return -plane.distance(p); }, scratch);
      clip(
          above.points, [&](const Eigen::Vector3d& p) { return plane.distance(p); }, scratch);
    }
    if (any_below || !any_above) result[0].polygons_.push_back(std::move(below));
    if (any_above) result[1].polygons_.push_back(std::move(above));
  }
  return result;
}

Eigen::AlignedBox3d SurfacePatch::boxIn(const Eigen::Isometry3d& frame, double depth) const {
  const Eigen::Isometry3d into = frame.inverse();
  Eigen::AlignedBox3d box;
  for (const Polygon& polygon : polygons_)
    for (const Eigen::Vector3d& p : polygon.points) {
      box.extend(into * p);
      box.extend(into * (p - depth * polygon.normal));
    }
  return box;
}

std::array<SurfacePatch, 2> SurfacePatch::parts(double flatness, double depth) const {
  std::array<SurfacePatch, 2> best = flatPartAndRest(flatness);
  if (!best[0].empty() && !best[1].empty()) return best;
  const Eigen::Isometry3d frame = enclosingPrimitive(PrimitiveKind::kBox, hull(depth)).pose;
  const Eigen::AlignedBox3d box = boxIn(frame, 0);
  const Eigen::Vector3d middle = frame * box.center(), lengths = box.sizes();
  std::array<int, 3> axes{0, 1, 2};  // the longest first: of equal ways it counts
  std::sort(axes.begin(), axes.end(), [&](int a, int b) { return lengths[a] > lengths[b]; });
  double least = std::numeric_limits<double>::infinity();
  for (const int axis : axes) {
    const Eigen::Vector3d normal = frame.linear().col(axis);
    std::array<SurfacePatch, 2> sides = halves({normal, normal.dot(middle)});
    if (sides[0].empty() || sides[1].empty()) continue;  // across what is flat
    double size = 0;
    for (const SurfacePatch& side : sides) size += side.boxIn(frame, depth).volume();
    if (size < (1 - kCutRounding) * least) least = size, best = std::move(sides);
  }
  return best;
}

}  // namespace collision_hulls
