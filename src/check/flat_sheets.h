// Flat parts of sheets: what lies over one of them is no further from it than its height.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "collision_hulls/geometry/triangle_bvh.h"
#include "collision_hulls/mesh/repair.h"
#include "mesh/edges.h"

namespace collision_hulls {

/// The triangles that may be sheets, in groups that edges connect and that lie in one plane. Immutable, thread safe.
class FlatSheets {
 public:
  /// `two_sided`: per triangle, whether both of its sides may face the outside.
  FlatSheets(const RepairedMesh& mesh, const Edges& edges, const std::vector<char>& two_sided);

  /// [m] A bound of the distance from any point of a patch to the surface, by its height above one group; infinite where it reaches further
  /// than `slack` [m] beyond that. `near`: the point of the surface nearest to a point of the patch. The bound is larger by the slack.
  double bound(const std::array<Eigen::Vector3d, 3>& patch, const TriangleBvh::Nearest& near, double slack) const;

 private:
  /// A plane, and how far the group's vertices are from it.
  struct Group {
    Eigen::Vector3d normal, through;
    double deviation = 0;
    std::vector<int> triangles;
  };
  Group grownFrom(int seed, const RepairedMesh& mesh, const Edges& edges, const std::vector<char>& two_sided);
  bool isCovered(const std::array<Eigen::Vector3d, 3>& triangle, const Eigen::Vector3d& point, const Group& group) const;
  TriangleBvh rims(const RepairedMesh& mesh, const Edges& edges) const;

  double flat_ = 0;            // [m] deviation that is allowed
  std::vector<int> group_;     // per triangle of the mesh; -1: none
  std::vector<Group> groups_;  // large ones
  TriangleBvh rim_;            // their edges that lead to no triangle of the same group
};

}  // namespace collision_hulls
