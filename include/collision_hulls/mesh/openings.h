// The openings of a shell (a surface without thickness), and lids that close them. A shell with
// lids counts as the solid whose skin it is, such as a housing that is open where it is mounted.
//
// For example:
//
//     #include "collision_hulls/decompose/certified_hulls.h"
//
//     const TriangleMesh closed = closeOpenings(mesh, 0.1);  // those no wider than 10 cm
//     const CertifiedHulls result = certifiedHulls(closed, options);
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

/// A loop of edges that have one triangle each.
struct Opening {
  std::vector<Eigen::Vector3d> rim;  ///< [m] its corners, in the direction of the triangles' edges
  Eigen::Vector3d center;            ///< [m] the rim's mean point, weighted by length
  /// [m] twice the largest distance from the centre to the rim: the diameter of a round opening,
  /// the diagonal of a rectangular one
  double width = 0;
};

/// The openings of a mesh. Fins have none, and neither have components that would enclose nothing
/// even with lids, such as a flat sheet. Both ends of a pipe without thickness are openings; those
/// of a pipe whose wall has an inner and an outer surface are not: such a mesh is closed.
/// Near-linear. Deterministic. Throws kCancelled.
std::vector<Opening> openingsOf(const RepairedMesh& mesh, const RunControl& control = {});

/// Adds a lid: a fan of triangles from the rim to the centre, with vertices of its own.
void addLid(const Opening& opening, TriangleMesh& mesh);

/// The mesh, with lids over all openings that are no wider than `width` [m]; as it is for a width
/// of 0. Throws kBadOption for a width that is negative or not finite, and what repair() throws.
TriangleMesh closeOpenings(const TriangleMesh& mesh, double width, const RunControl& control = {});

}  // namespace collision_hulls
