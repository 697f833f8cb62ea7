#include "collision_hulls/decompose/fit_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "check/cover.h"
#include "collision_hulls/decompose/reduce_vertices.h"
#include "collision_hulls/error.h"

namespace collision_hulls {

namespace {

// Half a unit in the last place of a single-precision number, as a share of its size; times sqrt(3) for three coordinates.
constexpr double kSinglePrecision = 5.97e-8 * 1.7321;
// A vertex of a sharp hull would have to move far to move its faces a little; beyond this many times the distance it is cut
// off instead, by points moved along each face's normal, unless the cap on vertices leaves no room for them.
constexpr double kMitreLimit = 20;
constexpr int kTries = 12;

/// How far to grow a hull.
struct Growth {
  double distance = 0;               // [m] of each face
  double mitre_limit = kMitreLimit;  // longest step of a vertex, in distances
};

using Points = std::vector<Eigen::Vector3d>;

/// The shortest step (nearly) that takes a point at least `distance` along each of the normals: projections onto the half-spaces
/// in turn (Hildreth's method, a fixed number of rounds), then scaled to satisfy all. Empty step where none is short.
Eigen::Vector3d outwardStep(const std::vector<Eigen::Vector3d>& normals, const Growth& growth) {
  const double distance = growth.distance;
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  std::vector<double> multiplier(normals.size(), 0.0);
  for (int round = 0; round < 32; ++round)
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const double correction = std::max(-multiplier[i], distance - normals[i].dot(step));
      multiplier[i] += correction;
      step += correction * normals[i];
    }
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& n : normals) least = std::min(least, n.dot(step));
  if (!(least > 0)) return Eigen::Vector3d::Zero();
  step *= std::max(1.0, distance / least);
  return step.norm() <= growth.mitre_limit * distance ? step : Eigen::Vector3d::Zero();
}

/// Points whose hull has each face of the hull moved outward by the growth's distance, at least.
Points grown(const ConvexHull& hull, const Growth& growth) {
  std::vector<std::vector<Eigen::Vector3d>> normals(hull.vertices.size());
  for (const Triangle& t : hull.triangles) {
    const auto at = [&](std::size_t k) -> const Eigen::Vector3d& { return hull.vertices[static_cast<std::size_t>(t[k])]; };
    const Eigen::Vector3d n = (at(1) - at(0)).cross(at(2) - at(0));
    if (n.norm() > 0)
      for (int v : t) normals[static_cast<std::size_t>(v)].push_back(n.normalized());
  }
  Points points;
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    const Eigen::Vector3d step = outwardStep(normals[v], growth);
    if (!step.isZero(0))
      points.push_back(hull.vertices[v] + step);
    else
      for (const Eigen::Vector3d& n : normals[v]) points.push_back(hull.vertices[v] + growth.distance * n);
  }
  return points;
}

Points roundedToSingle(Points points) {
  for (Eigen::Vector3d& p : points) p = p.cast<float>().cast<double>();
  return points;
}

bool holdsAll(const ConvexHull& hull, const Points& points, double margin) {
  return std::all_of(points.begin(), points.end(), [&](const auto& p) { return planeDistance(hull, p) <= -margin; });
}

bool overCap(const ConvexHull& hull, int max_vertices) {
  return max_vertices > 0 && hull.vertices.size() > static_cast<std::size_t>(max_vertices);
}

/// The hull grown by `margin` at least, with single-precision vertices, and by how much it had to be grown for that.
struct Rounded {
  ConvexHull hull;
  double nudge = 0;
};
Rounded roundOutward(const ConvexHull& hull, double margin, int max_vertices) {
  double size = 0;
  for (const Eigen::Vector3d& v : hull.vertices) size = std::max(size, v.cwiseAbs().maxCoeff());
  Growth growth{margin + 2 * kSinglePrecision * size + std::numeric_limits<float>::min(), kMitreLimit};
  for (int i = 0; i < kTries; ++i) {
    Rounded result{convexHull(roundedToSingle(grown(hull, growth))), growth.distance};
    const bool fits = !overCap(result.hull, max_vertices);
    if (fits && result.hull.thickness == 0 && holdsAll(result.hull, hull.vertices, margin)) return result;
    if (fits)
      growth.distance *= 2;
    else
      growth.mitre_limit *= 10;
  }
  throw Error(ErrorCode::kInternal, "a hull of size " + std::to_string(size) + " m cannot be rounded outward to single precision");
}

/// The hull that a triangle's corners lie least outside of.
std::size_t leastOutside(const std::vector<ConvexHull>& hulls, const std::array<Eigen::Vector3d, 3>& corners) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t h = 0; h < hulls.size(); ++h) {
    double out = 0;
    for (const Eigen::Vector3d& c : corners) out = std::max(out, distance(hulls[h], c));
    if (out < least) least = out, best = h;
  }
  return best;
}

/// At most max_vertices vertices (0: any number), outward.
ConvexHull capped(const ConvexHull& hull, int max_vertices) {
  return overCap(hull, max_vertices) ? reduceVertices(hull, max_vertices).hull : hull;
}

ConvexHull withPoints(const ConvexHull& hull, const Points& extra, int max_vertices) {
  Points all = hull.vertices;
  all.insert(all.end(), extra.begin(), extra.end());
  return capped(convexHull(all), max_vertices);
}

}  // namespace

FittedHulls fitCover(const std::vector<ConvexHull>& hulls, const TriangleMesh& original, double margin, int max_vertices) {
  FittedHulls fitted;
  for (const ConvexHull& hull : hulls) {
    const Rounded rounded = roundOutward(capped(hull, max_vertices), margin, max_vertices);
    fitted.hulls.push_back(rounded.hull);
    fitted.nudge = std::max(fitted.nudge, rounded.nudge);
  }
  for (int i = 0; i < kTries; ++i) {
    const std::vector<UncoveredTriangle> missing = uncoveredTriangles(original, fitted.hulls);
    if (missing.empty()) return fitted;
    fitted.completed += missing.size();
    std::map<std::size_t, Points> extra;
    for (const UncoveredTriangle& m : missing) {
      const std::array<Eigen::Vector3d, 3> corners{original.corner(m.triangle, 0), original.corner(m.triangle, 1),
                                                   original.corner(m.triangle, 2)};
      Points& points = extra[leastOutside(fitted.hulls, corners)];
      points.insert(points.end(), corners.begin(), corners.end());
    }
    for (const auto& [h, points] : extra)
      fitted.hulls[h] = roundOutward(withPoints(fitted.hulls[h], points, max_vertices), 0, max_vertices).hull;
  }
  throw Error(ErrorCode::kInternal, "the hulls still leave a part of the mesh uncovered after " + std::to_string(kTries) + " rounds");
}

}  // namespace collision_hulls
