// The space that spheres may fill (tolerable_space.h), a choice of few spheres in it (sphere_choice.h), each made to protrude as little as
// the others let it (sphere_shrinking.h), and the proof of what is returned: that they cover the mesh, tested with the radii as they are,
// and each sphere's bound, which the space gives for that place and radius, whoever chose them.
//
// Where the limit on spheres does not allow the tolerance, the least that it allows is found by bisection: how many spheres a tolerance
// takes is known only once they are chosen, and those chosen at one tolerance do not fit in the space of a smaller one.
#include "collision_hulls/primitives/spheres.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/counted.h"
#include "base/millimetres.h"
#include "base/positive_length.h"
#include "decompose/finest_tolerance.h"
#include "decompose/margin.h"
#include "primitives/sphere_choice.h"
#include "primitives/sphere_cover.h"
#include "primitives/sphere_shrinking.h"
#include "primitives/tolerable_space.h"

namespace collision_hulls {

namespace {

constexpr double kRounding = 1e-12;       // of the coordinates, as in measure/protrusion.cpp
constexpr double kLeastTolerance = 4e-5;  // of the coordinates: spheres hold points by a share of it (sphere_choice.cpp) above kLeastDepth
constexpr double kMargins = 4;            // the least tolerance, in margins
constexpr double kRaise = 4;              // factor by which the tolerance is raised until the limit on spheres is enough,
constexpr double kClose = 1.03;           // and the one within which the least such tolerance is then found,
constexpr std::size_t kTrialShare = 8;    // with so much less work for each attempt
constexpr double kLeastDepth = 1e-6;      // of the coordinates: where covers() gives up
constexpr std::size_t kQuickWork = 400'000'000, kBestWork = 4'000'000'000;

double sizeOf(const TriangleMesh& mesh) {
  const Eigen::AlignedBox3d box = boundingBox(mesh);
  return box.isEmpty() ? 0 : box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

std::string spheresDo(std::size_t number, const std::string& what) {
  return counted(number, "sphere") + (number == 1 ? " does" : " do") + what;
}

void check(const SphereOptions& options) {
  expectPositiveLength("the tolerance of spheres", options.tolerance);
  if (options.max_spheres < 1) throw Error(ErrorCode::kBadOption, "a limit of 0 spheres; a mesh needs at least 1");
}

void expectTriangles(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw Error(ErrorCode::kEmptyMesh, "the mesh has no triangles; spheres need at least one");
}

std::size_t workFor(Effort effort) {
  return effort == Effort::kInstant ? 0 : effort == Effort::kQuick ? kQuickWork : kBestWork;
}

/// nullopt if it takes too many.
std::optional<CertifiedSpheres> spheresWithin(double tolerance, const PreparedMesh& mesh, const ChoiceLimits& limits,
                                              const RunControl& control) {
  Eigen::AlignedBox3d box = boundingBox(mesh.original);
  box.extend(boundingBox(mesh.repaired.mesh));
  const double allowance = mesh.margin + kRounding * sizeOf(mesh.original) + mesh.solid.sideError();
  const TolerableSpace space(mesh.solid, box, tolerance - allowance, control);
  const auto spheres = fewSpheres(mesh.original, space, limits, control);
  if (!spheres) return std::nullopt;
  CertifiedSpheres result;
  result.spheres = shrunk(*spheres, mesh.original, space, control);
  std::stable_sort(result.spheres.begin(), result.spheres.end(), [](const Sphere& a, const Sphere& b) { return a.radius > b.radius; });
  for (const Sphere& sphere : result.spheres) result.bounds.push_back(space.bound(sphere) + allowance);
  result.bound = *std::max_element(result.bounds.begin(), result.bounds.end());
  return result;
}

/// Those that protrude least among as many as the limit allows, which is not enough at the tolerance `low` [m]. A few attempts find a
/// tolerance at which it is, and halve the interval between the two. An attempt at a tolerance ends once the limit is kept: fewer spheres
/// would protrude more.
CertifiedSpheres closestAllowed(double low, const PreparedMesh& mesh, const SphereOptions& options, const RunControl& control) {
  const ChoiceLimits limits{options.max_spheres, workFor(options.effort) / kTrialShare, options.max_spheres};
  RunControl attempt;  // reports nothing
  attempt.whole = &control;
  attempt.stops_at_deadline = control.stops_at_deadline;
  std::optional<CertifiedSpheres> best = spheresWithin(kRaise * low, mesh, limits, attempt);
  while (!best) {
    low *= kRaise;
    best = spheresWithin(kRaise * low, mesh, limits, attempt);
  }
  while (best->bound > kClose * low) {
    control.report(std::max(0.0, 1 - std::log(best->bound / low) / std::log(kRaise)));
    const double middle = std::sqrt(low * best->bound);
    if (std::optional<CertifiedSpheres> closer = spheresWithin(middle, mesh, limits, attempt))
      best = std::move(closer);
    else
      low = middle;
  }
  return *std::move(best);
}

/// The limit on spheres is enough for the tolerance, or for the least that the mesh allows, or the tolerance is raised.
CertifiedSpheres withinLimit(const PreparedMesh& mesh, const SphereOptions& options, const RunControl& control) {
  const double least = std::max(kMargins * mesh.margin, kLeastTolerance * sizeOf(mesh.original));
  const double tolerance = std::max(options.tolerance, least);
  std::optional<CertifiedSpheres> found = spheresWithin(tolerance, mesh, {options.max_spheres, workFor(options.effort)}, control);
  const bool enough = found.has_value();
  CertifiedSpheres result = enough ? *std::move(found) : closestAllowed(tolerance, mesh, options, control);
  result.within_tolerance = result.bound <= options.tolerance;
  if (result.within_tolerance) return result;
  const std::string asked = "the tolerance of " + millimetres(options.tolerance);
  result.reason = (enough ? asked + " is too small for this mesh" : spheresDo(options.max_spheres, " not cover the mesh within ") + asked) +
                  "; " + spheresDo(result.spheres.size(), " within ") + millimetresBeyond(result.bound, options.tolerance) +
                  (enough ? "; raise the tolerance" : "; raise the limit (max_spheres; max-hulls of a program), or the tolerance");
  return result;
}

}  // namespace

bool covers(const std::vector<Sphere>& spheres, const TriangleMesh& mesh, const RunControl& control) {
  const double size = sizeOf(mesh);
  return gapsIn(mesh, spheres, {kLeastDepth * size, size}, control).empty();
}

CertifiedSpheres certifiedSpheres(const PreparedMesh& mesh, const SphereOptions& options, const RunControl& control) {
  check(options);
  check(mesh.original, control);
  expectTriangles(mesh.original);
  expectMargin(mesh.margin, mesh.repaired.counts.weld_distance);
  expectResolvable(options.tolerance, diagonal(mesh.original), mesh.name);
  CertifiedSpheres result = withinLimit(mesh, options, control);
  if (!covers(result.spheres, mesh.original, control))
    throw Error(ErrorCode::kInternal,
                "spheres leave part of the surface uncovered. Please report the mesh" + (mesh.name.empty() ? "" : " '" + mesh.name + "'"));
  control.report(1);
  return result;
}

CertifiedSpheres certifiedSpheres(const TriangleMesh& mesh, const SphereOptions& options, const RunControl& control) {
  check(options);
  expectTriangles(mesh);
  const RepairedMesh repaired = repair(mesh, {}, control);
  const Solid solid(repaired, control);
  return certifiedSpheres({mesh, repaired, solid, repaired.counts.weld_distance, nullptr, ""}, options, control);
}

}  // namespace collision_hulls
