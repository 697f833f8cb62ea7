// K. Mamou and F. Ghorbel, "A simple and efficient approach for 3D mesh approximate convex
// decomposition", ICIP 2009.
//
// The paper's method, unchanged: the reference for all other methods. Its concavity looks along the
// normals of a cluster's own triangles and does not bound the protrusion: a flat, non-convex band
// (the end face of a U-channel) and the outer wall of a cup have none at all, although their hulls
// fill the gap.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// Equation (3): E_shape = rho^2 / (4 pi sigma) of a surface with perimeter rho [m] and area sigma
/// [m^2]; 1 for a disk, infinite if the area is 0.
double aspectRatio(double perimeter, double area);

/// Equation (4): E = C / D + alpha E_shape; concavity C and diagonal D in metres.
double decimationCost(double concavity, double diagonal, double alpha, double shape);

/// Equation (6): C(S) [m] of a set of triangles: max over the points M of S of ||M - P(M)||, where
/// the half-ray from M along the normal of M's triangle leaves the convex hull of S at P(M). Exact,
/// except that values below 1e-6 of the mesh's diagonal count as 0. 0 for an empty set.
double concavity(const TriangleMesh& mesh, const std::vector<int>& triangles);

/// Equation (7): alpha = epsilon / (10 D).
double shapeWeight(double epsilon, double diagonal);

/// Equation (5): the partition {p_k, A(p_k)} of the mesh's triangles that remains once no edge of
/// the dual graph gives a cluster of concavity up to `epsilon` [m]. Triangles ascend within a
/// cluster; clusters are ordered by first triangle. A mesh without triangles has none.
/// Deterministic; ties are broken by index. Throws kBadOption for an epsilon that is not a positive
/// length, or below a millionth of the mesh's diagonal; kIndexOutOfRange, kNonFiniteCoordinate,
/// kCancelled.
std::vector<std::vector<int>> hacdPartition(const TriangleMesh& mesh, double epsilon,
                                            const RunControl& control = {});

/// A partition and the hierarchy that it is a cut through.
///
/// Decimation goes on beyond epsilon, with the same alpha, until each connected piece of the mesh
/// is one cluster. C never decreases when clusters grow, so for each e the clusters of concavity up
/// to e that are in no larger such cluster are a partition: the hierarchy's cut at e. At epsilon
/// the cut is hacdPartition(). At another e, hacdPartition() may differ from the cut, since alpha
/// depends on epsilon.
struct Segmentation {
  std::vector<std::vector<int>> clusters;  ///< hacdPartition()
  /// [m] ascending: C of each cluster that is not a triangle
  std::vector<double> merges;
};
/// Throws as hacdPartition().
Segmentation hacdSegmentation(const TriangleMesh& mesh, double epsilon,
                              const RunControl& control = {});

/// K(e): the number of clusters of the hierarchy's cut at `epsilon` [m]; each merge up to it saves
/// one.
std::size_t clustersAt(const Segmentation& segmentation, double epsilon);

}  // namespace collision_hulls
