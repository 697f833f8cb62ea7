// Decompose, complete the cover, certify; if the certificate of the method `certified` exceeds the tolerance, try again with a lower aim,
// at most kAttempts times, and keep the best. The gap between the certificate's bounds is narrowed only where it decides.
#include "pipeline/mesh_hulls.h"

#include <algorithm>

#include "base/stopwatch.h"
#include "collision_hulls/decompose/fit_cover.h"
#include "collision_hulls/decompose/reduce_vertices.h"
#include "measure/protrusion.h"

namespace collision_hulls {

namespace {

// The aim is below the tolerance by this many margins, for the margin and rounding, but never below this share of the tolerance.
constexpr double kMargins = 3, kLeastAim = 0.5;
// Hulls as written may protrude a little further than those searched for, and much further near openings of the surface, where the distance
// to the solid jumps. The next aim is lower by that excess and a little more, but not below kLowerAim of the last aim.
constexpr int kAttempts = 3;
constexpr double kLowerAim = 0.8, kALittleLower = 0.99;
// The gap between the bounds may be all that takes the upper one above the tolerance. Then it is narrowed: least share of the usual gap for
// which that is tried, and the extra effort spent.
constexpr double kLeastGap = 0.1;
constexpr std::size_t kSpareVisits = 500'000;

/// The coarsest cut whose hulls keep the tolerance even after their vertices are reduced; leaves are accepted in any case.
std::vector<int> fittingCut(const HullTree& tree, const DecomposeOptions& options) {
  std::vector<int> open = tree.cutAt(options.tolerance), cut;
  while (!open.empty()) {
    const int id = open.back();
    const HullNode& node = tree.nodes[static_cast<std::size_t>(id)];
    open.pop_back();
    const bool fits = node.left < 0 || options.max_vertices == 0 ||
                      node.protrusion + addedDistance(reduceVertices(node.hull, options.max_vertices), node.hull) <= options.tolerance;
    if (fits)
      cut.push_back(id);
    else
      open.insert(open.end(), {node.left, node.right});
  }
  return cut;
}

Decomposition hullsFrom(const HullTree& tree, const DecomposeOptions& options) {
  std::vector<int> cut = fittingCut(tree, options);
  Decomposition result;
  result.capped = options.max_hulls > 0 && cut.size() > static_cast<std::size_t>(options.max_hulls);
  if (result.capped) cut = tree.cutTo(options.max_hulls);
  result.hulls = tree.hullsOf(cut);
  if (options.max_vertices > 0)
    for (ConvexHull& hull : result.hulls) hull = reduceVertices(hull, options.max_vertices);
  return result;
}

/// The aim of the next attempt; `over` is the last bound over the tolerance.
double lowerAim(double aim, int attempt, double over) {
  return aim * (attempt == 0 ? std::max(kLowerAim, kALittleLower / over) : kLowerAim);
}

}  // namespace

Protrusion certificate(const std::vector<ConvexHull>& hulls, const Solid& solid, double margin, double tolerance,
                       const RunControl& control) {
  const double gap = kCertificateGap * tolerance;
  Protrusion result = protrusion(hulls, solid, gap, control);
  const double room = tolerance - margin - result.found;
  if (result.bound + margin > tolerance && room > kLeastGap * gap)
    result = protrusion(hulls, solid, {std::min(gap, room / 2), kSpareVisits}, control);
  result.bound += margin;
  return result;
}

MeshHulls meshHulls(const MeshSource& source, const DecomposeOptions& options, StageSeconds& seconds, const RunControl& decomposing,
                    const RunControl& certifying, const HullTree* tree) {
  Stopwatch stage;
  MeshHulls best;
  DecomposeOptions aim = options;
  if (options.method == Method::kCertified)
    aim.tolerance = std::max(kLeastAim * options.tolerance, options.tolerance - kMargins * source.margin);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Decomposition parts = tree ? hullsFrom(*tree, aim) : decompose(source.repaired, aim, decomposing);
    FittedHulls fitted = fitCover(parts.hulls, source.original, source.margin, options.max_vertices, decomposing);
    seconds.decompose += stage.lap();
    MeshHulls result{std::move(fitted.hulls), {}, fitted.nudge, 0, parts.capped, fitted.blunted};
    result.protrusion = certificate(result.hulls, source.solid, source.margin, options.tolerance, certifying);
    for (const ConvexHull& hull : parts.hulls) result.thickness = std::max(result.thickness, hull.thickness);
    seconds.certify += stage.lap();
    if (attempt > 0 && result.protrusion.bound >= best.protrusion.bound) break;
    best = std::move(result);
    if (options.method != Method::kCertified || best.capped || best.protrusion.bound <= options.tolerance) break;
    aim.tolerance = lowerAim(aim.tolerance, attempt, best.protrusion.bound / options.tolerance);
  }
  return best;
}

}  // namespace collision_hulls
