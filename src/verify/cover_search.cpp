// What lies in the union of the hulls is dropped by exact clipping (measure/cover.h). The rest is searched by branch and bound: the
// distance to one convex body is convex, so its maximum over a piece is at a corner, and so is that of the mean of two such distances,
// which bounds the smaller one. A surface in the middle between two bodies converges by the mean, one in a body by the single distance.
//
// The union with a mesh that is not convex is one solid, and the search of mesh_protrusion.h knows how to follow its surface.
#include "verify/cover_search.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>

#include "fit/enclosing.h"
#include "measure/cover.h"
#include "verify/mesh_protrusion.h"
#include "verify/round_shapes.h"

namespace collision_hulls {
namespace {

constexpr double kGap = 0.01;         // of what was found
constexpr int kMostPieces = 400'000;  // that a search halves; afterwards it ends with the bound that it has
constexpr int kPiecesBetweenChecks = 256;
constexpr std::size_t kNearBodies = 4;  // that bound a piece
constexpr double kRounding = 1e-12;     // of the coordinates' size: distances up to this are rounding errors

double sizeOf(const TriangleMesh& surface) {
  const Eigen::AlignedBox3d box = boundingBox(surface);
  return box.isEmpty() ? 0 : box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

/// Branch and bound over pieces of the surface, against convex bodies alone.
class Search {
 public:
  Search(const BodySet& bodies, double gap) : bodies_(bodies), gap_(gap) {}

  /// A convex polygon.
  void add(const std::vector<Eigen::Vector3d>& polygon) {
    for (const Eigen::Vector3d& p : polygon) visit(p);
    for (std::size_t i = 2; i < polygon.size(); ++i)
      push({{polygon[0], polygon[i - 1], polygon[i]}, std::numeric_limits<double>::infinity()});
  }

  Largest run(const RunControl& control) {
    for (int pieces = 0; pieces < kMostPieces && !queue_.empty() && queue_.top().bound > enough(); ++pieces) {
      if (pieces % kPiecesBetweenChecks == 0) control.check();
      halve();
    }
    best_.bound = std::max(best_.found, dropped_);
    if (!queue_.empty()) best_.bound = std::max(best_.bound, queue_.top().bound);
    return best_;
  }

 private:
  struct Piece {
    std::array<Eigen::Vector3d, 3> corner;
    double bound;
    bool operator<(const Piece& other) const { return bound < other.bound; }
  };

  double enough() const { return best_.found + std::max(gap_, kGap * best_.found); }

  void visit(const Eigen::Vector3d& p) {
    const double d = bodies_.distance(p);
    if (d > best_.found) best_.found = d, best_.where = p;
  }

  /// The bodies nearest to p.
  std::vector<std::size_t> nearest(const Eigen::Vector3d& p) const {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t b = 0; b < bodies_.boxes().size(); ++b) {
      if (near.size() == kNearBodies && bodies_.boxes()[b].exteriorDistance(p) >= near.back().first) continue;
      near.emplace_back(bodies_.convexDistance(b, p), b);
      std::sort(near.begin(), near.end());
      if (near.size() > kNearBodies) near.pop_back();
    }
    std::vector<std::size_t> result;
    for (const auto& item : near) result.push_back(item.second);
    return result;
  }

  void push(Piece piece) {
    const Eigen::Vector3d centre = (piece.corner[0] + piece.corner[1] + piece.corner[2]) / 3;
    visit(centre);
    const std::vector<std::size_t> near = nearest(centre);
    std::array<Eigen::Array3d, kNearBodies> distances;
    for (std::size_t i = 0; i < near.size(); ++i) {
      for (int k = 0; k < 3; ++k) distances[i][k] = bodies_.convexDistance(near[i], piece.corner[static_cast<std::size_t>(k)]);
      for (std::size_t j = 0; j <= i; ++j) piece.bound = std::min(piece.bound, (distances[i] + distances[j]).maxCoeff() / 2);
    }
    if (piece.bound > enough())
      queue_.push(piece);
    else
      dropped_ = std::max(dropped_, piece.bound);
  }

  void halve() {
    Piece piece = queue_.top();
    queue_.pop();
    std::size_t a = 0;
    const auto length = [&](std::size_t i) { return (piece.corner[i] - piece.corner[(i + 1) % 3]).squaredNorm(); };
    for (std::size_t i = 1; i < 3; ++i)
      if (length(i) > length(a)) a = i;
    const std::size_t b = (a + 1) % 3;
    const Eigen::Vector3d middle = (piece.corner[a] + piece.corner[b]) / 2;
    visit(middle);
    Piece other = piece;
    piece.corner[b] = other.corner[a] = middle;
    push(piece);
    push(other);
  }

  const BodySet& bodies_;
  const double gap_;
  double dropped_ = 0;
  Largest best_;
  std::priority_queue<Piece> queue_;
};

/// Against the convex bodies.
Largest furthestFromConvex(const BodySet& bodies, const TriangleMesh& surface, double gap, const RunControl& control) {
  if (bodies.boxes().empty()) return {std::numeric_limits<double>::infinity(), 0, Eigen::Vector3d::Zero()};
  Search search(bodies, gap);
  for (const std::vector<Eigen::Vector3d>& left : uncoveredPolygons(surface, bodies.hulls(), control)) search.add(left);
  Largest largest = search.run(control);
  if (largest.bound <= kRounding * sizeOf(surface)) largest = Largest();
  return largest;
}

/// Against everything as one solid.
Largest furthestFromWhole(const BodySet& bodies, const TriangleMesh& surface, double gap, const RunControl& control) {
  const Solid& solid = *bodies.whole();
  const Protrusion far = largestOnMesh(surface, solid, gap, control);
  Largest largest;
  largest.where = far.where;
  largest.found = std::max(0.0, far.found - bodies.innerError() - solid.weldDistance());
  largest.bound = far.bound + solid.weldDistance() + solid.sideError() + kRounding * (sizeOf(surface) + solid.surface().extent());
  return largest;
}

TriangleMesh joined(const std::vector<ConvexHull>& hulls, const TriangleMesh& rest) {
  TriangleMesh all = rest;
  for (const ConvexHull& hull : hulls) append(all, surface(hull));
  return all;
}

}  // namespace

BodySet::BodySet(const LinkBodies& bodies, const RunControl& control) : hulls_(bodies.hulls()) {
  for (const GeometryElement& primitive : bodies.primitives) {
    if (isRound(primitive))
      rounds_.push_back(primitive);
    else
      hulls_.push_back(hullAbout(primitive));
  }
  inner_ = hulls_;
  for (const ConvexHull& hull : hulls_) boxes_.push_back(boundingBox(hull));
  for (const GeometryElement& round : rounds_) {
    const Approximation inside = inscribed(round);
    inner_.push_back(inside.hull);
    inner_error_ = std::max(inner_error_, inside.error);
    boxes_.push_back(boundingBox(circumscribed(round).hull));
  }
  const TriangleMesh rest = bodies.rest();
  if (rest.triangles.empty()) return;
  rest_ = std::make_unique<Solid>(repair(rest, {}, control), control);
  whole_ = std::make_unique<Solid>(repair(joined(inner_, rest), {}, control), control);
}

double BodySet::convexDistance(std::size_t body, const Eigen::Vector3d& p) const {
  return body < hulls_.size() ? collision_hulls::distance(hulls_[body], p) : collision_hulls::distance(rounds_[body - hulls_.size()], p);
}

double BodySet::distance(const Eigen::Vector3d& p) const {
  double least = std::numeric_limits<double>::infinity();
  if (rest_) least = rest_->distance(p);
  for (std::size_t b = 0; b < boxes_.size() && least > 0; ++b)
    if (boxes_[b].exteriorDistance(p) < least) least = std::min(least, convexDistance(b, p));
  return least;
}

Largest furthestFrom(const BodySet& bodies, const TriangleMesh& surface, double gap, const RunControl& control) {
  const Largest convex = furthestFromConvex(bodies, surface, gap, control);
  if (!bodies.whole() || convex.bound == 0) return convex;
  Largest all = furthestFromWhole(bodies, surface, gap, control);
  all.bound = std::min(all.bound, convex.bound);
  return all;
}

}  // namespace collision_hulls
