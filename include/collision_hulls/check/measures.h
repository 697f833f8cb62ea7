// What a hull set is worth: cover, protrusion (with proof), volumes.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_hulls/check/solid.h"
#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Largest distance [m] of a point of the mesh's surface to the union of the hulls; 0 when they cover it, and only then: a
/// triangle whose corners lie in one hull is covered, any other is clipped by the hulls until nothing is left. Never too small,
/// and too large by 1 % at most unless a triangle's gaps take more than some hundred pieces. Distances below 1e-12 of the coordinates' size
/// are rounding of this computation and count as 0.
double uncovered(const TriangleMesh& mesh, const std::vector<ConvexHull>& hulls, const RunControl& control = {});

/// The protrusion of a hull set: max over points of the hulls of the distance to S; one-sided Hausdorff distance. Where S has openings,
/// `found` is of the distance to the surface, which S may end nearer than.
struct Protrusion {
  double bound = 0;                                   ///< [m] certified: no point of a hull is further from S
  double found = 0;                                   ///< [m] largest distance found, at `where`
  Eigen::Vector3d where = Eigen::Vector3d::Zero();    ///< a point of a hull at distance `found`
  Eigen::Vector3d nearest = Eigen::Vector3d::Zero();  ///< the point of S nearest to it
  int hull = -1;                                      ///< the hull that `where` belongs to
};

/// Branch and bound over each hull's faces and interior; bound - found <= gap (> 0, [m]) on return, or more where the search does not
/// close in on a hull in two million steps, as in the plane of an opening, or in 60,000 within, as along a narrow gap. A bound below
/// twelve gaps is left as it is after 100,000 steps.
Protrusion protrusion(const std::vector<ConvexHull>& hulls, const Solid& solid, double gap, const RunControl& control = {});

/// Volume of the union of the hulls [m^3]: exact for one hull and for hulls apart; what they share is told by samples of a fixed sequence
/// within each of them, 20,000 in all (error about 1 % of it).
double unionVolume(const std::vector<ConvexHull>& hulls);

/// Share of the inside of S that lies in hulls that cover its surface, by the same sequence; 1 for a solid without an inside. What is
/// missing lies deep within, where hulls of pieces of the surface do not reach.
double coveredShare(const std::vector<ConvexHull>& hulls, const Solid& solid);

}  // namespace collision_hulls
