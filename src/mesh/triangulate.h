// Triangulates polygons.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// The n - 2 triangles of a polygon with n >= 3 corners, as indices into `corners`, in the polygon's direction. A fan from the first corner
/// if that corner sees all others: most programs triangulate in this way, and since corners are seldom exactly coplanar, another
/// triangulation would be another surface. Otherwise ears are cut off in the plane of the polygon's mean normal; if there are none left
/// (the polygon crosses itself or has no area) the rest becomes a fan. Every corner is thus a corner of some triangle, whatever the polygon
/// looks like. Throws kCancelled.
std::vector<Triangle> triangulate(const std::vector<Eigen::Vector3d>& corners, const RunControl& control = {});

/// What other programs take a polygon for, of which triangulate() made `cut`: the triangles of the fan from the first corner that `cut`
/// lacks. None if the polygon is flat and does not cross itself (the normals of `cut` agree): its surface is then beyond doubt.
std::vector<Triangle> otherReading(const std::vector<Eigen::Vector3d>& corners, const std::vector<Triangle>& cut);

}  // namespace collision_hulls
