// Cover: each part of the original's surface against all bodies of the result. Protrusion: hulls and spheres by the certificates that
// decompose uses, meshes by mesh_protrusion.h, all against one solid made of all of the original. Round primitives of the original enter
// that solid as polyhedra inside them, which makes it smaller and the bound valid; cylinders of the result are searched as polyhedra around
// them.
#include "verify/compare_link.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "collision_hulls/error.h"
#include "collision_hulls/primitives/covering_primitive.h"
#include "fit/enclosing.h"
#include "measure/protrusion.h"
#include "verify/mesh_protrusion.h"
#include "verify/round_shapes.h"

namespace collision_hulls {
namespace {

constexpr double kGap = 1e-4;                  // of the diagonal: how far bound and found may be apart where both are small
constexpr double kCloseGap = 0.001;            // of what was found: how far apart they may be otherwise, as kCertificateGap in decompose
constexpr double kLeastGap = 0.01;             // of the gap before
constexpr double kGapsOfCertificate = 20;      // that make a tolerance of which a certificate leaves a few hundredths
constexpr std::size_t kSpareVisits = 500'000;  // as in decompose/certified_hulls.cpp
constexpr double kCovered = 1e-6;              // of the diagonal: samples that are this near count as covered
constexpr std::size_t kSamples = 2000;

/// A point of a triangle mesh: `i` counts along the area, and the R2 sequence, which is in two dimensions what R3 in measure/cover.cpp is
/// in three, spreads points over the triangles.
class AreaSamples {
 public:
  explicit AreaSamples(const TriangleMesh& mesh) : mesh_(mesh) {
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      const Eigen::Vector3d& a = mesh.corner(t, 0);
      area_ += (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).norm();
      below_.push_back(area_);
    }
  }
  bool empty() const { return !(area_ > 0); }
  Eigen::Vector3d at(std::size_t i) const {
    const double along = area_ * (static_cast<double>(i) + 0.5) / static_cast<double>(kSamples);
    const auto chosen = std::upper_bound(below_.begin(), below_.end() - 1, along);
    const int t = static_cast<int>(chosen - below_.begin());
    double u = std::fmod(0.5 + 0.7548776662466927 * static_cast<double>(i), 1),
           v = std::fmod(0.5 + 0.5698402909980532 * static_cast<double>(i), 1);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return (1 - u - v) * mesh_.corner(t, 0) + u * mesh_.corner(t, 1) + v * mesh_.corner(t, 2);
  }

 private:
  const TriangleMesh& mesh_;
  double area_ = 0;
  std::vector<double> below_;  // cumulative
};

}  // namespace

LinkPair::LinkPair(const LinkBodies& original, const LinkBodies& result, const RunControl& control)
    : original_(original), result_(result), bodies_(result, control) {
  for (const MeshBody& body : original.meshes) append(surface_, body.mesh);
  for (const GeometryElement& primitive : original.primitives) {
    const Approximation part = isRound(primitive) ? inscribed(primitive) : Approximation{hullAbout(primitive), 0};
    append(surface_, collision_hulls::surface(part.hull));
    surface_error_ = std::max(surface_error_, part.error);
  }
  solid_ = std::make_unique<Solid>(repair(surface_, {}, control), control);
}

/// A round primitive's points are within the polyhedron's error of the polyhedron's.
Largest LinkPair::uncovered(double gap, const RunControl& control) const {
  const Remainder rest = without(original_, result_, gap, control);
  const LinkBodies& left = rest.bodies;
  TriangleMesh flat;
  for (const MeshBody& body : left.meshes) append(flat, body.mesh);
  Largest worst{rest.apart, 0, Eigen::Vector3d::Zero()};
  for (const GeometryElement& primitive : left.primitives) {
    if (!isRound(primitive)) {
      append(flat, collision_hulls::surface(hullAbout(primitive)));
      continue;
    }
    const auto holds_it = [&](const ConvexHull& hull) { return holds(hull, primitive); };
    if (std::any_of(bodies_.hulls().begin(), bodies_.hulls().end(), holds_it)) continue;
    const Approximation round = inscribed(primitive);
    Largest largest = furthestFrom(bodies_, collision_hulls::surface(round.hull), gap, control);
    largest.bound += round.error;
    largest.found = std::max(0.0, largest.found - round.error);
    takeWorse(worst, largest);
  }
  if (!flat.triangles.empty()) takeWorse(worst, furthestFrom(bodies_, flat, gap, control));
  return worst;
}

