// The surface of a mesh in parts, each of which one primitive is to cover.
#pragma once

#include <array>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/primitives/primitive.h"
#include "decompose/convex_polygon.h"

namespace collision_hulls {

/// A part of a mesh's surface, as convex polygons. Lengths in metres, in the mesh's frame.
class SurfacePatch {
 public:
  /// The part of the surface in `within`, and a billionth of the hull's size around it.
  SurfacePatch(const TriangleMesh& mesh, const ConvexHull& within);
  SurfacePatch() = default;  ///< an empty one

  bool empty() const { return polygons_.empty(); }

  /// Of the patch and what lies `depth` below it, on the inner side of its triangles. The patch must not be empty.
  ConvexHull hull(double depth) const;

  /// Drops the polygons that lie in the primitive.
  void dropWithin(const Primitive& primitive);

  /// Two parts that together are the patch: its largest flat part and the rest, if that part is of some size and keeps within `flatness` of
  /// a plane; otherwise the halves on both sides of a plane across its hull's box, those with the smallest boxes. One is empty where
  /// rounding leaves nothing to divide. `depth`: of the hull.
  std::array<SurfacePatch, 2> parts(double flatness, double depth) const;

 private:
  struct Polygon {
    ConvexPolygon points;
    Eigen::Vector3d normal;  ///< of the triangle; 0 for one without area
  };

  std::array<SurfacePatch, 2> flatPartAndRest(double flatness) const;
  std::array<SurfacePatch, 2> halves(const HalfSpace& plane) const;
  Eigen::AlignedBox3d boxIn(const Eigen::Isometry3d& frame, double depth) const;
  static double area(const Polygon& polygon);

  std::vector<Polygon> polygons_;
};

}  // namespace collision_hulls
