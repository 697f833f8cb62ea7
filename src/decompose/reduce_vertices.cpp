// From within, then outward:
//
//   inner hull: begin with the extreme points along the axes
//   until there are max_vertices points, add the hull's vertices furthest outside of the inner hull, as quickhull does
//   move each of the inner hull's vertices out, beyond the hull's touching planes parallel to the faces around it
//   let each sink again, as far as the faces around it can turn before they cut into the hull
//   a few times: draw the vertices half way to the middle of their neighbours, move them out and let them sink again;
//   keep the result that protrudes least
//
// All corners of a moved face lie beyond a touching plane, so no face meets the hull's interior, and the hull stays within.
// Collapsing edges outward (progressive hulls) was tried instead: nearly twice the protrusion on round hulls.
#include "collision_hulls/decompose/reduce_vertices.h"

#include <algorithm>
#include <optional>
#include <string>

#include "collision_hulls/error.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "decompose/bounding_box.h"
#include "decompose/lowest_point.h"

namespace collision_hulls {

namespace {

using Points = std::vector<Eigen::Vector3d>;

// A hull is stretched where it is thinner than this share of its length, so that rounding does not decide.
constexpr double kThinnest = 0.01;
// In a round all points are added that lie outside by this share of the largest such distance: less is faster and worse.
constexpr double kShareOfFurthest = 0.5;
// Points that lie outside of the inner hull by less than this share of the extent are not worth a vertex.
constexpr double kNegligible = 1e-9;
// Attempts to space the vertices more evenly.
constexpr int kRelaxations = 3;

Eigen::Vector3d areaVector(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return (b - a).cross(c - a) / 2;
}

/// The furthest of `points` beyond each face of a hull, and how far; a point counts for the face that it is furthest from.
std::vector<std::pair<double, std::size_t>> furthestOutside(const ConvexHull& hull, const Points& points) {
  std::vector<std::pair<double, std::size_t>> furthest(hull.faces.size(), {0, 0});
  for (std::size_t i = 0; i < points.size(); ++i) {
    double most = 0;
    std::size_t face = 0;
    for (std::size_t f = 0; f < hull.faces.size(); ++f) {
      const double d = hull.faces[f].distance(points[i]);
      if (d > most) most = d, face = f;
    }
    if (most > furthest[face].first) furthest[face] = {most, i};
  }
  return furthest;
}

Points extremePoints(const Points& points) {
  Points result;
  for (int k = 0; k < 3; ++k) {
    const auto less = [k](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a[k] < b[k]; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    result.insert(result.end(), {*low, *high});
  }
  return result;
}

/// A hull of some of the points.
ConvexHull innerHull(const Points& points, std::size_t max_vertices) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(p);
  ConvexHull inner = convexHull(extremePoints(points));
  while (inner.vertices.size() < max_vertices) {
    auto furthest = furthestOutside(inner, points);
    std::stable_sort(furthest.begin(), furthest.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    const double least = std::max(kShareOfFurthest * furthest.front().first, kNegligible * box.sizes().maxCoeff());
    Points more = inner.vertices;
    for (const auto& [distance, point] : furthest)
      if (distance > least && more.size() < max_vertices) more.push_back(points[point]);
    if (more.size() == inner.vertices.size()) break;
    inner = convexHull(more);
  }
  return inner;
}

/// A closed surface about a hull, whose vertices move.
class OuterSurface {
 public:
  OuterSurface(const ConvexHull& start, const ConvexHull& held)
      : vertices_(start.vertices), triangles_(start.triangles), around_(start.vertices.size()), held_(held) {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (int v : triangles_[t]) around_[v].push_back(static_cast<int>(t));
  }

  /// Draws every vertex half way to the mean of its neighbours.
  void relax() {
    Points relaxed;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int t : around_[v])
        for (int n : triangles_[t]) sum += vertices_[n];
      const auto count = static_cast<double>(around_[v].size());  // of neighbours, each in two triangles; and v in all
      relaxed.push_back(vertices_[v] / 2 + (sum - count * vertices_[v]) / (4 * count));
    }
    vertices_ = std::move(relaxed);
  }

