// The largest distance over a hull is either on its surface or at a summit, a local maximum of the distance in the hull's interior. The
// surface is searched patch by patch (surface_search.h). Summits depend only on the solid: they lie in pockets between walls that face each
// other, and an octree shared by all hulls excludes the rest of space (outside_distance.h). The search runs in passes with a shrinking gap,
// so most hulls are dismissed by a floor that another hull sets. Convex parts need no octree: see boundInFreeHull().
#include "measure/protrusion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/looks.h"
#include "base/parallel.h"
#include "base/positive_length.h"
#include "geometry/hull_support.h"
#include "measure/halves_by_place.h"
#include "measure/outside_distance.h"
#include "measure/surface_search.h"

namespace collision_hulls {

namespace {

constexpr double kLooseGap = 16;  // gap of the first passes, in gaps of the last
constexpr int kGlance = 20;       // halvings
constexpr double kRough = 0.5;    // of the floor: gap of a search for summits before the last one, where there is a deadline
// If the search does not converge on a surface, as in the plane of an opening, it keeps the bound after this many halvings.
constexpr int kMostHalvings = 2'000'000;
// A bound of no more than kFewGaps gaps is not worth more halvings than this. For certificates, that many are a tenth of the tolerance.
constexpr int kPatience = 100'000;
constexpr double kFewGaps = 100;
constexpr double kEnough = 2;  // gaps: a search would hardly come closer than a bound that takes none
// Rounding error of a distance, as a share of the coordinates and of the mesh's extent: a hundred times what sums of a few products err by.
constexpr double kRounding = 1e-12;

/// [m] What rounding may hide. Points are rounded with the coordinates of the hulls, distances with the mesh's extent as well; hulls may
/// reach beyond their triangles, which are searched; and beside cracks and openings points may be taken for inside.
double rounding(const std::vector<ConvexHull>& hulls, const Solid& solid, const RunControl& control) {
  double size = solid.surface().extent(), beyond = 0;
  for (const ConvexHull& hull : hulls) {
    beyond = std::max(beyond, overhang(hull, control));
    for (const Eigen::Vector3d& v : hull.vertices) size = std::max(size, v.cwiseAbs().maxCoeff());
  }
  return hulls.empty() ? 0 : kRounding * size + beyond + solid.sideError();
}

double depthBelow(const HalfSpace& face, const Eigen::Vector3d& p) {
  return -face.distance(p);
}

/// [m] An upper bound on the distance to S of all points of a hull that the surface leaves free, and whose middle lies in S; infinite for
/// other hulls, and if it is more than `most`.
///
/// Why (lemma 10 of doc/certified.md): let no triangle reach deeper than e into the hull, and the middle c be deeper, by r. All that is as
/// deep as e is convex, and free of surface but for its border, so it lies in S, as c does. A vertex comes there straight from its faces,
/// or by e / r of its way to c; any other point of the hull, a mean of vertices, by the mean of their ways.
double boundInFreeHull(const ConvexHull& hull, const Solid& solid, double most, const RunControl& control) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (solid.hasOpenings() || solid.sideError() > 0) return kNone;  // S may end where there is no surface
  const Eigen::AlignedBox3d box = boundingBox(hull);
  const Eigen::Vector3d c = meanOfVertices(hull);
  double r = kNone, e = kRounding * std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  for (const HalfSpace& face : hull.faces) r = std::min(r, depthBelow(face, c));
  Looks look(control);
  for (const int t : solid.surface().trianglesNear(box)) {
    double reach = kNone;
    for (const HalfSpace& face : hull.faces) {
      look();
      double deepest = -kNone;
      for (const Eigen::Vector3d& corner : solid.surface().corners(t)) deepest = std::max(deepest, depthBelow(face, corner));
      reach = std::min(reach, deepest);
      if (reach <= e) break;
    }
    e = std::max(e, reach);
    if (e > most || e >= r) return kNone;
  }
  if (e >= r || !std::signbit(solid.signedDistance(c, solid.distanceToSurface(c)))) return kNone;  // not where the side of c is blurred
  double longest = 0;
  for (const Eigen::Vector3d& v : hull.vertices) {
    look();
    longest = std::max(longest, std::min(wayInto(hull, v, e), e / r * (c - v).norm()));
  }
  return longest;
}

/// Searches hulls for summits (lemma 4 of doc/certified.md). Many are searched in parallel, in halves that lie side by side; the halves do
/// not depend on the number of threads, and so neither does the result.
class Summits {
 public:
  /// `on_surface`: per hull, the result of searching its surface.
  /// `enough`: a bound that is no more than this need not be closer.
  Summits(const std::vector<ConvexHull>& hulls, const std::vector<Protrusion>& on_surface, const Solid& solid, double gap, double enough,
          const RunControl& control)
      : hulls_(hulls), on_surface_(on_surface), solid_(solid), gap_(gap), enough_(enough), control_(control) {}

  /// Adds those of some hulls to the worst; `spare`: visits beyond the usual, for all of them.
  void add(Protrusion& worst, const std::vector<std::size_t>& some, std::size_t spare) const {
    if (some.size() <= kTogether) return addOneByOne(worst, some, spare);
    const auto halves = halvesByPlace(hulls_, some);
    Protrusion other = worst;
    atOnce([&] { add(worst, halves.first, spare / 2); }, [&] { add(other, halves.second, spare / 2); });
    takeWorse(worst, other);
  }

