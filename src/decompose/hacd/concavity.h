// The concavity C(S) of a surface, equation (6) of Mamou & Ghorbel 2009: how far the hull's surface
// lies from S along S's normals.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// A cluster of triangles, reduced to what its concavity depends on.
struct Patch {
  std::vector<int> triangles;
  std::vector<double> heights;  ///< per triangle, an upper bound [m] on how far the patch's hull
                                ///< rises above its plane
  std::vector<int> points;      ///< include every extreme point of the patch's hull; sorted; see ConcavityMeasure
  std::size_t reduced = 0;      ///< size of `points` when interior ones were last removed
  Eigen::AlignedBox3d box;
  double concavity = 0;  ///< C(S) [m]
};

/// Measures C of unions of patches. With exact hulls C is monotone: a union's hull contains its
/// parts' hulls, so each ray leaves it later, and there are more rays. What a part's C, or an upper
/// bound on a triangle's exit distance, already implies is therefore not computed again. Distances
/// up to kNegligible of the mesh's diagonal count as zero: coordinates in mesh files are no finer.
class ConcavityMeasure {
 public:
  explicit ConcavityMeasure(const TriangleMesh& mesh);

  Patch patch(int triangle) const;

  /// C(S) of a union, and `points` for its patch (empty if `value` exceeds the limit).
  struct Union {
    double value = 0;
    std::vector<int> points;
  };
  /// `known`: a lower bound [m] on the union's C. The search stops as soon as the value exceeds
  /// `limit`, so such a value is only a lower bound.
  Union ofUnion(const Patch& a, const Patch& b, double known, double limit) const;

  /// The union of a and b; `measured` is the result of ofUnion(a, b).
  Patch unite(Patch a, const Patch& b, Union measured) const;

  /// The positions of points, by their indices in Patch::points.
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

  // Points are the mesh's vertices, sorted along a direction that no mesh is aligned with;
  // bisection then finds a hull's vertex among them.
  std::vector<Eigen::Vector3d> position_;
  std::vector<double> key_;
  std::vector<Facet> facets_;
  double diagonal_ = 0, negligible_ = 0;  // [m]
};

}  // namespace collision_hulls
