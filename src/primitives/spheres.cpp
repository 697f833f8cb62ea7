// The space that spheres may fill (tolerable_space.h), a choice of few spheres in it (sphere_choice.h), each made to protrude as little as
// the others let it (sphere_shrinking.h), and the proof of what is returned: that they cover the mesh, tested with the radii as they are,
// and each sphere's bound, which the space gives for that place and radius, whoever chose them.
#include "collision_hulls/primitives/spheres.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/counted.h"
#include "base/decimal.h"
#include "base/millimetres.h"
#include "primitives/sphere_choice.h"
#include "primitives/sphere_cover.h"
#include "primitives/sphere_shrinking.h"
#include "primitives/tolerable_space.h"

namespace collision_hulls {

namespace {

constexpr double kRounding = 1e-12;       // of the coordinates, as in measure/protrusion.cpp
constexpr double kLeastTolerance = 1e-5;  // of the coordinates: far above single precision, in which spheres are given
constexpr double kMargins = 4;            // the least tolerance, in margins
constexpr double kRaise = 4;              // factor by which the tolerance is raised if there are too many spheres
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
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance))
    throw Error(ErrorCode::kBadOption, "the tolerance of spheres is " + fixedDecimal(options.tolerance) + " m; it must be above 0");
  if (options.max_spheres < 1) throw Error(ErrorCode::kBadOption, "a limit of 0 spheres; a mesh needs at least 1");
}

std::size_t workFor(Effort effort) {
  return effort == Effort::kInstant ? 0 : effort == Effort::kQuick ? kQuickWork : kBestWork;
}

/// nullopt if it takes too many.
std::optional<CertifiedSpheres> spheresWithin(double tolerance, const PreparedMesh& mesh, const SphereOptions& options,
                                              const RunControl& control) {
  Eigen::AlignedBox3d box = boundingBox(mesh.original);
  box.extend(boundingBox(mesh.repaired.mesh));
  const double allowance = mesh.margin + kRounding * sizeOf(mesh.original) + mesh.solid.sideError();
  const TolerableSpace space(mesh.solid, box, tolerance - allowance, control);
  const auto spheres = fewSpheres(mesh.original, space, {options.max_spheres, workFor(options.effort)}, control);
  if (!spheres) return std::nullopt;
  CertifiedSpheres result;
  result.spheres = shrunk(*spheres, mesh.original, space, control);
  std::stable_sort(result.spheres.begin(), result.spheres.end(), [](const Sphere& a, const Sphere& b) { return a.radius > b.radius; });
  for (const Sphere& sphere : result.spheres) result.bounds.push_back(space.bound(sphere) + allowance);
  result.bound = *std::max_element(result.bounds.begin(), result.bounds.end());
  return result;
}

}  // namespace

bool covers(const std::vector<Sphere>& spheres, const TriangleMesh& mesh, const RunControl& control) {
  const double size = sizeOf(mesh);
  return gapsIn(mesh, spheres, {kLeastDepth * size, size}, control).empty();
}

CertifiedSpheres certifiedSpheres(const PreparedMesh& mesh, const SphereOptions& options, const RunControl& control) {
  check(options);
  const std::string asked = "the tolerance of " + millimetres(options.tolerance);
  const double least = std::max(kMargins * mesh.margin, kLeastTolerance * sizeOf(mesh.original));
  std::string reason;
  if (options.tolerance < least) reason = asked + " is too small for this mesh";
  for (double tolerance = std::max(options.tolerance, least);; tolerance *= kRaise) {
    std::optional<CertifiedSpheres> result = spheresWithin(tolerance, mesh, options, control);
    if (!result) {
      reason = spheresDo(options.max_spheres, " not cover the mesh within ") + asked;
      continue;
    }
    result->within_tolerance = result->bound <= options.tolerance;
    if (!covers(result->spheres, mesh.original, control))
      throw Error(ErrorCode::kInternal, "spheres leave part of the surface uncovered. Please report the mesh" +
                                            (mesh.name.empty() ? "" : " '" + mesh.name + "'"));
    if (!result->within_tolerance) result->reason = reason + "; " + spheresDo(result->spheres.size(), " within ") + millimetres(tolerance);
    return *result;
  }
}

CertifiedSpheres certifiedSpheres(const TriangleMesh& mesh, const SphereOptions& options, const RunControl& control) {
  check(options);
  if (mesh.triangles.empty()) throw Error(ErrorCode::kEmptyMesh, "the mesh has no triangles; spheres need at least one");
  const RepairedMesh repaired = repair(mesh, {}, control);
  const Solid solid(repaired, control);
  return certifiedSpheres({mesh, repaired, solid, repaired.counts.weld_distance, nullptr, ""}, options, control);
}

}  // namespace collision_hulls
