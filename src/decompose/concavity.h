// The concavity of a surface, C(S), equation (6) of Mamou & Ghorbel 2009: how far the hull's surface lies from S along normals.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// The largest ||M - P(M)|| over the points M of a triangle within `hull`, where the half-ray from M along `normal` (the
/// triangle's unit normal) leaves the hull at P(M) [m].
///
/// The exit distance is the least of one affine function of M per face that looks along the normal: concave and piecewise
/// linear over the triangle, with its maximum generally not at a corner. Found exactly, up to rounding, by cutting planes:
///
///   M <- centroid
///   repeat
///     f <- the face where the ray from M leaves                      its distance there is a lower bound
///     M <- maximum of f's function over the part of the triangle     its value there is an upper bound
///          where f is below the faces found before
///   until the bounds meet, or the upper one is at most `known`
///
/// Returns the lower bound, so any value up to `known` means "at most known". 0 where the hull has no face along the normal.
double concavityOfTriangle(const ConvexHull& hull, const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& normal,
                           double known = 0);

/// A cluster of triangles, as far as its concavity needs to know it.
struct Patch {
  std::vector<int> triangles;
  std::vector<double> heights;  ///< per triangle, upper bound [m] of how far the patch's hull rises above its plane
  std::vector<int> points;      ///< every extreme point of the patch's hull is among them; sorted; see ConcavityMeasure
  std::size_t reduced = 0;      ///< size of `points` when interior ones were last left out
  Eigen::AlignedBox3d box;
  double concavity = 0;  ///< C(S) [m]
};

/// Measures C of unions of patches. With exact hulls C is monotone: a union's hull holds its parts' hulls, so each ray leaves
/// it later, and there are more rays. Hence what a part's C, or an upper bound of a triangle's exit distance, says already
/// need not be computed again. A distance of up to kNegligible of the mesh's diagonal counts as none: the coordinates of
/// mesh files are no finer.
class ConcavityMeasure {
 public:
  explicit ConcavityMeasure(const TriangleMesh& mesh);

  Patch patch(int triangle) const;

  /// C(S) of a union, and `points` for a patch of it (empty if `value` passed the limit).
  struct Union {
    double value = 0;
    std::vector<int> points;
  };
  /// `known`: a lower bound of the union's C, [m]. A value above `limit` is a lower bound only: there the search stops.
  Union ofUnion(const Patch& a, const Patch& b, double known, double limit) const;

  /// a with b and b's triangles; `measured` as ofUnion(a, b) returned it.
  Patch unite(Patch a, const Patch& b, Union measured) const;

  /// Where the triangles' vertices lie, by the indices in Patch::points.
  std::vector<Eigen::Vector3d> positions(const std::vector<int>& points) const;

  static constexpr double kNegligible = 1e-6;

 private:
  struct Facet {
    std::array<int, 3> points;
    Eigen::Vector3d normal;
    double offset;
  };
  struct Candidate {
    double height;
    int triangle;
  };
  void raise(std::vector<double>& heights, const std::vector<int>& triangles, const Patch& other, double floor) const;
  std::vector<Candidate> candidates(const Patch& a, const Patch& b, double floor) const;
  std::vector<int> extreme(const std::vector<int>& points, const ConvexHull& hull) const;

  // Points are the mesh's vertices sorted along one direction that no mesh is aligned with, so that a hull's vertex is found
  // among them by bisection.
  std::vector<Eigen::Vector3d> position_;
  std::vector<double> key_;
  std::vector<Facet> facets_;
  double diagonal_ = 0, negligible_ = 0;  // [m]
};

}  // namespace collision_hulls
