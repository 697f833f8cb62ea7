// Polygons to triangles.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// The n - 2 triangles of a polygon with n >= 3 corners, as places in `corners`, in the polygon's direction. A fan from the first
/// corner where that corner sees all others: most programs divide so, and the corners of a polygon seldom lie in one plane, so
/// that another division would be another surface. Else ears are cut in the
/// plane of the polygon's mean normal; where none is left (it crosses itself, or has no area) the rest becomes a fan, so that
/// every corner is a corner of some triangle whatever the polygon is.
std::vector<Triangle> triangulate(const std::vector<Eigen::Vector3d>& corners);

}  // namespace collision_hulls
