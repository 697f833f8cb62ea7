// Decompose, complete the cover, certify.
//
// What a method aims at is not what is returned. Hulls as returned are rounded outward and cover the mesh as it was given, not the repaired
// one, so they protrude a little further than those that the method looked at, and much further where the distance to the solid jumps, as
// at openings. Hence the aim is a little below the tolerance from the start, and if the certificate still exceeds the tolerance, the method
// `certified` tries again with an aim that is lower by as much: kAttempts times at most, and the best attempt counts. Other methods do not
// aim at the protrusion, so another attempt would only cost time.
//
// The certificate is a search between two bounds (measure/protrusion.h). Closing the gap costs more the narrower it is, so it stays at
// kCertificateGap of the tolerance, or of the protrusion where that is more, and is narrowed only where the gap alone decides that the
// tolerance is exceeded.
#include "collision_hulls/decompose/certified_hulls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/decimal.h"
#include "base/millimetres.h"
#include "base/parallel.h"
#include "base/positive_length.h"
#include "base/stopwatch.h"
#include "collision_hulls/decompose/least_hulls.h"
#include "collision_hulls/decompose/round_outward.h"
#include "collision_hulls/error.h"
#include "decompose/certified/lower_bound.h"
#include "decompose/finest_tolerance.h"
#include "decompose/hulls_of_tree.h"
#include "decompose/margin.h"
#include "decompose/padding.h"
#include "measure/protrusion.h"
#include "mesh/polygons.h"

