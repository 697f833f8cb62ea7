// Rounds hulls outward to single precision. Every vertex moves by the shortest step that takes all its faces out by the distance needed (a
// mitre); a vertex too sharp for that becomes a small octahedron, and a hull that then exceeds its vertex cap gives way to a blunter one,
// at worst its oriented box. Each result is measured against the hull it came from. Then all original triangles are tested
// (measure/cover.h), and any that are uncovered are added, until none is left.
#include "collision_hulls/decompose/round_outward.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/decimal.h"
#include "base/looks.h"
#include "base/parallel.h"
#include "collision_hulls/decompose/reduce_vertices.h"
#include "collision_hulls/error.h"
#include "decompose/bounding_box.h"
#include "decompose/outline.h"
#include "measure/cover.h"

namespace collision_hulls {

namespace {

// Half a unit in the last place of a single-precision number, as a share of its size; times sqrt(3) for three coordinates.
constexpr double kSinglePrecision = 5.97e-8 * 1.7321;
// Moving the faces of a sharp hull a little moves its vertex far. A vertex that would move beyond the first limit, in distances, is
// replaced by an octahedron around it; the second limit is for hulls whose vertex cap leaves no room for octahedra.
constexpr double kMitreLimit = 20, kLooseMitreLimit = 1e4;
constexpr int kDoublings = 6;
constexpr int kRounds = 12;
constexpr double kParallel = 1e-12;       // normals and planes closer than this are the same
constexpr std::size_t kManyNormals = 12;  // with more normals than this, triples are tried only until a step is found,
constexpr std::size_t kMostNormals = 60;  // and with more than this, only their mean is tried

using Points = std::vector<Eigen::Vector3d>;

/// How far to grow a hull.
struct Growth {
  double distance = 0;     // [m] by which each face moves
  double mitre_limit = 0;  // longest step of a vertex, in distances
};

bool reaches(const std::vector<Eigen::Vector3d>& normals, const Eigen::Vector3d& step, double distance) {
  constexpr double kRounding = 1e-9;
  return std::all_of(normals.begin(), normals.end(), [&](const auto& n) { return n.dot(step) >= distance * (1 - kRounding); });
}

/// The shortest step that moves a point by at least `distance` along each of the normals. It lies on one, two or three of the planes at
/// that distance. nullopt if there is no such step within the limit.
std::optional<Eigen::Vector3d> outwardStep(const std::vector<Eigen::Vector3d>& normals, const Growth& growth) {
  double shortest = growth.mitre_limit * growth.distance;
  std::optional<Eigen::Vector3d> best;
  const auto consider = [&](const Eigen::Vector3d& step) {
    if (step.norm() < shortest && reaches(normals, step, growth.distance)) shortest = step.norm(), best = step;
  };
  const std::size_t n = normals.size();
  if (n > kMostNormals) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& normal : normals) mean += normal;
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& normal : normals) least = std::min(least, normal.dot(mean));
    if (least > 0) consider(growth.distance / least * mean);
    return best;
  }
  for (std::size_t i = 0; i < n; ++i) consider(growth.distance * normals[i]);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const double cosine = normals[i].dot(normals[j]);
      if (1 + cosine > 0) consider(growth.distance / (1 + cosine) * (normals[i] + normals[j]));
      if (best && n > kManyNormals) continue;
      for (std::size_t k = j + 1; k < n; ++k) {
        Eigen::Matrix3d planes;
        planes << normals[i].transpose(), normals[j].transpose(), normals[k].transpose();
        if (std::abs(planes.determinant()) > kParallel) consider(planes.inverse() * Eigen::Vector3d::Constant(growth.distance));
      }
    }
  return best;
}

