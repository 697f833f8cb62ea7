// From within, then outward:
//
//   inner hull: start with the extreme points along the axes;
//     until there are max_vertices points, add the hull's vertices furthest outside the inner hull, as quickhull does
//   rise: move each vertex of the inner hull out, beyond the hull's supporting planes parallel to the faces around it
//   sink: lower each again as far as the faces around it can turn before they cut into the hull
//   relax, unless the result is already close and for as long as it helps: move the vertices half way to the mean of their neighbours,
//     rise and sink again; keep the result that protrudes least
//
// All corners of a moved face lie beyond a supporting plane, so no face meets the hull's interior, and the hull stays inside. Collapsing
// edges outward (progressive hulls) was tried instead: it protruded nearly twice as far on round hulls.
#include "collision_hulls/decompose/reduce_vertices.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>

#include "collision_hulls/error.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "decompose/bounding_box.h"
#include "decompose/lowest_point.h"
#include "geometry/hull_support.h"

namespace collision_hulls {

namespace {

using Points = std::vector<Eigen::Vector3d>;

// A hull is stretched where it is thinner than this share of its length, to keep rounding from deciding anything.
constexpr double kThinnest = 0.01;
// Each round adds all points that lie outside by this share of the largest such distance: a lower share is faster and worse.
constexpr double kShareOfFurthest = 0.5;
// Points outside the inner hull by less than this share of the extent are not worth a vertex.
constexpr double kNegligible = 1e-9;
// Attempts to space the vertices more evenly, unless all are closer to the hull than this share of its extent: it is round hulls that gain,
// and those of few vertices are further away than that.
constexpr int kRelaxations = 12;
constexpr int kPatience = 3;  // attempts in a row that bring nothing closer
constexpr double kNearEnough = 0.02;

Eigen::Vector3d areaVector(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return (b - a).cross(c - a) / 2;
}

/// The extreme vertices of a hull along the axes.
Points extremeVertices(const ConvexHull& hull, const HullSupport& support) {
  Points result;
  int last = 0;
  for (int k = 0; k < 3; ++k)
    for (const double sign : {-1.0, 1.0}) {
      last = support.furthest(sign * Eigen::Vector3d::Unit(k), last);
      result.push_back(hull.vertices[static_cast<std::size_t>(last)]);
    }
  return result;
}

/// The vertices of a hull that are furthest beyond the faces of another one, each once, with that distance; furthest first.
std::vector<std::pair<double, int>> furthestBeyond(const ConvexHull& inner, const ConvexHull& hull, const HullSupport& support) {
  std::vector<std::pair<double, int>> furthest;
  int last = 0;
  for (const HalfSpace& face : inner.faces) {
    last = support.furthest(face.normal, last);
    furthest.emplace_back(-face.distance(hull.vertices[static_cast<std::size_t>(last)]), last);
  }
  std::sort(furthest.begin(), furthest.end());
  std::vector<std::pair<double, int>> unique;
  std::unordered_set<int> seen;
  for (const auto& [depth, v] : furthest)
    if (seen.insert(v).second) unique.emplace_back(-depth, v);
  return unique;
}

/// The hull of well-chosen vertices of a hull.
ConvexHull innerHull(const ConvexHull& hull, const HullSupport& support, std::size_t max_vertices) {
  const double negligible = kNegligible * boundingBox(hull).sizes().maxCoeff();
  ConvexHull inner = convexHull(extremeVertices(hull, support));
  while (inner.vertices.size() < max_vertices) {
    const std::vector<std::pair<double, int>> furthest = furthestBeyond(inner, hull, support);
    const double least = std::max(kShareOfFurthest * furthest.front().first, negligible);
    Points more = inner.vertices;
    for (const auto& [distance, v] : furthest)
      if (distance > least && more.size() < max_vertices) more.push_back(hull.vertices[static_cast<std::size_t>(v)]);
    ConvexHull larger = convexHull(more);
    if (larger.vertices.size() <= inner.vertices.size()) break;  // nothing to add, or rounding dropped it
    inner = std::move(larger);
  }
  return inner;
}

/// The hull to be contained.
struct Held {
  Held(const ConvexHull& the_hull, const RunControl& control)
      : hull(the_hull), support(hull), surface(collision_hulls::surface(hull), {}, control) {}
  const Eigen::Vector3d& vertex(int i) const { return hull.vertices[static_cast<std::size_t>(i)]; }

