// Oriented boxes around hulls.
#pragma once

#include <optional>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// The smallest oriented box found around a hull, as a hull of 8 vertices that contains it. Candidates have one side flush with a face of
/// the hull or normal to one of the mesh's axes or of the vertices' principal axes; the other two sides form the smallest rectangle (exact,
/// by rotating calipers). The very smallest box need not have a side flush with a face, but is seldom much smaller. If there are very many
/// faces only the largest are tried. A thickened hull gives a thickened box. Throws kCancelled.
ConvexHull orientedBox(const ConvexHull& hull, const RunControl& control = {});

/// The principal axes of the points (of their covariance), as columns; the spread is least along the first.
Eigen::Matrix3d principalAxes(const std::vector<Eigen::Vector3d>& points);

/// The hull of `corners`, grown about their middle as far as rounding requires until its faces hold all of `held`; nullopt if it would have
/// to grow by more than rounding explains. Throws kCancelled.
std::optional<ConvexHull> hullHolding(std::vector<Eigen::Vector3d> corners, const std::vector<Eigen::Vector3d>& held,
                                      const RunControl& control = {});

}  // namespace collision_hulls
