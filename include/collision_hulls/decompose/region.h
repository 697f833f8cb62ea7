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

/// [m] A region's rim, the points no deeper in it than this, does not count, so that hulls of a
/// surface that ends at a region may touch it.
constexpr double kRegionRim = 1e-5;
/// [m] The default tolerance of a region: it stays clear of hulls, but for a skin of this depth
/// over the solid. Meshes of any size take it; a smaller one must be at least a millionth of the
/// mesh's diagonal, see certifiedHulls().
constexpr double kRegionSlack = 1e-4;

/// A convex part of space, in the frame of the mesh or link that it belongs to.
struct Region {
  std::vector<HalfSpace> sides;  ///< its points lie in all of them
  /// [m] > 0: how far a point of a hull in the region may lie from the solid
  double tolerance = kRegionSlack;
  std::string name;  ///< for messages and reports
};

/// Throws kBadOption unless the region has sides, their normals have unit length (to a millionth)
/// and their offsets are finite, and its tolerance is a positive length.
void check(const Region& region);

/// A box with these sides [m], > 0, about the origin of `pose`. Throws kBadOption, also for a pose
/// that is not finite or not rigid.
Region boxRegion(const Eigen::Vector3d& size, const Eigen::Isometry3d& pose, double tolerance);

/// The points p with normal . p >= offset [m]; the normal, which may have any length but 0, points
/// into the region. Throws kBadOption.
Region halfSpaceRegion(const Eigen::Vector3d& normal, double offset, double tolerance);

/// The region moved by a rigid transform. Does not check that it is one.
Region transformed(const Region& region, const Eigen::Isometry3d& pose);

/// Whether the regions are equal but for their names.
bool equal(const std::vector<Region>& a, const std::vector<Region>& b);

/// The part of the hull that is at least half a rim deep in the region, which holds all that is
/// deeper than the rim; nullopt if there is none.
std::optional<ConvexHull> partIn(const ConvexHull& hull, const Region& region);

}  // namespace collision_hulls