namespace collision_hulls {
namespace {

constexpr double kPaddingShare = 0.08;  // of the padding: what a padded hull of few vertices is larger than it has to be
// Each further aim is lower by the excess and a little more, but not below kLowerAim of the last aim.
constexpr int kAttempts = 3;
constexpr double kLowerAim = 0.8, kALittleLower = 0.99;
// Least share of the usual gap for which a narrower one is tried, and the extra effort spent on it.
constexpr double kLeastGap = 0.1;
constexpr std::size_t kSpareVisits = 500'000;

constexpr double kSearchShare = 0.7;     // of the time until a deadline; the rest is for certifying
constexpr double kDecomposeShare = 0.7;  // of the time, approximately; the rest is certifying
constexpr double kMuch = 0.1;            // of the protrusion: if blunting exceeds this share, it is named as the cause

/// Hulls that may be the result, and what may have kept them from being better.
struct Attempt {
  CertifiedHulls result;
  std::vector<ConvexHull> before_padding;  // cover the mesh; empty without padding
  bool capped = false;                     // caps made the hulls coarser
  bool too_fine = false;                   // see Decomposition
  double blunted = 0;                      // [m] see RoundedHulls
};

/// Hulls are certified against the tolerance, also those of methods that ignore it.
void checkTolerance(const DecomposeOptions& options) {
  check(options);
  expectPositiveLength("tolerance", options.tolerance);
}

std::vector<RegionProof> regionProofs(const std::vector<ConvexHull>& hulls, const PreparedMesh& mesh, const std::vector<Region>& regions,
                                      const RunControl& control) {
  std::vector<RegionProof> proofs;
  for (const Region& region : regions) {
    std::vector<ConvexHull> parts;
    for (const ConvexHull& hull : hulls)
      if (std::optional<ConvexHull> part = partIn(hull, region)) parts.push_back(*std::move(part));
    RegionProof proof;
    if (!parts.empty()) {
      const Protrusion most = certificate(parts, mesh.solid, mesh.margin, region.tolerance, control);
      proof = {most.bound, most.found};
    }
    proofs.push_back(proof);
  }
  return proofs;
}

/// [m] How far the hulls may protrude.
double limit(const DecomposeOptions& options) {
  return options.tolerance + options.padding;
}

/// The largest bound, less the padding, as a share of its tolerance.
double boundShare(const CertifiedHulls& hulls, const DecomposeOptions& options) {
  double share = (hulls.bound - options.padding) / options.tolerance;
  for (std::size_t i = 0; i < hulls.regions.size(); ++i) share = std::max(share, hulls.regions[i].bound / options.regions[i].tolerance);
  return share;
}

/// The aim of the next attempt; `over` is the last bound over the tolerance.
void lowerAim(DecomposeOptions& aim, int attempt, double over) {
  const double share = attempt == 0 ? std::max(kLowerAim, kALittleLower / over) : kLowerAim;
  aim.tolerance *= share;
  for (Region& region : aim.regions) region.tolerance *= share;
}

/// Pads the hulls. `before`: as they were.
void pad(std::vector<ConvexHull>& hulls, const DecomposeOptions& options, const RunControl& control, std::vector<ConvexHull>& before) {
  before = hulls;
  forEach(hulls.size(), [&](std::size_t i) { hulls[i] = padded(before[i], options.padding, options.max_vertices, control); });
}

/// The search's part of the time until then.
RunControl::Time searchEnd(const RunControl::Time& end) {
  if (end == RunControl::Time::max()) return end;
  const RunControl::Time now = std::chrono::steady_clock::now();
  return now + std::chrono::duration_cast<RunControl::Time::duration>(kSearchShare * (end - now));
}

/// What no cover goes below, whatever the aim of the attempt.
LowerBound boundOf(const PreparedMesh& mesh, const DecomposeOptions& options) {
  return LowerBound([&](const std::vector<ConvexHull>& cover, const RunControl& control) {
    return leastHulls(mesh.original, mesh.solid, options.tolerance, cover, options.effort, control);
  });
}

Decomposition decomposed(const PreparedMesh& mesh, const DecomposeOptions& aim, LowerBound& least, const RunControl& control) {
  if (mesh.tree) return hullsOfTree(*mesh.tree, aim);
  return aim.method == Method::kCertified ? certified(mesh.repaired, mesh.solid, aim, least, control)
                                          : decompose(mesh.repaired, aim, control);
}

Attempt attemptAt(const PreparedMesh& mesh, const DecomposeOptions& aim, const DecomposeOptions& options, LowerBound& least,
                  const RunControl& decomposing, const RunControl& certifying) {
  Attempt attempt;
  CertifiedHulls& result = attempt.result;
  Stopwatch stage;
  RunControl searching;
  searching.whole = &decomposing;
  searching.progress = decomposing.progress;
  searching.deadline = searchEnd(decomposing.until());
  const Decomposition parts = decomposed(mesh, aim, least, searching);
  RoundedHulls rounded = roundOutward(parts.hulls, mesh.original, mesh.margin, aim.max_vertices, decomposing);
  for (const ConvexHull& hull : parts.hulls) result.thickness = std::max(result.thickness, hull.thickness);
  result.seconds.decompose = stage.lap();
  if (options.padding > 0) pad(rounded.hulls, options, decomposing, attempt.before_padding);
  const Protrusion proof = certificate(rounded.hulls, mesh.solid, mesh.margin, limit(options), certifying);
  result.regions = regionProofs(rounded.hulls, mesh, options.regions, certifying);
  result.seconds.certify = stage.lap();
  result.hulls = std::move(rounded.hulls);
  result.bound = proof.bound;
  result.found = proof.found;
  result.where = proof.where;
  result.nearest = proof.nearest;
  result.nudge = rounded.nudge;
  result.untried = parts.untried;
  const auto is_loose = [&](double bound, double found, double tolerance) {
    return bound > tolerance && bound - mesh.margin - found > kCertificateGap * std::max(tolerance, found);
  };
  bool loose = is_loose(proof.bound, proof.found, limit(options));
  for (std::size_t i = 0; i < result.regions.size(); ++i)
    loose = loose || is_loose(result.regions[i].bound, result.regions[i].found, options.regions[i].tolerance);
  if (loose && certifying.late()) result.untried += std::string(result.untried.empty() ? "" : ", ") + "a tight bound";
  attempt.capped = parts.capped;
  attempt.too_fine = parts.too_fine;
  attempt.blunted = rounded.blunted;
  return attempt;
}

/// The best attempt, with the time of all.
Attempt bestAttempt(const PreparedMesh& mesh, const DecomposeOptions& options, const RunControl& decomposing,
                    const RunControl& certifying) {
  const bool aims = options.method == Method::kCertified;
  DecomposeOptions aim = options;
  if (aims) {
    aim.tolerance = firstAim(options.tolerance, mesh.margin, kPaddingShare * options.padding);
    for (Region& region : aim.regions) region.tolerance = firstAim(region.tolerance, mesh.margin);
  }
  LowerBound least = boundOf(mesh, options);
  Attempt best;
  CertifiedHulls::Seconds spent;
  for (int i = 0; i < kAttempts; ++i) {
    Attempt attempt = attemptAt(mesh, aim, options, least, decomposing, certifying);
    spent.decompose += attempt.result.seconds.decompose;
    spent.certify += attempt.result.seconds.certify;
    const double over = boundShare(attempt.result, options);
    if (i > 0 && over >= boundShare(best.result, options))  // as may be by chance, at openings: the next may yet be better
      best.result.untried = attempt.result.untried;
    else
      best = std::move(attempt);
    if (!aims || best.capped || best.too_fine || over <= 1 || !best.result.untried.empty()) break;
    lowerAim(aim, i, over);
  }
  best.result.seconds = spent;
  best.result.least_hulls = least.known();
  return best;
}

/// The first region whose tolerance is exceeded.
std::optional<std::size_t> exceededRegion(const CertifiedHulls& hulls, const DecomposeOptions& options) {
  for (std::size_t i = 0; i < hulls.regions.size(); ++i)
    if (hulls.regions[i].bound > options.regions[i].tolerance) return i;
  return std::nullopt;
}

/// Why hulls protrude further than the tolerance, and what to do about it. `tree`: that they are cut from, or null.
std::string excuse(const DecomposeOptions& options, const Attempt& made, const HullTree* tree) {
  if (options.method == Method::kSingleHull || options.method == Method::kBoundingBox)
    return std::string(name(options.method)) +
           " ignores the tolerance; if that is too far, use certified, and if it is not, raise the tolerance";
  const std::string vertices = "max-vertices " + std::to_string(options.max_vertices);
  if (!made.result.untried.empty()) return "time ran out (not done: " + made.result.untried + "); raise the time limit or the tolerance";
  if (made.too_fine && !made.capped)
    return "the tolerance asks for more pieces than a mesh is divided into; raise it to what the hulls keep, " +
           millimetres(made.result.bound) + ", or remove fine details";
  const std::string hulls = "max-hulls " + std::to_string(options.max_hulls);
  if (made.capped && options.method == Method::kCertified)
    return "the limit (" + hulls + ") made the hulls coarser; raise it, or the tolerance";
  if (tree && options.tolerance < tree->tolerance)
    return "the leaves of the hull tree are made for " + millimetres(tree->tolerance) +
           "; give that tolerance, or make a tree for this one";
  if (made.capped && options.max_hulls > 0)
    return "the limits (" + hulls + ", " + vertices + ") made the hulls coarser; raise them, or the tolerance";
  if (options.method == Method::kHacd)
    return "hacd measures concavity along rays, which does not bound the protrusion, so that a smaller tolerance need not help; use "
           "certified";
  if (options.method == Method::kAcd)
    return "acd measures concavity at reflex edges, which does not bound the protrusion, so that a smaller tolerance need not help; use "
           "certified";
  if (made.result.found <= limit(options))
    return "no point was found further out than " + millimetres(made.result.found) +
           ", but that is not proved; raise the tolerance a little, or repair the mesh";
  if (options.padding > 0)
    return "padded hulls of few vertices (" + vertices + ") reach further than the padding; raise the tolerance or that limit";
  if (made.blunted > kMuch * made.result.bound)
    return "with so few vertices (" + vertices + ") thin hulls protrude up to " + millimetres(made.blunted) + " further; raise that limit";
  return "the surface has details there that no plane divided; raise the tolerance above it, or repair the mesh";
}

std::string overrunInRegion(const DecomposeOptions& options, const Attempt& made, std::size_t index) {
  const Region& region = options.regions[index];
  return "in " + (region.name.empty() ? "a region" : "region '" + region.name + "'") + " the hulls protrude by up to " +
         millimetres(made.result.regions[index].bound) + ", more than its tolerance of " + millimetres(region.tolerance);
}

/// The same as excuse() for a region whose tolerance alone is exceeded.
std::string excuseInRegion(const DecomposeOptions& options, const Attempt& made, const HullTree* tree) {
  const bool may_be_moved = options.method == Method::kCertified && !made.capped && made.result.untried.empty();
  return may_be_moved ? "the surface there is too rough for it; give the region a larger tolerance, or move it away from the surface"
                      : excuse(options, made, tree);
}

/// Passes a part of the work on as the shares `from` to `to` of the whole. `done` is the largest so far of all parts, and what is reported:
/// attempts begin anew.
void follow(RunControl& part, const RunControl& whole, double from, double to, double& done) {
  part.whole = &whole;
  part.progress = [&whole, from, to, &done](double share) {
    done = std::max(done, from + (to - from) * share);
    whole.report(done);
  };
}

/// Throws kInternal unless each hull holds all points within the padding of the one that it was made from.
void expectPadded(const std::vector<ConvexHull>& hulls, const std::vector<ConvexHull>& before, double padding, const std::string& name) {
  for (std::size_t i = 0; i < before.size(); ++i)
    if (!holdsPadding(hulls[i], before[i], padding))
      throw Error(ErrorCode::kInternal, "a hull lacks a part of its padding of " + millimetres(padding) + ". Please report the mesh" +
                                            (name.empty() ? "" : " '" + name + "'"));
}

/// Hulls are made of numbers of single precision, as the meshes that are read from files are.
void expectSinglePrecision(const TriangleMesh& mesh, const std::string& name) {
  const Eigen::AlignedBox3d box = boundingBox(mesh);
  const double largest = box.isEmpty() ? 0 : box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  const std::string label = name.empty() ? "" : "'" + name + "'";
  if (largest > std::numeric_limits<float>::max())
    throw Error(ErrorCode::kNonFiniteCoordinate, (name.empty() ? "the mesh" : label) + " has the coordinate " + decimal(largest) +
                                                     ", which is not a finite number of single precision; correct or remove its vertex");
  singlePrecisionResolution(mesh, largest, label);
}

/// kRegionSlack is for everyone, also on the largest meshes.
void expectResolvableTolerances(const PreparedMesh& mesh, const DecomposeOptions& options) {
  const double size = diagonal(mesh.original);
  expectResolvable(options.tolerance, size, mesh.name);
  for (const Region& region : options.regions)
    if (region.tolerance < kRegionSlack) expectResolvable(region.tolerance, size, mesh.name, " of region '" + region.name + "'");
}

}  // namespace

Protrusion certificate(const std::vector<ConvexHull>& hulls, const Solid& solid, double margin, double tolerance,
                       const RunControl& control) {
  expectPositiveLength("tolerance", tolerance);
  expectMargin(margin);
  check(hulls, control);
  const double gap = kCertificateGap * tolerance;
  Protrusion result = protrusion(hulls, solid, {gap, kCertificateGap, 0}, control);
  const double room = tolerance - margin - result.found;
  if (result.bound + margin > tolerance && room > kLeastGap * gap && !control.late()) {
    // What is nearer than half of the room does not matter: to come closer would take most of the time.
    const Protrusion again = protrusion(hulls, solid, {std::min(gap, room / 4), 0, kSpareVisits, result.found + room / 2}, control);
    const double bound = std::min(result.bound, again.bound);  // time may have ended in between
    if (again.found > result.found) result = again;
    result.bound = std::max(bound, result.found);
  }
  result.bound += margin;
  return result;
}

void expectCovered(const TriangleMesh& mesh, const std::vector<ConvexHull>& hulls, const std::string& name, const RunControl& control) {
  const double gap = uncovered(mesh, hulls, control);
  if (gap > 0)
    throw Error(ErrorCode::kInternal, "the hulls leave the surface uncovered by up to " + millimetres(gap) +
                                          "; the limit is 0. Please report the mesh" + (name.empty() ? "" : " '" + name + "'"));
}

CertifiedHulls certifiedHulls(const PreparedMesh& mesh, const DecomposeOptions& options, const RunControl& control) {
  checkTolerance(options);
  check(mesh.original, control);
  expectSinglePrecision(mesh.original, mesh.name);
  expectMargin(mesh.margin, mesh.repaired.counts.weld_distance);
  expectResolvableTolerances(mesh, options);
  RunControl decomposing, certifying;
  double done = 0;
  follow(decomposing, control, 0, kDecomposeShare, done);
  follow(certifying, control, kDecomposeShare, 1, done);
  Attempt made = bestAttempt(mesh, options, decomposing, certifying);
  CertifiedHulls& result = made.result;
  Stopwatch stage;
  expectCovered(mesh.original, made.before_padding.empty() ? result.hulls : made.before_padding, mesh.name, certifying);
  expectPadded(result.hulls, made.before_padding, options.padding, mesh.name);
  const std::optional<std::size_t> region = exceededRegion(result, options);
  result.within_tolerance = result.bound <= limit(options) && !region;
  if (result.bound > limit(options))
    result.reason = "the hulls protrude by up to " + millimetres(result.bound) + ", more than the tolerance of " +
                    millimetres(options.tolerance) + (options.padding > 0 ? " and the padding of " + millimetres(options.padding) : "") +
                    ": " + excuse(options, made, mesh.tree) + (region ? "; " + overrunInRegion(options, made, *region) : "");
  else if (region)
    result.reason = overrunInRegion(options, made, *region) + ": " + excuseInRegion(options, made, mesh.tree);
  result.seconds.certify += stage.lap();
  control.report(1);
  return std::move(result);
}

CertifiedHulls certifiedHulls(const TriangleMesh& mesh, const DecomposeOptions& options, const RunControl& control) {
  checkTolerance(options);
  if (mesh.triangles.empty()) throw Error(ErrorCode::kEmptyMesh, "the mesh has no triangles; hulls need at least one");
  Stopwatch stage;
  const RepairedMesh repaired = repair(mesh, {}, control);
  const Solid solid(repaired, control);
  const double seconds = stage.lap();
  CertifiedHulls result = certifiedHulls({mesh, repaired, solid, repaired.counts.weld_distance, nullptr, ""}, options, control);
  result.seconds.repair = seconds;
  return result;
}

}  // namespace collision_hulls