  /// Moves every vertex out to where the touching planes of all faces around it are beneath; false if one has no such place.
  bool rise() {
    std::vector<HalfSpace> touching;
    for (const Triangle& t : triangles_) {
      const Eigen::Vector3d normal = areaVector(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]).normalized();
      double offset = normal.dot(vertices_[t[0]]);
      for (const Eigen::Vector3d& p : held_.vertices) offset = std::max(offset, normal.dot(p));
      touching.push_back({normal, offset});
    }
    Points risen;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      std::vector<HalfSpace> planes;
      for (int t : around_[v]) planes.push_back(touching[t]);
      const auto x = nearestBeyond(static_cast<int>(v), planes);
      if (!x) return false;
      risen.push_back(*x);
    }
    vertices_ = std::move(risen);
    return true;
  }

  void sink(const TriangleBvh& held) {
    for (std::size_t v = 0; v < vertices_.size(); ++v) sink(static_cast<int>(v), held);
  }

  ConvexHull hull() const { return convexHull(vertices_); }

 private:
  /// Moves a vertex to where its faces hold the hull and least else, if it gets no further from the hull. Each face turns about
  /// the edge opposite to the vertex, so the vertex must stay beyond the plane through that edge that touches the hull.
  void sink(int v, const TriangleBvh& held) {
    std::vector<HalfSpace> planes;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (int t : around_[v]) {
      const auto k = std::find(triangles_[t].begin(), triangles_[t].end(), v) - triangles_[t].begin();
      const Eigen::Vector3d &a = vertices_[triangles_[t][(k + 1) % 3]], &b = vertices_[triangles_[t][(k + 2) % 3]];
      const auto plane = touchingPlane(a, b, vertices_[v]);
      if (!plane) return;
      planes.push_back(*plane);
      gradient += areaVector(vertices_[v], a, b);
    }
    const auto x = lowestPointBeyond(planes, gradient, vertices_[v], reach(v));
    if (x && held.nearest(*x).distance <= held.nearest(vertices_[v]).distance) vertices_[v] = *x;
  }

  /// Length of the longest edge at a vertex.
  double reach(int v) const {
    double furthest = 0;
    for (int t : around_[v])
      for (int n : triangles_[t]) furthest = std::max(furthest, (vertices_[n] - vertices_[v]).norm());
    return furthest;
  }

  /// A point beyond all planes near a vertex: lowest along the faces' mean normal, or the one that adds least volume.
  std::optional<Eigen::Vector3d> nearestBeyond(int v, const std::vector<HalfSpace>& planes) const {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(), gradient = normal;
    for (const HalfSpace& plane : planes) normal += plane.normal;
    for (int t : around_[v]) gradient += areaVector(vertices_[triangles_[t][0]], vertices_[triangles_[t][1]], vertices_[triangles_[t][2]]);
    std::optional<Eigen::Vector3d> best;
    for (const Eigen::Vector3d& up : {normal, gradient}) {
      const auto x = lowestPointBeyond(planes, up, vertices_[v], 2 * reach(v));
      if (x && (!best || (*x - vertices_[v]).norm() < (*best - vertices_[v]).norm())) best = x;
    }
    return best;
  }

  /// The plane through a and b that is lowest at x and has the hull beneath; nullopt where a, b and x are in line.
  std::optional<HalfSpace> touchingPlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& x) const {
    constexpr double kInLine = 1e-9;
    const Eigen::Vector3d along = (b - a).normalized(), normal = (b - a).cross(x - a);
    if (!(normal.norm() > kInLine * (b - a).norm() * (x - a).norm())) return std::nullopt;
    const Eigen::Vector3d up = normal.normalized(), toward = up.cross(along);
    double slope = -1 / kInLine;
    for (const Eigen::Vector3d& p : held_.vertices) {
      const double run = toward.dot(p - a), rise = up.dot(p - a);
      if (run > 0 && rise > slope * run) slope = rise / run;
    }
    const Eigen::Vector3d turned = (up - slope * toward).normalized();
    return HalfSpace{turned, turned.dot(a)};
  }

  Points vertices_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<int>> around_;  // triangles by vertex
  const ConvexHull& held_;
};

