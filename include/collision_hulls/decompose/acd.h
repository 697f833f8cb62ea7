// J.-M. Lien and N. M. Amato, "Approximate convex decomposition of polyhedra", ACM Symposium on Solid and Physical Modeling 2007; at
// length in "Approximate convex decomposition of polyhedra and its applications", Computer Aided Geometric Design 25 (2008); first for
// polygons, SoCG 2004. It is the method that Mamou and Ghorbel 2009, section 2, compare theirs with, and a baseline here:
//
//   parts = the mesh's components
//   while some part's concavity is above epsilon, and there are not too many parts:
//     x = the notch of highest concavity of all; cut its part by the plane through x that bisects the angle there
//
// Kept simple. The concavity is the paper's straight-line one: the distance from a notch (a reflex edge; the paper's pockets have one
// at their bottom) to its bridge, the face of the hull over its pocket. The bridge is taken to be the nearest face that the notch opens
// towards, in place of the paper's projection of hull edges onto the surface; features are not grouped, and a handle needs no special
// care, since planes cut through it. No bound on protrusion: what no notch faces, such as the bore of a coarse ring seen from its
// end, counts for nothing.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

/// Straight-line concavity [m] of a surface: max over its notches x of the distance from x to the nearest face of the convex hull that
/// x opens towards; 0 without notches. `two_sided`: the surface is a sheet, and an edge is a notch from one side or the other.
double straightLineConcavity(const TriangleMesh& mesh, bool two_sided = false);

/// The hulls of the parts that are left once no part's concavity is above `epsilon` [m], > 0; they cover mesh and loose segments. At most
/// 2,000 parts, of which the most concave are cut first, so that the end is certain. Deterministic. Throws kCancelled.
std::vector<ConvexHull> acdHulls(const RepairedMesh& mesh, double epsilon, const RunControl& control = {});

}  // namespace collision_hulls
