// 1. The space that spheres may fill: what is within the tolerance of the solid (tolerable_space.h).
// 2. Candidates: the largest balls in it, at points all over the surface (sphere_candidates.h).
// 3. A choice: few candidates that hold all of these points (set_cover.h).
// 4. Gaps: parts of the surface that are in none of the chosen balls (sphere_cover.h). Points in them join those that must be held, and the
// choice
//    is made again, until there are no gaps.
// 5. Refinement: candidates next to the chosen ones join, and the choice is made again; the smallest cover without gaps counts.
// 6. The bound of each sphere: what the space promises of a ball at that place, asked anew.
//
// The points are few and the proof is exact, so the work goes where spheres meet.
#include "collision_hulls/primitives/spheres.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/millimetres.h"
#include "base/parallel.h"
#include "primitives/set_cover.h"
#include "primitives/sphere_candidates.h"
#include "primitives/sphere_cover.h"
#include "primitives/tolerable_space.h"

namespace collision_hulls {

namespace {

constexpr double kRounding = 1e-12;  // of the coordinates and of the mesh's extent, as in measure/protrusion.cpp
constexpr double kDepth = 0.01;      // of the tolerance: how deep a sphere must hold points
constexpr double kGrain = 0.25;      // of the tolerance: length of the pieces whose gaps count singly
constexpr double kSpacing = 0.35;    // of the tolerance: between points
constexpr std::size_t kLeastPoints = 500, kMostPoints = 12'000, kMostSeeds = 3000;
constexpr std::size_t kWork = 20'000'000;  // of a choice
constexpr int kSearching = 24, kRounds = 100;

class Chooser {
 public:
  Chooser(const TriangleMesh& mesh, const TolerableSpace& space, const RunControl& control)
      : mesh_(mesh), space_(space), control_(control) {
    const double spacing = kSpacing * space.tolerance();
    const double wanted = area(mesh) / (spacing * spacing);
    const auto count = static_cast<std::size_t>(std::clamp(wanted, double{kLeastPoints}, double{kMostPoints}));
    const std::vector<SurfacePoint> points = spreadOver(mesh, count);
    addCandidates(spreadOver(mesh, std::min(count, kMostSeeds)));
    std::vector<Eigen::Vector3d> places;
    for (const SurfacePoint& at : points) places.push_back(at.p);
    addPoints(places);
  }

  std::vector<Sphere> spheres() {
    std::vector<int> chosen;
    for (int round = 0; round < kRounds; ++round) {
      chosen = fewSets(system_, chosen, round < kSearching ? kWork : 0, control_);
      const std::vector<Eigen::Vector3d> gaps =
          gapsIn(mesh_, spheresOf(chosen), {kDepth * space_.tolerance(), kGrain * space_.tolerance()}, control_);
      if (gaps.empty()) return spheresOf(chosen);
      addPoints(gaps);
    }
    throw Error(ErrorCode::kInternal, "the spheres leave gaps");
  }

 private:
  bool holds(const Sphere& sphere, const Eigen::Vector3d& p) const {
    const double radius = sphere.radius - kDepth * space_.tolerance();
    return radius > 0 && (p - sphere.centre).squaredNorm() <= radius * radius;
  }

  void addCandidates(const std::vector<SurfacePoint>& seeds) {
    std::vector<std::vector<Sphere>> found(seeds.size());
    forEach(seeds.size(), [&](std::size_t i) {
      control_.check();
      found[i] = largestAt(seeds[i], space_);
    });
    for (const std::vector<Sphere>& spheres : found)
      for (const Sphere& sphere : spheres) add(sphere);
  }

  void add(const Sphere& sphere) {
    candidates_.push_back(sphere);
    system_.sets.emplace_back();
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (holds(sphere, points_[i])) system_.sets.back().push_back(static_cast<int>(i));
  }

  /// Each point comes with a candidate that holds it.
  void addPoints(const std::vector<Eigen::Vector3d>& points) {
    std::vector<Sphere> own(points.size());
    forEach(points.size(), [&](std::size_t i) { own[i] = enlarged(sphereAt(points[i], space_), space_); });
    const std::size_t first = points_.size();
    points_.insert(points_.end(), points.begin(), points.end());
    system_.elements = points_.size();
    forEach(candidates_.size(), [&](std::size_t s) {
      for (std::size_t i = first; i < points_.size(); ++i)
        if (holds(candidates_[s], points_[i])) system_.sets[s].push_back(static_cast<int>(i));
    });
    for (std::size_t i = 0; i < own.size(); ++i) {
      const auto held = [&](const Sphere& sphere) { return holds(sphere, points[i]); };
      if (std::none_of(candidates_.begin(), candidates_.end(), held)) add(held(own[i]) ? own[i] : sphereAt(points[i], space_));
    }
  }

  std::vector<Sphere> spheresOf(const std::vector<int>& chosen) const {
    std::vector<Sphere> result;
    for (const int s : chosen) result.push_back(candidates_[static_cast<std::size_t>(s)]);
    return result;
  }

  const TriangleMesh& mesh_;
  const TolerableSpace& space_;
  const RunControl& control_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Sphere> candidates_;
  SetSystem system_;  // points held by candidates
};

void check(const SphereOptions& options) {
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance))
    throw Error(ErrorCode::kBadOption, "the tolerance of spheres is " + std::to_string(options.tolerance) + "; it must be above 0");
  if (options.max_spheres < 1) throw Error(ErrorCode::kBadOption, "at most 0 spheres; a mesh needs at least one");
}

}  // namespace

bool covers(const std::vector<Sphere>& spheres, const TriangleMesh& mesh, const RunControl& control) {
  const Eigen::AlignedBox3d box = boundingBox(mesh);
  const double size = box.isEmpty() ? 0 : box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  return gapsIn(mesh, spheres, {1e-6 * size, 2 * size}, control).empty();
}

CertifiedSpheres certifiedSpheres(const PreparedMesh& mesh, const SphereOptions& options, const RunControl& control) {
  check(options);
  Eigen::AlignedBox3d box = boundingBox(mesh.original);
  box.extend(boundingBox(mesh.repaired.mesh));
  const double rounding = kRounding * box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff() + mesh.solid.sideError();
  const double aim = options.tolerance - mesh.margin - rounding;
  const TolerableSpace space(mesh.solid, box, aim, control);
  CertifiedSpheres result;
  result.spheres = Chooser(mesh.original, space, control).spheres();
  for (const Sphere& sphere : result.spheres) {
    result.bounds.push_back(space.bound(sphere) + mesh.margin + rounding);
    result.bound = std::max(result.bound, result.bounds.back());
  }
  return result;
}

CertifiedSpheres certifiedSpheres(const TriangleMesh& mesh, const SphereOptions& options, const RunControl& control) {
  check(options);
  if (mesh.triangles.empty()) throw Error(ErrorCode::kEmptyMesh, "the mesh has no triangles; spheres need at least one");
  const RepairedMesh repaired = repair(mesh, {}, control);
  const Solid solid(repaired, control);
  return certifiedSpheres({mesh, repaired, solid, repaired.counts.weld_distance, nullptr, ""}, options, control);
}

}  // namespace collision_hulls
