// Fit, glance, prove. A primitive is dropped at a glance if a point of it is beyond the tolerance. What is left is proved by the
// certificate of hulls (decompose/certified_hulls.h) for a polyhedron around the primitive: whatever bounds that one's protrusion bounds
// the primitive's, which it contains. The polyhedron is larger by a small share of the tolerance, so little is lost; a box is its own
// polyhedron. Whether the bound is within the tolerance hardly ever takes a close look: the same search with a wide gap settles it for most
// primitives in a tenth of the time.
#include "collision_hulls/primitives/covering_primitive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/positive_length.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "decompose/margin.h"
#include "measure/protrusion.h"

namespace collision_hulls {

namespace {

constexpr double kExcess = 0.02;       // of the tolerance: how far the polyhedron of a proof reaches beyond its primitive
constexpr double kGlanceExcess = 0.1;  // of the size: of the polyhedron whose points are looked at first
constexpr int kGlances = 6;            // points per edge of that one
// Of the tolerance: how closely a primitive is looked at before the certificate decides whether it keeps the tolerance.
constexpr double kWideGap = 0.1, kNarrowerGap = 0.01;
constexpr double kBelow = 1.5;  // gaps: what is this far below the tolerance does not matter then

/// Notes p, a point of the primitive, if it is the furthest so far.
void look(CertifiedPrimitive& result, const Solid& solid, const Eigen::Vector3d& p) {
  const TriangleBvh::Nearest near = solid.surface().nearest(p);
  if (near.distance > result.found && !solid.contains(p)) {
    result.found = near.distance;
    result.where = p;
    result.nearest = near.point;
  }
}

/// Looks at points all over the primitive's surface, until one is further than `enough`.
void glance(CertifiedPrimitive& result, const Solid& solid, double enough, const RunControl& control) {
  const ConvexHull around = hullAround(result.primitive, kGlanceExcess * result.primitive.size.maxCoeff());
  for (const Triangle& t : around.triangles) {
    control.check();
    const auto corner = [&](std::size_t k) -> const Eigen::Vector3d& { return around.vertices[static_cast<std::size_t>(t[k])]; };
    for (int i = 0; i <= kGlances; ++i)
      for (int j = 0; i + j <= kGlances && result.found <= enough; ++j) {
        const Eigen::Vector3d p = corner(0) + (corner(1) - corner(0)) * i / kGlances + (corner(2) - corner(0)) * j / kGlances;
        look(result, solid, nearestPoint(result.primitive, p));
      }
  }
}

/// What is proved in place of a primitive.
ConvexHull polyhedronFor(const Primitive& primitive, const PrimitiveOptions& options, double scale) {
  const bool is_bar = primitive.kind == PrimitiveKind::kCylinder || primitive.kind == PrimitiveKind::kCapsule;
  return hullAround(primitive, is_bar && options.bar_excess > 0 ? options.bar_excess * primitive.size.x() : kExcess * scale);
}

/// The bound on the primitives in these polyhedra; `result` is one that reaches as far as was found.
void prove(CertifiedPrimitive& result, const std::vector<Primitive>& primitives, const Solid& solid, const PrimitiveOptions& options,
           const RunControl& control) {
  // Far beyond the tolerance, a bound need not be any closer than a share of what was found.
  const double scale = std::max(options.tolerance, result.found);
  std::vector<ConvexHull> around;
  for (const Primitive& primitive : primitives) around.push_back(polyhedronFor(primitive, options, scale));
  const Protrusion proof = certificate(around, solid, options.margin, scale, control);
  result.bound = proof.bound;
  if (proof.hull >= 0) result.primitive = primitives[static_cast<std::size_t>(proof.hull)];
  look(result, solid, nearestPoint(result.primitive, proof.where));
}

/// Whether a primitive's bound is within the tolerance. The gap shrinks only as long as that is open.
bool isWithin(CertifiedPrimitive& result, const Solid& solid, const PrimitiveOptions& options, const RunControl& control) {
  const std::vector<ConvexHull> around{polyhedronFor(result.primitive, options, options.tolerance)};
  const double most = options.tolerance - options.margin;
  for (const double share : {kWideGap, kNarrowerGap}) {
    const double gap = share * options.tolerance;
    const Protrusion seen = protrusion(around, solid, {gap, 0, 0, std::max(0.0, most - kBelow * gap)}, control);
    look(result, solid, nearestPoint(result.primitive, seen.where));
    result.bound = seen.bound + options.margin;
    if (result.bound <= options.tolerance) return true;
    if (seen.found > most) return false;
  }
  prove(result, {result.primitive}, solid, options, control);
  return result.bound <= options.tolerance;
}

void check(const PrimitiveOptions& options) {
  expectPositiveLength("the tolerance of a primitive", options.tolerance);
  expectMargin(options.margin);
}

CertifiedPrimitive seenAndProved(const Primitive& primitive, const Solid& solid, const PrimitiveOptions& options,
                                 const RunControl& control) {
  check(options);
  CertifiedPrimitive result;
  result.primitive = primitive;
  glance(result, solid, std::numeric_limits<double>::infinity(), control);
  prove(result, {primitive}, solid, options, control);
  return result;
}

}  // namespace

CertifiedPrimitive certificate(const Primitive& primitive, const Solid& solid, double margin, double tolerance, const RunControl& control) {
  PrimitiveOptions options;
  options.tolerance = tolerance;
  options.margin = margin;
  return seenAndProved(primitive, solid, options, control);
}

CertifiedPrimitive certificate(const std::vector<Primitive>& primitives, const Solid& solid, const PrimitiveOptions& options,
                               const RunControl& control) {
  check(options);
  CertifiedPrimitive result;
  if (!primitives.empty()) prove(result, primitives, solid, options, control);
  return result;
}

CertifiedPrimitive primitiveOfKind(PrimitiveKind kind, const ConvexHull& hull, const Solid& solid, const PrimitiveOptions& options,
                                   const RunControl& control) {
  return seenAndProved(enclosingPrimitive(kind, hull, control), solid, options, control);
}

std::optional<CertifiedPrimitive> coveringPrimitive(const ConvexHull& hull, const Solid& solid, const PrimitiveOptions& options,
                                                    const RunControl& control) {
  check(options);
  for (const PrimitiveKind kind : options.kinds) {
    CertifiedPrimitive result;
    result.primitive = enclosingPrimitive(kind, hull, control);
    glance(result, solid, options.tolerance, control);
    if (result.found > options.tolerance) continue;
    if (isWithin(result, solid, options, control)) return result;
  }
  return std::nullopt;
}

}  // namespace collision_hulls
