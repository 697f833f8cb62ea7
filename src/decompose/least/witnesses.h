// Points of a surface to prove by that it needs many hulls.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

using Points = std::vector<Eigen::Vector3d>;

/// Points of a mesh's triangles.
struct SurfacePoints {
  Points all;
  std::size_t vertices = 0;  ///< how many of them are vertices, as tips and corners are; these come first
};

/// Up to `count` vertices, and about as many points spread over the triangles by area.
SurfacePoints surfacePoints(const TriangleMesh& mesh, std::size_t count);

/// For each of several hulls the point that is furthest from all others, unless all its points are in others, too.
Points ownPoints(const Points& points, const std::vector<ConvexHull>& hulls);

/// At most so many of some points, each as far as possible from those before it.
Points spreadOf(const Points& points, std::size_t most);

/// Adds up to `count` points, each as far as possible from those before it: by turns a vertex and any of them.
void addSpread(const SurfacePoints& points, std::size_t count, Points& chosen);

}  // namespace collision_hulls
