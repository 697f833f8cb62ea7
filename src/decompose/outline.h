// Convex outlines in a plane, and prisms over them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Corners, counter-clockwise.
using Outline = std::vector<Eigen::Vector2d>;

/// The convex hull of some points.
Outline outlineOf(std::vector<Eigen::Vector2d> points);

/// An outline of at most `most` (at least four) corners that contains this one. Drops edges and extends their neighbours until they meet;
/// edges whose neighbours meet nearest go first.
Outline simplified(Outline outline, std::size_t most);

/// A prism of at most `max_vertices` (at least eight) corners around a hull, along the direction in which the hull's vertices spread least.
/// Up to rounding it contains the hull and touches it.
ConvexHull prismAbout(const ConvexHull& hull, int max_vertices);

}  // namespace collision_hulls
