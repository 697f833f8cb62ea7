// How good a hull set is: cover, protrusion (with proof), volumes.
//
// Hulls may be from anywhere: convexHull() makes one from the vertices that another program wrote.
// All functions throw what check() of hulls throws.
//
// For example:
//
//     const std::vector<ConvexHull> hulls{convexHull(points)};
//     const Solid solid(repair(mesh));
//     const Protrusion proved = protrusion(hulls, solid, 1e-4);  // to 0.1 mm
//     const bool good = uncovered(mesh, hulls) == 0 && proved.bound <= 0.01;  // [m]
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/measure/solid.h"

namespace collision_hulls {

/// The largest distance [m] of a point of the mesh's surface from the union of the hulls; 0 if and
/// only if they cover it, infinite without hulls. A triangle whose corners lie in one hull is
/// covered; any other is clipped by the hulls until nothing is left. The result is never too small,
/// and too large by at most 1 % unless the gaps take more than 400,000 pieces. Distances below
/// 1e-12 of the coordinates' size are rounding errors of this computation and count as 0. Throws
/// what check() of a mesh throws: kIndexOutOfRange, kNonFiniteCoordinate, kCancelled.
double uncovered(const TriangleMesh& mesh, const std::vector<ConvexHull>& hulls,
                 const RunControl& control = {});

/// The protrusion of a hull set: the one-sided Hausdorff distance from the hulls to S, i.e. the
/// largest distance of a point of the hulls from S. If S has openings, `found` refers to the
/// distance to the surface; S may be nearer than that.
struct Protrusion {
  /// [m] certified: no point of a hull is further from S
  double bound = 0;
  double found = 0;                                   ///< [m] largest distance found, at `where`
  Eigen::Vector3d where = Eigen::Vector3d::Zero();    ///< a point of a hull at the distance `found`
  Eigen::Vector3d nearest = Eigen::Vector3d::Zero();  ///< the point of S nearest to `where`
  int hull = -1;                                      ///< the hull that contains `where`
};

/// Branch and bound over each hull's faces and interior. On return bound - found <= gap (> 0, [m]),
/// or more if the search does not converge in two million steps on a hull's surface (as in the
/// plane of an opening) or in 60,000 in its interior (as along a narrow gap). A bound below a
/// hundred gaps is final after 100,000 steps. For rounding, the bound includes 1e-12 of the size of
/// the hulls' coordinates or of the mesh's extent, what of a hull may lie beyond its triangles, and
/// Solid::sideError(). Throws kBadOption for a gap that is not positive and finite, kCancelled.
Protrusion protrusion(const std::vector<ConvexHull>& hulls, const Solid& solid, double gap,
                      const RunControl& control = {});

/// The volume of the union of the hulls [m^3]: exact for one hull and for disjoint hulls, 0 for
/// none. What hulls share is estimated (to about 1 % of it) from a fixed sequence of samples:
/// 20,000 shared out by volume, but at least 50 in each hull. Throws kCancelled.
double unionVolume(const std::vector<ConvexHull>& hulls, const RunControl& control = {});

/// The share of the inside of S that lies in the hulls, assuming they cover its surface; by 20,000
/// samples of the same sequence in their bounding box. 1 for a solid without an inside, and without
/// hulls, which cover no solid's surface. What is missing lies deep inside, where hulls of pieces
/// of the surface do not reach. Throws kCancelled.
double coveredShare(const std::vector<ConvexHull>& hulls, const Solid& solid,
                    const RunControl& control = {});

}  // namespace collision_hulls