 private:
  void addOneByOne(Protrusion& worst, const std::vector<std::size_t>& some, std::size_t spare) const {
    Eigen::AlignedBox3d box;
    for (const std::size_t i : some) box.extend(boundingBox(hulls_[i]));
    if (box.isEmpty()) return;
    OutsideDistance outside(solid_, box);
    OutsideDistance::Query query;
    query.floor = worst.bound + gap_;
    query.ceiling = std::numeric_limits<double>::infinity();
    query.resolution = gap_ / 4;
    query.summits_only = true;
    const std::size_t usual = query.most_visits;
    for (const std::size_t i : some) {
      if (const double bound = boundInFreeHull(hulls_[i], solid_, enough_, control_); bound <= enough_) {
        worst.bound = std::max(worst.bound, bound);
        continue;
      }
      query.most_visits = usual + spare;
      query.floor = std::max(query.floor, worst.found);
      query.surface_bound = on_surface_[i].bound;
      query.depth = leastWidth(hulls_[i], control_) / 2;
      const OutsideDistance::Largest largest = outside.largest(hulls_[i], query, control_);
      spare -= std::max(largest.visits, usual) - usual;
      Protrusion summit;
      summit.bound = largest.bound;
      if (largest.found > worst.found) {
        const TriangleBvh::Nearest n = solid_.surface().nearest(largest.where);
        summit.found = n.distance;  // largest.found is only a bound on it, from the middle of a cell
        summit.where = largest.where;
        summit.nearest = n.point;
        summit.hull = static_cast<int>(i);
      }
      takeWorse(worst, summit);
    }
  }

  const std::vector<ConvexHull>& hulls_;
  const std::vector<Protrusion>& on_surface_;
  const Solid& solid_;
  const double gap_, enough_;
  const RunControl& control_;
};

}  // namespace

Protrusion protrusion(const std::vector<ConvexHull>& hulls, const Solid& solid, double gap, const RunControl& control) {
  expectPositiveLength("the gap of a bound on the protrusion", gap);
  check(hulls, control);
  return protrusion(hulls, solid, {gap, 0, 0}, control);
}

Protrusion protrusion(const std::vector<ConvexHull>& hulls, const Solid& solid, const ProtrusionSearch& search, const RunControl& control) {
  // Vertices first: the distance they reach is a floor that spares the other hulls most of the search.
  double floor = search.floor;
  Looks look(control, kLargeItemsBetweenLooks);
  for (const ConvexHull& hull : hulls)
    for (const Eigen::Vector3d& v : hull.vertices)
      if (look(), solid.distanceToSurface(v) > floor) floor = std::max(floor, solid.distance(v));
  // Then all hulls at a glance, and more and more closely those that may reach further than what was found.
  struct Pass {
    double gap;
    int halvings;
  };
  std::vector<Protrusion> each(hulls.size());
  std::vector<double> given_up(hulls.size(), -1);  // floor above which the search of a hull did not converge: another would not, either
  const auto gap = [&] { return std::max(search.gap, search.share * floor); };
  for (const Pass pass : {Pass{kLooseGap, kGlance}, Pass{kLooseGap, kMostHalvings}, Pass{1, kMostHalvings}}) {
    const double wide = gap();
    forEach(hulls.size(), [&](std::size_t i) {
      SurfaceQuery query;
      query.floor = floor * (1 - 1e-9);
      query.gap = pass.gap * wide / 2;
      query.halvings = pass.halvings;
      query.patience = kPatience;
      query.low = kFewGaps * wide;
      if (each[i].hull >= 0 && (each[i].bound <= floor + query.gap || query.floor <= given_up[i])) return;
      Protrusion found = largestOnSurface(hulls[i], solid, query, control);
      if (pass.halvings == kMostHalvings && found.bound > std::max(found.found, query.floor) + query.gap) given_up[i] = query.floor;
      found.hull = static_cast<int>(i);
      if (found.found < each[i].found) {  // the place has fallen below the floor
        each[i].bound = std::max(found.bound, each[i].found);
        return;
      }
      each[i] = found;
    });
    for (const Protrusion& p : each) floor = std::max(floor, p.found);
  }
  Protrusion worst;
  for (const Protrusion& p : each) takeWorse(worst, p);
  std::vector<std::size_t> all(hulls.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const double enough = std::max(search.floor, search.share > 0 ? kEnough * gap() : gap() / 2);
  const double wide = kRough * floor;
  Protrusion rough = worst;  // for when time ends before each hull has been searched closely
  const bool may_end = control.until() != RunControl::Time::max() && search.floor == 0 && wide > gap() / 2;
  if (may_end) Summits(hulls, each, solid, wide, wide, control).add(rough, all, 0);
  Summits(hulls, each, solid, gap() / 2, enough, control).add(worst, all, search.spare_visits);
  if (may_end) {
    const double bound = std::min(worst.bound, rough.bound);
    if (rough.found > worst.found) worst = rough;
    worst.bound = std::max(bound, worst.found);
  }
  worst.bound += rounding(hulls, solid, control);
  return worst;
}

}  // namespace collision_hulls