/// The hull of a start's vertices once they have risen beyond `held` and sunk again; nullopt where one cannot rise.
std::optional<ConvexHull> risenAndSunk(const ConvexHull& start, const ConvexHull& held, const TriangleBvh& bvh) {
  OuterSurface surface(start, held);
  if (!surface.rise()) return std::nullopt;
  OuterSurface risen(surface.hull(), held);
  risen.sink(bvh);
  return risen.hull();
}

double largestDistance(const ConvexHull& outer, const TriangleBvh& held) {
  double most = 0;
  for (const Eigen::Vector3d& v : outer.vertices) most = std::max(most, held.nearest(v).distance);
  return most;
}

/// Points whose hull holds `hull`; nullopt where that fails.
std::optional<Points> outerPoints(const ConvexHull& hull, std::size_t max_vertices) {
  const TriangleBvh bvh(surface(hull));
  std::optional<ConvexHull> outer = risenAndSunk(innerHull(hull.vertices, max_vertices), hull, bvh);
  if (!outer) return std::nullopt;
  Points best = outer->vertices;
  double least = largestDistance(*outer, bvh);
  for (int k = 0; k < kRelaxations; ++k) {
    OuterSurface relaxed(*outer, hull);
    relaxed.relax();
    outer = risenAndSunk(relaxed.hull(), hull, bvh);
    if (!outer || outer->vertices.size() > max_vertices) break;
    const double most = largestDistance(*outer, bvh);
    if (most < least) least = most, best = outer->vertices;
  }
  return best;
}

/// An affine map that makes thin sets thicker; volumes keep their order under it, and what holds what.
struct Stretch {
  explicit Stretch(const Points& points) : axes(principalAxes(points)) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : points) box.extend(Eigen::Vector3d(axes.transpose() * p));
    middle = axes * box.center();
    const Eigen::Vector3d least = Eigen::Vector3d::Constant(kThinnest * box.sizes().maxCoeff());
    factors = least.cwiseMax(box.sizes()).cwiseQuotient(box.sizes());
  }
  Points forward(Points points) const {
    for (Eigen::Vector3d& p : points) p = factors.asDiagonal() * (axes.transpose() * (p - middle));
    return points;
  }
  Points back(Points points) const {
    for (Eigen::Vector3d& p : points) p = middle + axes * p.cwiseQuotient(factors);
    return points;
  }
  Eigen::Matrix3d axes;  // columns
  Eigen::Vector3d middle, factors;
};

std::optional<ConvexHull> outerHull(const ConvexHull& hull, std::size_t max_vertices) {
  const Stretch stretch(hull.vertices);
  const std::optional<Points> points = outerPoints({stretch.forward(hull.vertices), hull.triangles, {}, 0, 0}, max_vertices);
  if (!points) return std::nullopt;
  std::optional<ConvexHull> result = hullHolding(stretch.back(*points), hull.vertices);
  return result && result->vertices.size() <= max_vertices ? result : std::nullopt;
}

}  // namespace

ReducedHull reduceVertices(const ConvexHull& hull, int max_vertices) {
  constexpr int kLeastVertices = 8;
  if (max_vertices < kLeastVertices)
    throw Error(ErrorCode::kBadOption, "max_vertices is " + std::to_string(max_vertices) + "; a hull needs at least " +
                                           std::to_string(kLeastVertices) + " vertices, so that a box is always possible");
  const auto most = static_cast<std::size_t>(max_vertices);
  if (hull.vertices.size() <= most) return {hull, 0};
  std::optional<ConvexHull> outer = outerHull(hull, most);
  ReducedHull result{outer ? std::move(*outer) : orientedBox(hull), 0};
  result.hull.thickness = std::max(result.hull.thickness, hull.thickness);
  for (const Eigen::Vector3d& v : result.hull.vertices) result.added_distance = std::max(result.added_distance, distance(hull, v));
  return result;
}

}  // namespace collision_hulls