  const ConvexHull& hull;
  HullSupport support;
  TriangleBvh surface;
};

/// A closed surface around a hull, with vertices that move.
class OuterSurface {
 public:
  OuterSurface(const ConvexHull& start, const Held& held)
      : vertices_(start.vertices), triangles_(start.triangles), around_(start.vertices.size()), held_(held) {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (int v : triangles_[t]) around_[v].push_back(static_cast<int>(t));
  }

  /// Moves every vertex half way to the mean of its neighbours.
  void relax() {
    Points relaxed;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int t : around_[v])
        for (int n : triangles_[t]) sum += vertices_[n];
      const auto count = static_cast<double>(around_[v].size());  // neighbours; the sum has each twice, and v in every triangle
      relaxed.push_back(vertices_[v] / 2 + (sum - count * vertices_[v]) / (4 * count));
    }
    vertices_ = std::move(relaxed);
  }

  /// Moves every vertex out to where it is beyond the supporting planes of all faces around it; false if some vertex has no such place.
  bool rise() {
    std::vector<HalfSpace> touching;
    for (const Triangle& t : triangles_) {
      const Eigen::Vector3d normal = areaVector(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]).normalized();
      last_ = held_.support.furthest(normal, last_);
      touching.push_back({normal, std::max(normal.dot(vertices_[t[0]]), normal.dot(held_.vertex(last_)))});
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

  void sink() {
    for (std::size_t v = 0; v < vertices_.size(); ++v) sink(static_cast<int>(v));
  }

  ConvexHull hull() const { return convexHull(vertices_); }

 private:
  /// Moves a vertex to where its faces contain the hull and as little else as possible, unless that takes it further from the hull. Each
  /// face turns about the edge opposite the vertex, so the vertex must stay beyond the plane through that edge that touches the hull.
  void sink(int v) {
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
    if (!x) return;
    const TriangleBvh::Nearest own = held_.surface.nearest(vertices_[v]);
    if (held_.surface.nearest(*x, std::numeric_limits<double>::infinity(), own.triangle).distance <= own.distance) vertices_[v] = *x;
  }

  /// The length of the longest edge at a vertex.
  double reach(int v) const {
    double furthest = 0;
    for (int t : around_[v])
      for (int n : triangles_[t]) furthest = std::max(furthest, (vertices_[n] - vertices_[v]).norm());
    return furthest;
  }

  /// A point near a vertex beyond all planes: the lowest along the faces' mean normal, or the one that adds the least volume, whichever is
  /// nearer.
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

  /// The plane through a and b that is lowest at x and has the hull below it; nullopt if a, b and x are collinear.
  ///
  /// Its slope is the largest slope from the edge to any vertex (Dinkelbach 1967): the vertex furthest beyond the plane of one slope gives
  /// a larger slope, until there is none.
  std::optional<HalfSpace> touchingPlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& x) {
    constexpr double kInLine = 1e-9;
    constexpr int kMostSteps = 30;
    const Eigen::Vector3d along = (b - a).normalized(), normal = (b - a).cross(x - a);
    if (!(normal.norm() > kInLine * (b - a).norm() * (x - a).norm())) return std::nullopt;
    const Eigen::Vector3d up = normal.normalized(), toward = up.cross(along);
    double slope = 0;  // of the plane abx; the first support point gives a slope low enough to start with
    for (int step = 0; step < kMostSteps; ++step) {
      last_ = held_.support.furthest(up - slope * toward, last_);
      const double run = toward.dot(held_.vertex(last_) - a), rise = up.dot(held_.vertex(last_) - a);
      if (step > 0 && !(run > 0 && rise > slope * run)) break;
      slope = run > 0 ? rise / run : -1 / kInLine;
    }
    const Eigen::Vector3d turned = (up - slope * toward).normalized();
    return HalfSpace{turned, turned.dot(a)};
  }