/// The distinct outward normals of the triangles at each vertex.
std::vector<std::vector<Eigen::Vector3d>> normalsAtVertices(const ConvexHull& hull) {
  std::vector<std::vector<Eigen::Vector3d>> normals(hull.vertices.size());
  for (const Triangle& t : hull.triangles) {
    const auto at = [&](std::size_t k) -> const Eigen::Vector3d& { return hull.vertices[static_cast<std::size_t>(t[k])]; };
    const Eigen::Vector3d n = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    if (!(n.norm() > 0)) continue;
    for (int v : t) {
      auto& known = normals[static_cast<std::size_t>(v)];
      if (std::none_of(known.begin(), known.end(), [&](const auto& k) { return (k - n).norm() < kParallel; })) known.push_back(n);
    }
  }
  return normals;
}

/// Points whose hull has each face moved outward by at least the growth's distance.
Points grown(const ConvexHull& hull, const Growth& growth, const RunControl& control) {
  Looks look(control, kLargeItemsBetweenLooks);
  const std::vector<std::vector<Eigen::Vector3d>> normals = normalsAtVertices(hull);
  Points points;
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    look();
    if (const auto step = outwardStep(normals[v], growth)) {
      points.push_back(hull.vertices[v] + *step);
      continue;
    }
    // An octahedron that contains a ball of that radius.
    for (int axis = 0; axis < 3; ++axis)
      for (double sign : {1.0, -1.0})
        points.push_back(hull.vertices[v] + sign * std::sqrt(3.0) * growth.distance * Eigen::Vector3d::Unit(axis));
  }
  return points;
}

/// When GCC 12.2 vectorizes it optimises the conversion to single precision and back away; a volatile variable prevents that.
double roundedToSingle(double x) {
  const volatile float single = static_cast<float>(x);
  return single;
}

Points roundedToSingle(Points points) {
  for (Eigen::Vector3d& p : points) p = {roundedToSingle(p.x()), roundedToSingle(p.y()), roundedToSingle(p.z())};
  return points;
}

bool holdsAll(const ConvexHull& hull, const Points& points, double margin, const RunControl& control) {
  return std::all_of(points.begin(), points.end(), [&](const auto& p) { return control.check(), planeDistance(hull, p) <= -margin; });
}

/// Twice the furthest that rounding to single precision may move a vertex.
double roundingOf(const ConvexHull& hull) {
  double size = 0;
  for (const Eigen::Vector3d& v : hull.vertices) size = std::max(size, v.cwiseAbs().maxCoeff());
  return 2 * kSinglePrecision * size + std::numeric_limits<float>::min();
}

/// A hull grown by at least `margin`, with single-precision vertices, and how far it had to be grown for that.
struct Rounded {
  ConvexHull hull;
  double nudge = 0;
  double blunted = 0;  // [m] see RoundedHulls
};
std::optional<Rounded> roundOutward(const ConvexHull& hull, const Points& held, double margin, double mitre_limit, int max_vertices,
                                    const RunControl& control) {
  Growth growth{margin + roundingOf(hull), mitre_limit};
  for (int i = 0; i < kDoublings; ++i, growth.distance *= 2) {
    Rounded result{convexHull(roundedToSingle(grown(hull, growth, control)), control), growth.distance};
    result.hull.vertices = roundedToSingle(std::move(result.hull.vertices));  // convexHull() may change a last bit
    // Flat by rounding: it has two sides, and so perhaps more vertices than a thicker one.
    if (result.hull.thickness > 0) continue;
    if (exceedsCap(result.hull, max_vertices)) break;
    if (holdsAll(result.hull, held, margin, control)) return result;
  }
  return std::nullopt;
}

/// The hull of the vertices moved both ways along their direction of least spread.
ConvexHull slab(const ConvexHull& hull, double distance, const RunControl& control) {
  const Eigen::Vector3d way = distance * principalAxes(hull.vertices).col(0);
  Points points;
  for (const Eigen::Vector3d& v : hull.vertices) points.insert(points.end(), {v - way, v + way});
  return convexHull(points, control);
}

/// Blunter hulls around one that is too sharp for its vertex cap, as thin hulls are.
std::vector<ConvexHull> blunted(const ConvexHull& hull, double distance, int max_vertices, const RunControl& control) {
  std::vector<ConvexHull> result;
  if (max_vertices == 0) return result;
  const ConvexHull thicker = slab(hull, distance, control);
  for (int most = max_vertices; most >= kLeastVertices; most -= std::max(1, max_vertices / 8))
    result.push_back(capped(thicker, most, control));
  result.push_back(prismAbout(hull, max_vertices));
  return result;
}

