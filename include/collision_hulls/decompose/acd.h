// J.-M. Lien and N. M. Amato, "Approximate convex decomposition of polyhedra", ACM Symposium on
// Solid and Physical Modeling 2007; in full in "Approximate convex decomposition of polyhedra and
// its applications", Computer Aided Geometric Design 25 (2008); first for polygons, SoCG 2004.
// Mamou and Ghorbel 2009, section 2, compare their method with this one; here it is a baseline:
//
//   parts = the mesh's components
//   while some part's concavity exceeds epsilon and there are not too many parts:
//     x = the notch of highest concavity; cut its part by the plane through x that bisects the
//         angle there
//
// This is a simple version. Its concavity is the paper's straight-line concavity: the distance from
// a notch (a reflex edge; the paper's pockets have one at their bottom) to its bridge, the hull
// face over its pocket. The bridge is taken to be the nearest face that the notch opens towards,
// where the paper projects hull edges onto the surface. Features are not grouped, and handles need
// no special care because planes cut through them. The concavity does not bound the protrusion:
// space that no notch faces, such as the bore of a coarse ring seen from its end, does not count.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

/// The hulls of the parts once no part's concavity exceeds `epsilon` [m]. They cover the mesh and
/// its loose segments. Cuts the most concave part first and stops at 2,000 parts, which guarantees
/// termination. Deterministic. Throws kBadOption for an epsilon that is not a positive length, or
/// below a millionth of the mesh's diagonal; kEmptyMesh, kCancelled.
std::vector<ConvexHull> acdHulls(const RepairedMesh& mesh, double epsilon,
                                 const RunControl& control = {});

}  // namespace collision_hulls
