// Spheres from which a cover is chosen: as large as the space allows.
#pragma once

#include <vector>

#include "collision_hulls/primitives/spheres.h"
#include "primitives/tolerable_space.h"

namespace collision_hulls {

/// A point of a surface, and the normal there; of a triangle without area, zero.
struct SurfacePoint {
  Eigen::Vector3d p, normal;
};

/// Spread evenly over the triangles: `count` of them, or one if the area is 0.
std::vector<SurfacePoint> spreadOver(const TriangleMesh& mesh, std::size_t count);

/// The nearest point whose coordinates are single-precision numbers.
Eigen::Vector3d inSinglePrecision(const Eigen::Vector3d& p);

/// The sphere about a point, rounded to single precision; of radius 0 if none is proved to lie in the space.
Sphere sphereAt(const Eigen::Vector3d& centre, const TolerableSpace& space);

/// The largest spheres in the space that touch its border next to a point of the surface, each on another side.
std::vector<Sphere> largestAt(const SurfacePoint& at, const TolerableSpace& space);

/// A sphere that contains `sphere` or nearly so, and cannot be enlarged without leaving where it touches the space's border.
Sphere enlarged(const Sphere& sphere, const TolerableSpace& space);

}  // namespace collision_hulls
