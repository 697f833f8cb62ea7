// Oriented boxes about hulls.
#pragma once

#include <optional>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// The smallest oriented box found about a hull, as a hull of 8 vertices that contains it. Tried are the boxes with one side
/// flush with a face of the hull, along the mesh's axes, or along the principal axes of the vertices, each with the smallest
/// rectangle about the rest (exact, by rotating calipers). The smallest box of all need not have a side flush with a face, but
/// is seldom much smaller. Of hulls with very many faces the largest ones are tried. A thickened hull gives a thickened box.
/// Throws kCancelled.
ConvexHull orientedBox(const ConvexHull& hull, const RunControl& control = {});

/// Axes of the points' covariance, as columns; spread is least along the first.
Eigen::Matrix3d principalAxes(const std::vector<Eigen::Vector3d>& points);

/// The hull of `corners` if need be grown about their middle by what rounding takes, until its faces hold all of `held`;
/// nullopt where that needs more than rounding explains.
std::optional<ConvexHull> hullHolding(std::vector<Eigen::Vector3d> corners, const std::vector<Eigen::Vector3d>& held);

}  // namespace collision_hulls