  Points vertices_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<int>> around_;  // per vertex: its triangles
  const Held& held_;
  int last_ = 0;  // the support point found last
};

/// The hull of the vertices of `start` after they have risen beyond `held` and sunk again; nullopt if one cannot rise.
std::optional<ConvexHull> risenAndSunk(const ConvexHull& start, const Held& held) {
  OuterSurface surface(start, held);
  if (!surface.rise()) return std::nullopt;
  OuterSurface risen(surface.hull(), held);
  risen.sink();
  return risen.hull();
}

double largestDistance(const ConvexHull& outer, const Held& held) {
  double most = 0;
  for (const Eigen::Vector3d& v : outer.vertices) most = std::max(most, held.surface.nearest(v).distance);
  return most;
}

/// Points whose hull contains `hull`; nullopt if that fails.
std::optional<Points> outerPoints(const ConvexHull& hull, std::size_t max_vertices, const RunControl& control) {
  const Held held(hull, control);
  std::optional<ConvexHull> outer = risenAndSunk(innerHull(hull, held.support, max_vertices), held);
  if (!outer) return std::nullopt;
  Points best = outer->vertices;
  double least = largestDistance(*outer, held);
  const double enough = kNearEnough * boundingBox(hull).sizes().maxCoeff();
  int best_attempt = 0;
  for (int attempt = 1; attempt <= kRelaxations && attempt <= best_attempt + kPatience && least > enough; ++attempt) {
    control.check();
    OuterSurface relaxed(*outer, held);
    relaxed.relax();
    outer = risenAndSunk(relaxed.hull(), held);
    if (!outer || outer->vertices.size() > max_vertices) break;
    const double most = largestDistance(*outer, held);
    if (most < least) least = most, best = outer->vertices, best_attempt = attempt;
  }
  return best;
}

/// An affine map that thickens thin sets. It preserves containment and the order of volumes.
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

std::optional<ConvexHull> outerHull(const ConvexHull& hull, std::size_t max_vertices, const RunControl& control) {
  const Stretch stretch(hull.vertices);
  const std::optional<Points> points = outerPoints({stretch.forward(hull.vertices), hull.triangles, {}, 0, 0}, max_vertices, control);
  if (!points) return std::nullopt;
  std::optional<ConvexHull> result = hullHolding(stretch.back(*points), hull.vertices, control);
  return result && result->vertices.size() <= max_vertices ? result : std::nullopt;
}

}  // namespace

ConvexHull reduceVertices(const ConvexHull& hull, int max_vertices, const RunControl& control) {
  if (max_vertices < kLeastVertices)
    throw Error(ErrorCode::kBadOption, "max_vertices is " + std::to_string(max_vertices) + "; a hull needs at least " +
                                           std::to_string(kLeastVertices) + " vertices: with that many, a box is always possible");
  const auto most = static_cast<std::size_t>(max_vertices);
  if (hull.vertices.size() <= most) return hull;
  std::optional<ConvexHull> outer = outerHull(hull, most, control);
  ConvexHull result = outer ? std::move(*outer) : orientedBox(hull, control);
  result.thickness = std::max(result.thickness, hull.thickness);
  return result;
}

bool exceedsCap(const ConvexHull& hull, int max_vertices) {
  return max_vertices > 0 && hull.vertices.size() > static_cast<std::size_t>(max_vertices);
}

ConvexHull capped(const ConvexHull& hull, int max_vertices, const RunControl& control) {
  return exceedsCap(hull, max_vertices) ? reduceVertices(hull, max_vertices, control) : hull;
}

double addedDistance(const ConvexHull& outer, const ConvexHull& hull, const RunControl& control) {
  const TriangleBvh skin(surface(hull), {}, control);
  double most = 0;
  for (const Eigen::Vector3d& v : outer.vertices) {
    control.check();
    if (planeDistance(hull, v) > 0) most = std::max(most, skin.nearest(v).distance);
  }
  return most;
}

}  // namespace collision_hulls
