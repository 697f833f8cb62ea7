// Does this hull protrude further than the tolerance? Tests in order of cost; each may end the matter:
//
//   1. intruders remembered from earlier hulls: a hull that contains one does not fit. Useful ones move to the front, and the first of
//      them are looked for before the hull is built;
//   2. some steps down the octree of outside distances, shared by all hulls (measure/outside_distance.h): refutes by a point, or bounds
//      the protrusion;
//   3. if that bound is too coarse to prove that the hull fits: branch and bound over its surface (measure/surface_search.h), except for
//      facets that earlier hulls had as well;
//   4. and, for a proof, a search for pockets, summits of the distance inside the hull that lie further out than anything on its surface.
//      It is a glance unless pockets are to be proved: where little is known about the surface, the proof for one hull takes longer than
//      all else, and most hulls do not remain.
//
// Why 2 alone will not do: the octree's cells would have to be a few hundredths of the tolerance wide, and a dense grid of distances was
// the bottleneck of the first prototypes; where a hull spans a large wall at nearly the tolerance, even coarse cells are many thousands.
// Why not 3 alone: most hulls are refuted, and for that one point is enough.
//
// The answer that a hull fits is a proof up to the assumptions in doc/certified.md. It is not the certificate: that is computed once more,
// from scratch, for the hulls as they are written.
#include "decompose/certified/protrusion_oracle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "base/at.h"
#include "base/parallel.h"
#include "base/random.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "geometry/hull_membership.h"
#include "geometry/hull_support.h"
#include "measure/halves_by_place.h"
#include "measure/surface_search.h"

