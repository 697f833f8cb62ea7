// Parts of space in which hulls may protrude less than elsewhere: the gap between two fingers, the
// inside of a hook, the plane that a robot is mounted on.
//
// For example:
//
//     #include "collision_hulls/decompose/decompose.h"
//
//     DecomposeOptions options;
//     options.tolerance = 0.02;  // [m]
//     options.regions = {boxRegion({0.08, 0.2, 0.03}, pose, 0.001)};
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// [m] A region's rim, the points no deeper in it than this, does not count: hulls of a surface
/// that ends at a region touch it.
constexpr double kRegionRim = 1e-5;
/// [m] The least tolerance of a region: no hull enters it but beside the solid, which is what
/// keeping it clear means.
constexpr double kRegionSlack = 1e-4;

/// A convex part of space, in the frame of the mesh or link that it belongs to.
struct Region {
  std::vector<HalfSpace> sides;  ///< its points lie in all of them
  /// [m] > 0: how far a point of a hull in the region may lie from the solid
  double tolerance = kRegionSlack;
  std::string name;  ///< for messages and reports
};

/// Throws kBadOption unless it has sides, whose normals have unit length (to a millionth) and whose
/// offsets are finite, and a tolerance that is a positive length.
void check(const Region& region);

/// A box with these sides [m], > 0, about the origin of `pose`. Throws kBadOption, also for a pose
/// that is not rigid or not finite.
Region boxRegion(const Eigen::Vector3d& size, const Eigen::Isometry3d& pose, double tolerance);

/// The points p with normal . p >= offset [m]; the normal, which may have any length but 0, points
/// into the region. Throws kBadOption.
Region halfSpaceRegion(const Eigen::Vector3d& normal, double offset, double tolerance);

/// The region moved by a rigid transform. Throws nothing: check() refuses what another one gives.
Region transformed(const Region& region, const Eigen::Isometry3d& pose);

/// Whether they are the same work: all but their names.
bool equal(const std::vector<Region>& a, const std::vector<Region>& b);

/// The part of the hull in the region without its rim, and a little more; nullopt if none is.
std::optional<ConvexHull> partIn(const ConvexHull& hull, const Region& region);

}  // namespace collision_hulls
