// Two points whose segment leaves the solid by more than the tolerance cannot share a hull: they are apart. So are three whose triangle
// does. Points that cannot be shared out to n sets without any that are apart need more than n hulls.
//
//   points = one that only it holds for hulls of a known cover, and others spread over the surface         least/witnesses.h
//   pairs  = the graph of those that are apart                                                            least/apart.h, least/pairs.h
//   n      = size of the largest clique found: each of its points needs a hull of its own                 least/clique.h
//   while n colours provably do not suffice for the graph: n + 1                                          least/colouring.h
//   the same with triples, for few points: while they can be shared out to n sets, add the point          least/sharing.h
//     that most of these sets refuse, until there are enough; if they cannot, n + 1
//
// What is proved for a few points holds for the surface. All limits, of points and of steps, cost sharpness and never validity. Most of
// the time goes into the pairs: O(points^2) searches along a segment, of O(log triangles) per look. With Effort::kQuick that is about a
// twentieth of what the decomposition takes.
//
// Tried and given up: points near those of the clique in a second graph (three times the time, hardly ever a larger clique); only vertices
// (flat faces have none in their middle), or only spread points (they miss the tips of small teeth).
#include "collision_hulls/decompose/least_hulls.h"

#include <algorithm>
#include <limits>

#include "base/parallel.h"
#include "decompose/finest_tolerance.h"
#include "decompose/least/apart.h"
#include "decompose/least/clique.h"
#include "decompose/least/colouring.h"
#include "decompose/least/pairs.h"
#include "decompose/least/sharing.h"
#include "decompose/least/witnesses.h"

namespace collision_hulls {

namespace {

/// How hard to look.
struct Plan {
  std::size_t candidates;  // half of them vertices; points are chosen from these
  std::size_t own;         // points in the graph, one for each known hull, at most
  std::size_t spread;      // points in the graph beside those
  std::size_t more;        // points beside the graph's that may be shared out
  std::size_t shared;      // points that are shared out, at most
  long steps;              // of each search in the graph
  Sharing::Limits sharing;
};
constexpr Plan kQuickPlan{600, 96, 48, 0, 24, 1'000, {200, 1'000}};
constexpr Plan kBestPlan{4'000, 1'000, 320, 600, Sharing::kMostPoints, 20'000, {10'000, 20'000}};

/// [m] Of the coordinates.
double sizeOf(const Points& points) {
  double size = 0;
  for (const Eigen::Vector3d& p : points) size = std::max(size, p.cwiseAbs().maxCoeff());
  return size;
}

/// Raises the bound for as long as few points cannot be shared out to so many sets.
std::size_t raisedBySharing(std::size_t least, std::size_t enough, const std::vector<std::size_t>& clique, std::size_t most_points,
                            Sharing sharing, const RunControl& control) {
  if (clique.size() > most_points) return least;
  for (const std::size_t point : clique) sharing.add(point);
  while (least < enough) {
    control.check();
    if (sharing.needsMoreThan(least)) {
      ++least;
    } else {
      if (sharing.size() >= most_points) return least;
      sharing.add(sharing.mostRefused());
    }
  }
  return least;
}

}  // namespace

std::size_t leastHulls(const TriangleMesh& mesh, const Solid& solid, double tolerance, const std::vector<ConvexHull>& known, Effort effort,
                       const RunControl& control) {
  if (mesh.triangles.empty()) throw Error(ErrorCode::kEmptyMesh, "the mesh has no triangles; a bound on its hulls needs at least one");
  check(mesh, control);
  expectUsable(tolerance, mesh);
  if (known.size() == 1 || effort == Effort::kInstant) return 1;
  const std::size_t enough = known.empty() ? std::numeric_limits<std::size_t>::max() : known.size();
  const Plan& plan = effort == Effort::kBest ? kBestPlan : kQuickPlan;
  const SurfacePoints candidates = surfacePoints(mesh, plan.candidates / 2);
  Points points = spreadOf(ownPoints(candidates.all, known), plan.own);
  addSpread(candidates, plan.spread, points);
  const std::size_t in_graph = points.size();
  addSpread(candidates, plan.more, points);
  const Apart apart(solid, tolerance, sizeOf(points));
  PairTest pairs(points, known, apart);
  const Graph& graph = pairs.graphOf(in_graph, control);
  const std::vector<std::size_t> clique = largestClique(graph, enough, plan.steps);
  std::size_t least = clique.size();
  while (least < enough && needsMoreColours(graph, clique, least, plan.steps)) ++least;
  return raisedBySharing(least, enough, clique, std::min(plan.shared, points.size()), {points, pairs, apart, plan.sharing}, control);
}

}  // namespace collision_hulls
