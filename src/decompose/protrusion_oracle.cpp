#include "decompose/protrusion_oracle.h"

#include <algorithm>

#include "check/surface_search.h"

namespace collision_hulls {

namespace {

// All as shares of the tolerance.
constexpr double kReserve = 0.02;     // for the certificate, whose bounds come from the hulls as written
constexpr double kGap = 0.005;        // between the bounds of the surface search
constexpr double kCoarse = 0.5;       // the octree's resolution where the surface is searched too
constexpr double kIndifferent = 0.4;  // protrusions below this are as good as none
constexpr double kFinest = 1.0 / 8;   // of the search for intruders
constexpr double kGapOfLarge = 0.05;  // of a protrusion that may exceed the tolerance, as a share of itself
constexpr std::size_t kIntruders = 64;

}  // namespace

ProtrusionOracle::ProtrusionOracle(const Solid& solid, const Eigen::AlignedBox3d& box, double tolerance, const RunControl& control)
    : solid_(solid), tolerance_(tolerance), control_(control), outside_(solid, box) {}

double ProtrusionOracle::within(const ConvexHull& hull, double known) {
  control_.check();
  const double most = tolerance_ * (1 - kReserve), floor = std::max(known, kIndifferent * tolerance_);
  OutsideDistance::Query coarse;
  coarse.floor = floor;
  coarse.ceiling = most;
  coarse.resolution = kCoarse * tolerance_;
  const OutsideDistance::Largest seen = outside_.largest(hull, coarse);
  if (seen.found > most) return std::numeric_limits<double>::infinity();
  SurfaceQuery fine;
  fine.floor = std::max(floor, seen.found);
  fine.gap = kGap * tolerance_;
  fine.ceiling = most;
  const Protrusion on_surface = largestOnSurface(hull, solid_, fine, control_);
  if (on_surface.found > most) return std::numeric_limits<double>::infinity();
  OutsideDistance::Query summits = coarse;
  summits.floor = std::max(fine.floor, on_surface.found) + fine.gap;
  summits.resolution = fine.gap;
  summits.summits_only = true;
  const OutsideDistance::Largest within_hull = outside_.largest(hull, summits);
  if (within_hull.found > most) return std::numeric_limits<double>::infinity();
  return std::max({known, on_surface.bound, within_hull.found});
}

double ProtrusionOracle::however(const ConvexHull& hull) {
  control_.check();
  OutsideDistance::Query coarse;
  coarse.ceiling = std::numeric_limits<double>::infinity();
  coarse.resolution = kCoarse * tolerance_;
  const OutsideDistance::Largest seen = outside_.largest(hull, coarse);
  SurfaceQuery fine;
  fine.floor = seen.found;
  fine.gap = std::max(kReserve * tolerance_, kGapOfLarge * seen.found);
  return std::max({largestOnSurface(hull, solid_, fine, control_).bound, seen.found + fine.gap});
}

std::vector<OutsideDistance::Intruder> ProtrusionOracle::intruders(const ConvexHull& hull) {
  control_.check();
  std::vector<OutsideDistance::Intruder> all = outside_.intruders(hull, tolerance_ * (1 - kReserve), kIntruders, kFinest * tolerance_);
  if (all.empty()) return {furthest(hull)};
  if (all.size() <= 2 * kIntruders) return all;
  std::vector<OutsideDistance::Intruder> some;
  for (std::size_t i = 0; i < 2 * kIntruders; ++i) some.push_back(all[i * all.size() / (2 * kIntruders)]);
  return some;
}

/// For intrusions thinner than the octree's cells.
OutsideDistance::Intruder ProtrusionOracle::furthest(const ConvexHull& hull) const {
  SurfaceQuery query;
  query.gap = kFinest * tolerance_;
  const Protrusion p = largestOnSurface(hull, solid_, query, control_);
  return {p.where, p.found, 1};
}

}  // namespace collision_hulls
