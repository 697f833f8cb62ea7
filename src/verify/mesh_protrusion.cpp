// The surface is searched as a hull's is (measure/surface_search.h). The largest distance over the inside is there too, or at a summit, a
// local maximum of the distance. An octree looks for those: it drops cells that lie outside of the body, that are near enough to the
// solid, or that hold no summit. Where the body has openings its border is not all surface, so that summits do not suffice, and all of the
// inside counts. Cracks are so narrow that their width is added instead.
#include "verify/mesh_protrusion.h"

#include <algorithm>
#include <limits>
#include <queue>

#include "collision_hulls/mesh/repair.h"
#include "measure/surface_search.h"

namespace collision_hulls {
namespace {

constexpr double kGapShare = 0.01;  // of what was found
constexpr double kLooseGap = 16;    // gap of the first pass, in gaps of the second
constexpr int kMostHalvings = 400'000, kMostCells = 200'000, kCellsBetweenChecks = 64;
constexpr double kCoordinateRounding = 1e-12;  // of the coordinates' size, as kRounding in measure/protrusion.cpp
constexpr double kMargin = 1.0001;             // of the root, so that rounding leaves nothing outside

struct Cell {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double half = 0;  // [m] half a side
  double bound = 0;
  bool operator<(const Cell& other) const { return bound < other.bound; }
};

/// The search inside a body for points further from the solid than anything on its surface.
class Inside {
 public:
  Inside(const Solid& body, const Solid& solid, const Protrusion& on_surface, double gap)
      : body_(body), solid_(solid), best_(on_surface), limit_(on_surface.bound), gap_(gap), all_counts_(body.hasOpenings()) {}

  Protrusion run(const Eigen::AlignedBox3d& box, const RunControl& control) {
    push({box.center(), kMargin * box.sizes().maxCoeff() / 2, 0});
    for (int step = 0; step < kMostCells && !queue_.empty() && queue_.top().bound > enough(); ++step) {
      if (step % kCellsBetweenChecks == 0) control.check();
      divide();
    }
    best_.bound = std::max(limit_, best_.found);
    if (!queue_.empty()) best_.bound = std::max(best_.bound, queue_.top().bound);
    return best_;
  }

 private:
  /// Cells up to this do not matter.
  double enough() const { return std::max(limit_, best_.found + std::max(gap_, kGapShare * best_.found)); }

  void push(Cell cell) {
    const Eigen::Vector3d& c = cell.centre;
    const double radius = cell.half * std::sqrt(3.0);
    const TriangleBvh::Nearest near = solid_.surface().nearest(c);
    const double outside = solid_.signedDistance(c, near.distance);
    cell.bound = solid_.distanceWithin(radius, outside, near.distance);
    if (cell.bound <= enough()) return settle(cell.bound);
    const double to_body = body_.distanceToSurface(c);
    if (body_.isFurther(radius, c, to_body)) return;
    if (!all_counts_ && !solid_.mayHoldSummit(c, near.distance, radius)) return;
    const double found = body_.contains(c) ? outside : 0;
    if (found > best_.found) best_.found = found, best_.where = c, best_.nearest = near.point;
    queue_.push(cell);
  }

  void settle(double bound) { limit_ = std::max(limit_, bound); }

  void divide() {
    const Cell cell = queue_.top();
    queue_.pop();
    const double half = cell.half / 2;
    for (int i = 0; i < 8; ++i) push({cell.centre + half * Eigen::Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1), half, 0});
  }

  const Solid &body_, &solid_;
  Protrusion best_;
  double limit_;  // [m] what is settled lies within this
  const double gap_;
  const bool all_counts_;
  std::priority_queue<Cell> queue_;
};

}  // namespace

Protrusion largestOnMesh(const TriangleMesh& mesh, const Solid& solid, double gap, const RunControl& control) {
  SurfaceQuery query;
  query.halvings = kMostHalvings;
  query.gap = kLooseGap * gap;
  const Protrusion first = largestOnSurface(mesh.vertices, mesh.triangles, solid, query, control);
  query.gap = std::max(gap, kGapShare * first.found);
  if (first.bound <= first.found + query.gap) return first;
  query.floor = first.found * (1 - 1e-9);
  Protrusion second = largestOnSurface(mesh.vertices, mesh.triangles, solid, query, control);
  second.bound = std::max({std::min(second.bound, first.bound), first.found, second.found});
  return second.found >= first.found ? second : Protrusion{second.bound, first.found, first.where, first.nearest, first.hull};
}

Protrusion meshProtrusion(const TriangleMesh& mesh, const Solid& body, const Solid& solid, double gap, const RunControl& control) {
  Protrusion result = largestOnMesh(mesh, solid, gap, control);
  const Eigen::AlignedBox3d box = boundingBox(mesh);
  if (body.interior() != Interior::kSurface) {
    result = Inside(body, solid, result, gap).run(box, control);
    // Lids close the body's cracks. They lie within two widths of its surface, and nothing else was searched of the inside's border.
    if (!body.hasOpenings() && body.sideError() > 0) result.bound += 2 * RepairOptions{}.weld_tolerance * body.surface().extent();
  }
  const double size = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  result.bound += kCoordinateRounding * (size + solid.surface().extent()) + solid.sideError() + body.sideError() + body.weldDistance();
  return result;
}

}  // namespace collision_hulls