/// Each sphere by itself, with a polyhedron about it that is as fine as the sphere protrudes little.
Largest LinkPair::sphereProtrusion(const std::vector<Sphere>& spheres, double gap, const RunControl& control) const {
  std::vector<Largest> all(spheres.size());
  forEach(spheres.size(), [&](std::size_t i) {
    const Primitive body{PrimitiveKind::kSphere, {spheres[i].radius, 0, 0}, Eigen::Isometry3d(Eigen::Translation3d(spheres[i].centre))};
    const CertifiedPrimitive seen = certificate(body, *solid_, 0, kGapsOfCertificate * gap, control);
    all[i] = {seen.bound, std::max(0.0, seen.found - surface_error_), seen.where};
  });
  Largest worst;
  for (const Largest& each : all) takeWorse(worst, each);
  return worst;
}

Largest LinkPair::hullProtrusion(const LinkBodies& bodies, double gap, double gate, const RunControl& control) const {
  std::vector<ConvexHull> around = bodies.hulls();
  double error = 0;
  for (const GeometryElement& primitive : bodies.primitives) {
    if (primitive.kind == GeometryElement::Kind::kSphere) continue;
    const Approximation part = isRound(primitive) ? circumscribed(primitive) : Approximation{hullAbout(primitive), 0};
    around.push_back(part.hull);
    error = std::max(error, part.error);
  }
  if (around.empty()) return {};
  Protrusion far = collision_hulls::protrusion(around, *solid_, gap, control);
  const auto look_closer = [&](double close) {
    const Protrusion again = collision_hulls::protrusion(around, *solid_, {close, 0, kSpareVisits}, control);
    far.bound = std::min(far.bound, again.bound);
    if (again.found > far.found) far.found = again.found, far.where = again.where, far.hull = again.hull;
  };
  const double close = std::max(kCloseGap * far.found, kLeastGap * gap);
  if (far.bound - far.found > close) look_closer(close);
  if (far.bound > gate && far.found < gate) look_closer(std::max((gate - far.found) / 2, kLeastGap * close));
  if (far.hull < 0) return {far.bound, 0, far.where};
  return {far.bound, std::max(0.0, far.found - error - surface_error_), far.where};
}

Largest LinkPair::protrusion(double gap, double gate, const RunControl& control) const {
  const Remainder rest = without(result_, original_, gap, control);
  const LinkBodies& left = rest.bodies;
  if (left.empty()) return {rest.apart, 0, Eigen::Vector3d::Zero()};
  const double margin = solid_->weldDistance() + original_.resolution;  // between the mesh as it was repaired, as it was read, and as it is
  std::vector<Sphere> spheres;
  for (const GeometryElement& primitive : left.primitives)
    if (primitive.kind == GeometryElement::Kind::kSphere) spheres.push_back({primitive.origin.translation(), primitive.size.x()});
  Largest worst{rest.apart, 0, Eigen::Vector3d::Zero()};
  takeWorse(worst, hullProtrusion(left, gap, gate - margin, control));
  takeWorse(worst, sphereProtrusion(spheres, gap, control));
  const TriangleMesh not_convex = left.rest();
  if (!not_convex.triangles.empty()) {
    const Protrusion far = meshProtrusion(not_convex, Solid(repair(not_convex, {}, control), control), *solid_, gap, control);
    takeWorse(worst, {far.bound, std::max(0.0, far.found - surface_error_), far.where});
  }
  double beyond = 0;
  for (const MeshBody& body : left.meshes) beyond = std::max(beyond, body.parts.beyond);
  worst.bound += margin + beyond;
  return worst;
}

double LinkPair::uncoveredShare() const {
  const AreaSamples samples(surface_);
  if (samples.empty()) return 0;
  std::size_t outside = 0;
  for (std::size_t i = 0; i < kSamples; ++i) outside += bodies_.distance(samples.at(i)) > kCovered * diagonal(surface_) + surface_error_;
  return static_cast<double>(outside) / static_cast<double>(kSamples);
}

void LinkPair::measure(LinkVerification& row, double gate, const RunControl& control) const {
  const double gap = kGap * row.diagonal;
  row.uncovered = uncovered(gap, control);
  row.protrusion = protrusion(gap, gate, control);
  row.uncovered_share = row.uncovered.bound > 0 ? uncoveredShare() : 0;
}

}  // namespace collision_hulls