namespace collision_hulls {

namespace {

// The following are shares of the tolerance.
constexpr double kReserve = 0.0015;      // reserved for the certificate: more than kProofGap and its own gap together
constexpr double kProofGap = 0.0004;     // between the bounds of a proof,
constexpr double kQuickGap = 0.1;        // and of a quick answer
constexpr double kQuickCell = 1;         // radius of the smallest octree cells: for a quick answer,
constexpr double kFineCell = 0.42;       // before a proof (for leaves, whose share of the tolerance is smaller, this is a proof),
constexpr double kIntruderCell = 0.125;  // and for intruders
constexpr double kPocketCell = 0.001;    // where the search for pockets ends
constexpr double kShallow = 0.9;         // to know that a hull's surface is nearer than this hardly helps that search
constexpr double kLooseGap = 0.005;      // between the bounds of large protrusions

static_assert(kReserve > kProofGap + kCertificateGap, "the certificate would need a second, closer search");

constexpr double kLooseShare = 0.01;        // the same as a share of the protrusion itself
constexpr int kLooseHalvings = 100'000;     // of patches, at most, for such a bound
constexpr double kIntoHull = 1e-9;          // how far, on the way to a vertex, intruders on a hull's surface are moved into it
constexpr double kGrowth = 1e-5;            // growth of a hull to allow for rounding when it is written
constexpr std::size_t kSharesOfHulls = 16;  // at most, that are searched side by side: each copies what is known of its space
constexpr std::size_t kMostKnown = 400;     // intruders remembered,
constexpr std::size_t kUseful = 16;         // and those of them that are looked at before a hull is built

// Visits to the octree's cells before a hull's surface is searched: for each facet that no earlier hull had, and for the others together.
constexpr std::size_t kVisitsPerFacet = 1, kLeastVisits = 30;
// The same for a glance at pockets.
constexpr std::size_t kPocketGlance = 300;

ConvexHull grown(ConvexHull hull) {
  const Eigen::Vector3d middle = boundingBox(hull).center();
  for (Eigen::Vector3d& v : hull.vertices) v += kGrowth * (v - middle);
  for (HalfSpace& face : hull.faces) face.offset -= kGrowth * face.distance(middle);
  return hull;
}

}  // namespace

ConvexHull thinned(const ConvexHull& hull, std::size_t most) {
  if (hull.vertices.size() <= 2 * most || hull.thickness > 0) return hull;
  constexpr double kGoldenAngle = 2.39996322972865332;
  const HullSupport support(hull);
  std::vector<int> chosen;
  int at = 0;
  for (std::size_t i = 0; i < most; ++i) {  // directions on a spiral from pole to pole
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(most), turn = kGoldenAngle * static_cast<double>(i);
    const double r = std::sqrt(1 - z * z);
    at = support.furthest({r * std::cos(turn), r * std::sin(turn), z}, at);
    chosen.push_back(at);
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  std::vector<Eigen::Vector3d> points;
  for (int v : chosen) points.push_back(hull.vertices[static_cast<std::size_t>(v)]);
  return roughHull(points);
}

ProtrusionOracle::ProtrusionOracle(const Solid& solid, const Eigen::AlignedBox3d& box, double tolerance, const RunControl& control,
                                   const std::vector<Region>& regions)
    : solid_(solid), control_(control), box_(box), tolerance_(tolerance), outside_(solid, box) {
  for (const Region& region : regions)
    if (region.tolerance < tolerance)
      watches_.push_back({region, region.tolerance / tolerance, std::make_unique<ProtrusionOracle>(solid, box, region.tolerance, control)});
}

ProtrusionOracle ProtrusionOracle::forPart(const Eigen::AlignedBox3d& part) const {
  ProtrusionOracle result(solid_, box_, tolerance_, control_);
  result.share_ = share_;
  result.proves_pockets_ = proves_pockets_;
  result.outside_.learn(outside_, part);
  std::copy_if(known_.begin(), known_.end(), std::back_inserter(result.known_), [&](const Eigen::Vector3d& p) { return part.contains(p); });
  for (const Watch& watch : watches_)
    result.watches_.push_back({watch.region, watch.ratio, std::make_unique<ProtrusionOracle>(watch.oracle->forPart(part))});
  return result;
}

/// Merges the remembered intruders; the most useful of both stay in front.
void ProtrusionOracle::learn(const ProtrusionOracle& part) {
  outside_.learn(part.outside_, box_);
  facets_.learn(part.facets_);
  for (std::size_t i = 0; i < watches_.size(); ++i) watches_[i].oracle->learn(*part.watches_[i].oracle);
  const std::vector<Eigen::Vector3d> mine = std::move(known_);
  known_.clear();
  for (std::size_t i = 0; i < std::max(mine.size(), part.known_.size()); ++i)
    for (const auto* some : {&mine, &part.known_})
      if (i < some->size() && known_.size() < kMostKnown && std::find(known_.begin(), known_.end(), (*some)[i]) == known_.end())
        known_.push_back((*some)[i]);
}

void ProtrusionOracle::setTolerance(double tolerance) {
  tolerance_ = tolerance;
  known_.clear();
  for (const Watch& watch : watches_) watch.oracle->setTolerance(watch.ratio * tolerance);
}

void ProtrusionOracle::setShare(double share) {
  share_ = share;
  known_.clear();
  for (const Watch& watch : watches_) watch.oracle->setShare(share);
}

double ProtrusionOracle::intrusion() const {
  return share_ * (1 - kReserve) * tolerance_;
}

/// Asks about the parts of the hull in the regions. Whatever refutes a part refutes the hull.
bool ProtrusionOracle::holdsInRegions(const ConvexHull& hull, const Question& question) {
  return std::all_of(watches_.begin(), watches_.end(), [&](Watch& watch) {
    const std::optional<ConvexHull> part = partIn(hull, watch.region);
    return !part || question(*watch.oracle, *part);
  });
}

bool ProtrusionOracle::mayFit(const ConvexHull& hull) {
  return mayFit(hull, descend(hull, kQuickCell)) &&
         holdsInRegions(hull, [](ProtrusionOracle& oracle, const ConvexHull& part) { return oracle.mayFit(part); });
}

bool ProtrusionOracle::mayWellFit(const ConvexHull& hull) {
  return mayFit(hull, descend(hull, kFineCell)) &&
         holdsInRegions(hull, [](ProtrusionOracle& oracle, const ConvexHull& part) { return oracle.mayWellFit(part); });
}

double ProtrusionOracle::reach(const ConvexHull& hull) {
  const double reach = descend(hull, kFineCell).reach;
  const auto may_fit = [](ProtrusionOracle& oracle, const ConvexHull& part) { return oracle.mayWellFit(part); };
  return std::isinf(reach) || holdsInRegions(hull, may_fit) ? reach : std::numeric_limits<double>::infinity();
}

/// Searches the surface where the octree gave up.
bool ProtrusionOracle::mayFit(const ConvexHull& hull, const Descent& descent) {
  if (std::isinf(descent.reach) || !descent.gave_up) return !std::isinf(descent.reach);
  const Protrusion most = onSurface(hull, intrusion(), kQuickGap * share_ * tolerance_);
  if (most.found > intrusion()) {
    rememberOnSurface(most.where, hull);
    return false;
  }
  facets_.learn(hull, most.bound);
  return true;
}

bool ProtrusionOracle::fitsWithin(const ConvexHull& hull, double reach) {
  const std::optional<bool> answer = fitsByOctree(hull, reach);
  return (answer ? *answer : concluded(hull, onSurfaceAsWritten(hull))) && fitsInRegions(hull);
}

bool ProtrusionOracle::fitsInRegions(const ConvexHull& hull) {
  return holdsInRegions(hull, [](ProtrusionOracle& oracle, const ConvexHull& part) { return oracle.fits(part); });
}

std::vector<char> ProtrusionOracle::fit(const std::vector<const ConvexHull*>& hulls) {
  std::vector<std::optional<bool>> answers;
  for (const ConvexHull* hull : hulls) answers.push_back(fitsByOctree(*hull, reach(*hull)));
  std::vector<Protrusion> on_surface(hulls.size());
  forEach(hulls.size(), [&](std::size_t i) {
    if (!answers[i]) on_surface[i] = onSurfaceAsWritten(*hulls[i]);
  });
  std::vector<char> result;
  for (std::size_t i = 0; i < hulls.size(); ++i) result.push_back(answers[i] ? *answers[i] : concluded(*hulls[i], on_surface[i]));
  for (std::size_t i = 0; i < hulls.size(); ++i) result[i] = result[i] != 0 && fitsInRegions(*hulls[i]);
  return result;
}

/// nullopt: undecided.
std::optional<bool> ProtrusionOracle::fitsByOctree(const ConvexHull& hull, double reach) const {
  if (std::isinf(reach)) return false;
  // A hull of few vertices may reach far beyond the mesh.
  if (!solid_.hasOpenings() && reach <= (1 - kReserve) * tolerance_ && outside_.reaches(hull)) return true;
  return std::nullopt;
}

Protrusion ProtrusionOracle::onSurface(const ConvexHull& hull, double limit, double gap) const {
  const std::vector<char> settled = facets_.within(limit + gap, hull);
  SurfaceQuery on;
  on.floor = on.ceiling = limit;
  on.gap = gap;
  on.known = &outside_;
  on.settled = &settled;
  return largestOnSurface(hull, solid_, on, control_);
}

/// For a proof.
Protrusion ProtrusionOracle::onSurfaceAsWritten(const ConvexHull& hull) const {
  return onSurface(written(hull), (1 - kReserve) * tolerance_, kProofGap * tolerance_);
}

/// The largest hull that may be written for this one. Where the surface has openings the distance function jumps, and a slightly larger
/// hull must not reach across.
ConvexHull ProtrusionOracle::written(const ConvexHull& hull) const {
  return solid_.hasOpenings() ? grown(hull) : hull;
}

bool ProtrusionOracle::concluded(const ConvexHull& hull, const Protrusion& on_surface) {
  if (on_surface.found > (1 - kReserve) * tolerance_) {
    rememberOnSurface(on_surface.where, hull);
    return false;
  }
  facets_.learn(written(hull), on_surface.bound);
  if (proves_pockets_) return !mayHoldPocket(hull);
  return isTooSmallForPockets(hull) || summit(hull, on_surface.bound, kPocketGlance).found <= tolerance_;
}

/// Independent of the octree: nothing in a small hull is far from the surface if one of its vertices is near it.
bool ProtrusionOracle::isTooSmallForPockets(const ConvexHull& hull) const {
  return solid_.distanceToSurface(hull.vertices[0]) + boundingBox(hull).diagonal().norm() <= tolerance_;
}

bool ProtrusionOracle::mayHoldPocket(const ConvexHull& hull) {
  if (!isTooSmallForPockets(hull) && !fitsByOctree(hull, reach(hull)).value_or(false)) {
    SurfaceQuery on;  // the smaller its bound, the fewer cells matter
    on.floor = kShallow * tolerance_;
    on.gap = kProofGap * tolerance_;
    on.known = &outside_;
    const double surface_bound = largestOnSurface(hull, solid_, on, control_).bound;
    if (summit(hull, surface_bound, OutsideDistance::Query{}.most_visits).bound > tolerance_) return true;
  }
  return !holdsInRegions(hull, [](ProtrusionOracle& oracle, const ConvexHull& part) { return !oracle.mayHoldPocket(part); });
}

std::vector<char> ProtrusionOracle::mayHoldPockets(const std::vector<ConvexHull>& hulls) {
  std::vector<std::size_t> all(hulls.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<char> may_hold(hulls.size());
  askForPockets(hulls, all, may_hold);
  return may_hold;
}

/// In halves side by side, one of them with an oracle of its own. The halves do not depend on the number of threads.
void ProtrusionOracle::askForPockets(const std::vector<ConvexHull>& hulls, const std::vector<std::size_t>& some,
                                     std::vector<char>& may_hold) {
  if (some.size() <= std::max(kTogether, hulls.size() / kSharesOfHulls)) {
    for (const std::size_t i : some) may_hold[i] = mayHoldPocket(hulls[i]) ? 1 : 0;
    return;
  }
  const auto halves = halvesByPlace(hulls, some);
  Eigen::AlignedBox3d box;
  for (const std::size_t i : halves.second) box.extend(boundingBox(hulls[i]));
  ProtrusionOracle oracle = forPart(box);
  atOnce([&] { askForPockets(hulls, halves.first, may_hold); }, [&] { oracle.askForPockets(hulls, halves.second, may_hold); });
  learn(oracle);
}

void ProtrusionOracle::provePockets() {
  proves_pockets_ = true;
  for (const Watch& watch : watches_) watch.oracle->provePockets();
}

/// A search for the middle of a pocket between surfaces that is further from the solid than the hull's whole surface, and than the
/// tolerance.
OutsideDistance::Largest ProtrusionOracle::summit(const ConvexHull& hull, double surface_bound, std::size_t most_visits) {
  OutsideDistance::Query query;
  query.floor = query.ceiling = tolerance_;
  query.resolution = kPocketCell * tolerance_;
  query.summits_only = true;
  query.surface_bound = surface_bound;
  query.depth = leastWidth(hull, control_) / 2;
  query.most_visits = most_visits;
  const OutsideDistance::Largest summit = outside_.largest(hull, query, control_);
  if (summit.found > tolerance_) remember(summit.where);
  return summit;
}

double ProtrusionOracle::bound(const std::vector<ConvexHull>& hulls) {
  std::vector<Skin> skins;
  double floor = 0;
  for (const ConvexHull& hull : hulls) {
    skins.push_back(skinOf(hull));
    floor = std::max(floor, skins.back().floor());
  }
  double most = 0;
  for (const Skin& skin : skins) most = std::max(most, boundWithin(skin, std::max(floor, most)));
  return most;
}

double ProtrusionOracle::estimate(const ConvexHull& hull) {
  return skinOf(hull).floor();
}

ProtrusionOracle::Skin ProtrusionOracle::skinOf(const ConvexHull& exact) {
  Skin skin{written(exact)};
  OutsideDistance::Query query;
  query.ceiling = std::numeric_limits<double>::infinity();
  query.resolution = kFineCell * tolerance_;
  skin.found = outside_.largest(skin.hull, query, control_).found;
  skin.gap = std::max(kLooseGap * tolerance_, kLooseShare * skin.found);
  SurfaceQuery on;
  on.floor = skin.found;
  on.gap = skin.gap;
  on.halvings = kLooseHalvings;
  on.known = &outside_;
  skin.bound = largestOnSurface(skin.hull, solid_, on, control_).bound;
  return skin;
}

/// The bound for the inside of a hull as well, and in regions; at least `floor` [m].
double ProtrusionOracle::boundWithin(const Skin& skin, double floor) {
  OutsideDistance::Query query;
  query.ceiling = std::numeric_limits<double>::infinity();
  query.floor = floor;
  query.resolution = skin.gap;
  query.summits_only = true;
  query.surface_bound = skin.bound;
  query.depth = leastWidth(skin.hull, control_) / 2;
  double most = outside_.largest(skin.hull, query, control_).bound;
  for (const Watch& watch : watches_)
    if (const std::optional<ConvexHull> part = partIn(skin.hull, watch.region))
      most = std::max(most, watch.oracle->bound({*part}) / watch.ratio);
  return most;
}

ProtrusionOracle::Descent ProtrusionOracle::descend(const ConvexHull& hull, double resolution) {
  control_.check();
  if (holdsKnownIntruder(hull)) return {std::numeric_limits<double>::infinity(), false};
  OutsideDistance::Query query;
  query.floor = query.ceiling = intrusion();
  query.resolution = resolution * share_ * tolerance_;
  query.most_visits = kLeastVisits + kVisitsPerFacet * facets_.unknown(intrusion() + kQuickGap * share_ * tolerance_, hull);
  const OutsideDistance::Largest within = outside_.largest(hull, query, control_);
  if (within.found > intrusion()) remember(within.where);
  return {within.bound, within.visits == query.most_visits};
}

/// Whether something holds one of the first known intruders. A useful intruder moves forward.
template <typename Holds>
bool ProtrusionOracle::isKnownIntruder(std::size_t most, const Holds& holds) {
  for (std::size_t i = 0; i < std::min(most, known_.size()); ++i) {
    if (!holds(known_[i])) continue;
    std::swap(known_[i], known_[i / 2]);
    return true;
  }
  return false;
}

bool ProtrusionOracle::holdsKnownIntruder(const ConvexHull& hull) {
  const Eigen::AlignedBox3d box = boundingBox(hull);
  return isKnownIntruder(kMostKnown, [&](const Eigen::Vector3d& p) { return box.contains(p) && holds(hull, p); });
}

bool ProtrusionOracle::refutes(const std::vector<Eigen::Vector3d>& points) {
  HullMembership hull(points);
  return isKnownIntruder(kUseful, [&](const Eigen::Vector3d& p) { return hull.holds(p); });
}

void ProtrusionOracle::remember(const Eigen::Vector3d& intruder) {
  if (known_.size() == kMostKnown) known_.pop_back();
  known_.push_back(intruder);
  std::swap(known_.back(), known_[known_.size() / 2]);
}

void ProtrusionOracle::rememberOnSurface(const Eigen::Vector3d& intruder, const ConvexHull& hull) {
  remember(intruder + kIntoHull * (hull.vertices[0] - intruder));
}

std::vector<OutsideDistance::Intruder> ProtrusionOracle::intruders(const ConvexHull& hull, std::size_t wanted) {
  control_.check();
  std::vector<OutsideDistance::Intruder> all = outside_.intruders(hull, intrusion(), wanted, kIntruderCell * share_ * tolerance_);
  for (const Watch& watch : watches_) {
    const std::optional<ConvexHull> part = partIn(hull, watch.region);
    if (!part || watch.oracle->mayWellFit(*part)) continue;
    const std::vector<OutsideDistance::Intruder> within = watch.oracle->intruders(*part, wanted);
    all.insert(all.end(), within.begin(), within.end());
  }
  if (all.empty()) {  // the hull is thinner than the cells
    SurfaceQuery on;
    on.gap = kIntruderCell * tolerance_;
    const Protrusion most = largestOnSurface(hull, solid_, on, control_);
    return {{most.where, most.found, 1}};
  }
  if (all.size() <= 2 * wanted) return all;
  std::vector<OutsideDistance::Intruder> some;
  for (std::size_t i = 0; i < 2 * wanted; ++i) some.push_back(all[i * all.size() / (2 * wanted)]);
  return some;
}

}  // namespace collision_hulls