/// Rounds any hull outward. If it is too sharp, takes the closest of the blunter hulls around it; if there is none, the closer of the hull
/// with a larger limit on its vertices' steps and its oriented box.
Rounded roundOutward(const ConvexHull& hull, double margin, int max_vertices, const RunControl& control) {
  const auto attempt = [&](const ConvexHull& outer, double mitre_limit) {
    return roundOutward(outer, hull.vertices, margin, mitre_limit, max_vertices, control);
  };
  if (const auto result = attempt(hull, kMitreLimit)) return *result;
  std::optional<Rounded> best;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](std::optional<Rounded> result) {
    const double added = result ? addedDistance(result->hull, hull, control) : least;
    if (added < least) least = added, best = std::move(result);
  };
  for (const ConvexHull& blunt : blunted(hull, margin + roundingOf(hull), max_vertices, control)) consider(attempt(blunt, kMitreLimit));
  if (!best) {
    const ConvexHull box = orientedBox(hull, control);
    consider(attempt(hull, kLooseMitreLimit));
    consider(attempt(box, kMitreLimit));
    if (!best) consider(attempt(box, kLooseMitreLimit));
  }
  if (best) {
    best->blunted = least;
    return *std::move(best);
  }
  throw Error(ErrorCode::kInternal, "a hull of " + std::to_string(hull.vertices.size()) + " vertices about " +
                                        fixedDecimal(hull.vertices.front().x()) + " m cannot be rounded outward to single precision");
}

/// The hull that a triangle's corners stick out of least.
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

ConvexHull withPoints(const ConvexHull& hull, const Points& extra, int max_vertices, const RunControl& control) {
  Points all = hull.vertices;
  all.insert(all.end(), extra.begin(), extra.end());
  return capped(convexHull(all, control), max_vertices, control);
}

}  // namespace

RoundedHulls roundOutward(const std::vector<ConvexHull>& hulls, const TriangleMesh& original, double margin, int max_vertices,
                          const RunControl& control) {
  RoundedHulls result;
  const auto take = [&](Rounded rounded, ConvexHull& hull) {
    hull = std::move(rounded.hull);
    result.nudge = std::max(result.nudge, rounded.nudge);
    result.blunted = std::max(result.blunted, rounded.blunted);
  };
  std::vector<Rounded> rounded(hulls.size());
  forEach(hulls.size(), [&](std::size_t h) {
    control.check();
    rounded[h] = roundOutward(capped(hulls[h], max_vertices, control), margin, max_vertices, control);
  });
  result.hulls.resize(hulls.size());
  for (std::size_t h = 0; h < hulls.size(); ++h) take(std::move(rounded[h]), result.hulls[h]);
  for (int i = 0; i < kRounds; ++i) {
    const std::vector<int> missing = uncoveredTriangles(original, result.hulls, control);
    if (missing.empty()) return result;
    if (result.hulls.empty())
      throw Error(ErrorCode::kInternal, "there is no hull to add " + std::to_string(missing.size()) + " uncovered triangles to");
    result.completed += missing.size();
    std::map<std::size_t, Points> extra;
    for (const int t : missing) {
      control.check();
      const std::array<Eigen::Vector3d, 3> corners{original.corner(t, 0), original.corner(t, 1), original.corner(t, 2)};
      Points& points = extra[leastOutside(result.hulls, corners)];
      points.insert(points.end(), corners.begin(), corners.end());
    }
    for (const auto& [h, points] : extra)
      take(roundOutward(withPoints(result.hulls[h], points, max_vertices, control), 0, max_vertices, control), result.hulls[h]);
  }
  throw Error(ErrorCode::kInternal, "the hulls still leave part of the mesh uncovered after " + std::to_string(kRounds) + " rounds");
}

}  // namespace collision_hulls
