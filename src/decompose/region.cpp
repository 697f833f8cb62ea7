// A convex hull within a convex region is a convex hull again: that of its vertices on the right side of each plane and of the points where
// its edges cross the plane. So whatever bounds the protrusion of a hull bounds it within a region, too.
//
// The planes are moved inward by half of the rim. That is a thousand times more than all rounding errors here, so the part holds every
// point that lies deeper than the rim.
#include "collision_hulls/decompose/region.h"

#include <algorithm>
#include <cmath>

#include "base/decimal.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

std::string textOf(const Eigen::Vector3d& v) {
  return "[" + decimal(v.x()) + ", " + decimal(v.y()) + ", " + decimal(v.z()) + "]";
}

constexpr double kUnitLength = 1e-6;  // by which a normal's length may differ from 1

void checkTolerance(double tolerance) {
  if (tolerance > 0 && std::isfinite(tolerance)) return;
  throw Error(ErrorCode::kBadOption, "a region's tolerance is " + decimal(tolerance) + " m; it must be a positive length");
}

bool isHalfSpace(const HalfSpace& side) {
  return std::abs(side.normal.norm() - 1) <= kUnitLength && std::isfinite(side.offset);
}

/// The part of the hull below the plane; nullopt: it has none.
std::optional<ConvexHull> below(const ConvexHull& hull, const HalfSpace& plane) {
  std::vector<double> heights;
  for (const Eigen::Vector3d& v : hull.vertices) heights.push_back(plane.distance(v));
  if (*std::min_element(heights.begin(), heights.end()) > 0) return std::nullopt;
  if (*std::max_element(heights.begin(), heights.end()) <= 0) return hull;
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (heights[i] <= 0) points.push_back(hull.vertices[i]);
  for (const Triangle& t : hull.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(t[k]), b = static_cast<std::size_t>(t[(k + 1) % 3]);
      if (heights[a] <= 0 && heights[b] > 0)  // each edge has two triangles, which see it from either end
        points.push_back(hull.vertices[a] + heights[a] / (heights[a] - heights[b]) * (hull.vertices[b] - hull.vertices[a]));
    }
  }
  return convexHull(points);
}

}  // namespace

void check(const Region& region) {
  checkTolerance(region.tolerance);
  const std::string name = region.name.empty() ? "a region" : "region '" + region.name + "'";
  if (region.sides.empty()) throw Error(ErrorCode::kBadOption, name + " has no sides; give it at least one");
  const auto wrong = std::find_if_not(region.sides.begin(), region.sides.end(), isHalfSpace);
  if (wrong == region.sides.end()) return;
  throw Error(ErrorCode::kBadOption, name + " has a side with the normal " + textOf(wrong->normal) + " and the offset " +
                                         decimal(wrong->offset) + "; the normal needs unit length, the offset must be finite, and a pose " +
                                         "must be rigid");
}

Region boxRegion(const Eigen::Vector3d& size, const Eigen::Isometry3d& pose, double tolerance) {
  checkTolerance(tolerance);
  if (!(size.minCoeff() > 0) || !size.allFinite())
    throw Error(ErrorCode::kBadOption, "a region's box has the size " + textOf(size) + " m; all three must be positive lengths");
  if (!((pose.linear().transpose() * pose.linear()).isIdentity(kUnitLength)))
    throw Error(ErrorCode::kBadOption, "the pose of a region's box scales or shears it; it must be rigid");
  Region box;
  box.tolerance = tolerance;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) box.sides.push_back({side * Eigen::Vector3d::Unit(axis), size[axis] / 2});
  }
  box = transformed(box, pose);
  check(box);
  return box;
}

Region halfSpaceRegion(const Eigen::Vector3d& normal, double offset, double tolerance) {
  checkTolerance(tolerance);
  const double length = normal.norm();
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(offset))
    throw Error(ErrorCode::kBadOption, "a region's half-space has the normal " + textOf(normal) + " and the offset " + decimal(offset) +
                                           "; the normal needs a direction, and both must be finite");
  return {{{-normal / length, -offset / length}}, tolerance, ""};
}

Region transformed(const Region& region, const Eigen::Isometry3d& pose) {
  Region moved = region;
  for (HalfSpace& side : moved.sides) {
    side.normal = pose.linear() * side.normal;
    side.offset += side.normal.dot(pose.translation());
  }
  return moved;
}

bool equal(const std::vector<Region>& a, const std::vector<Region>& b) {
  const auto equal_sides = [](const HalfSpace& x, const HalfSpace& y) { return x.normal == y.normal && x.offset == y.offset; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Region& x, const Region& y) {
    return x.tolerance == y.tolerance && std::equal(x.sides.begin(), x.sides.end(), y.sides.begin(), y.sides.end(), equal_sides);
  });
}

std::optional<ConvexHull> partIn(const ConvexHull& hull, const Region& region) {
  const auto inward = [](HalfSpace side) {
    side.offset -= kRegionRim / 2;
    return side;
  };
  const auto is_beyond = [&](const HalfSpace& side) {
    const HalfSpace plane = inward(side);
    return std::all_of(hull.vertices.begin(), hull.vertices.end(), [&](const Eigen::Vector3d& v) { return plane.distance(v) > 0; });
  };
  if (std::any_of(region.sides.begin(), region.sides.end(), is_beyond)) return std::nullopt;
  std::optional<ConvexHull> part = hull;
  for (const HalfSpace& side : region.sides) {
    part = below(*part, inward(side));
    if (!part) return std::nullopt;
  }
  return part;
}

}  // namespace collision_hulls
