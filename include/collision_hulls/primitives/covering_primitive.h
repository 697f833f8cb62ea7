// One primitive in place of hulls, with a proof of how far it protrudes.
//
// For example:
//
//     const RepairedMesh repaired = repair(mesh);
//     const Solid solid(repaired);
//     const auto found = coveringPrimitive(convexHull(mesh.vertices), solid, {0.01});  // 1 cm
//     if (found) std::cout << name(found->primitive.kind) << " within " << found->bound << " m\n";
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/measure/solid.h"
#include "collision_hulls/primitives/primitive.h"

namespace collision_hulls {

/// A primitive with its proof. Lengths in metres, in the mesh's frame.
struct CertifiedPrimitive {
  Primitive primitive;
  /// Proved: no point of the primitive is further from S, the solid. Includes the margin.
  double bound = 0;
  /// The largest distance found, at `where`, a point of the primitive; `nearest` is the point of S
  /// nearest to it. The true protrusion lies between `found` and `bound`; see Protrusion.
  double found = 0;
  Eigen::Vector3d where = Eigen::Vector3d::Zero();
  Eigen::Vector3d nearest = Eigen::Vector3d::Zero();
};

struct PrimitiveOptions {
  double tolerance = 0;  ///< [m] > 0, and has to be set
  /// [m] >= 0: how far apart the surface of S and that of the original mesh may lie; see
  /// PreparedMesh
  double margin = 0;
  /// the first of these that stays within the tolerance is taken
  std::vector<PrimitiveKind> kinds = allPrimitiveKinds();
  /// [share of the radius] If above 0, the bound of a cylinder or capsule also holds for its
  /// hullAround() with this excess, which may stand for it where round shapes are not known.
  double bar_excess = 0;
};

/// A primitive that contains the hull and protrudes from S by no more than the tolerance; nullopt
/// if none was found. `hull`: of a whole mesh, or of any part of a cover of it. Deterministic. The
/// bound is as loose as the tolerance allows; certificate() finds a close one. Throws kBadOption
/// for a tolerance that is not a positive length or a margin that is negative or not finite,
/// kInternal and kEmptyMesh as enclosingPrimitive(), kCancelled.
std::optional<CertifiedPrimitive> coveringPrimitive(const ConvexHull& hull, const Solid& solid,
                                                    const PrimitiveOptions& options,
                                                    const RunControl& control = {});

/// The primitive of one kind that contains the hull, whatever its bound. Bound and found value
/// differ by a few hundredths of the tolerance, unless a search gives up; see protrusion(). Throws
/// as coveringPrimitive().
CertifiedPrimitive primitiveOfKind(PrimitiveKind kind, const ConvexHull& hull, const Solid& solid,
                                   const PrimitiveOptions& options, const RunControl& control = {});

/// The proof alone, for a primitive from anywhere. This and the following throw kBadOption as
/// coveringPrimitive(), kInternal as hullAround(), kCancelled.
CertifiedPrimitive certificate(const Primitive& primitive, const Solid& solid, double margin,
                               double tolerance, const RunControl& control = {});

/// The proof for all of a model's primitives at once, which takes far less time than one by one: no
/// point of any of them is further than the bound, which is as close as for hulls; see
/// certificate() of hulls. `primitive`: one that holds `where`. `options.kinds` is not used.
CertifiedPrimitive certificate(const std::vector<Primitive>& primitives, const Solid& solid,
                               const PrimitiveOptions& options, const RunControl& control = {});

}  // namespace collision_hulls
