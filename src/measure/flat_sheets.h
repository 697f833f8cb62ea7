// Flat parts of sheets: a point over such a part is no further from it than its height.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "base/looks.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "collision_hulls/mesh/repair.h"
#include "mesh/edges.h"

namespace collision_hulls {

/// The triangles that may be sheets, in edge-connected groups that each lie in one plane. Immutable, thread safe.
class FlatSheets {
 public:
  /// `two_sided`: per triangle, whether either side may face the outside.
  FlatSheets(const RepairedMesh& mesh, const Edges& edges, const std::vector<char>& two_sided, const RunControl& control);

  /// [m] An upper bound on the distance of a patch's points from the surface: the patch's height above one group, plus `slack` [m];
  /// infinite if the patch sticks out sideways by more than the slack (lemma 8 of doc/certified.md). `near`: the point of the surface
  /// nearest to a point of the patch.
  double bound(const std::array<Eigen::Vector3d, 3>& patch, const TriangleBvh::Nearest& near, double slack) const;

 private:
  /// A plane, and how far the group's vertices are from it.
  struct Group {
    Eigen::Vector3d normal, through;
    double deviation = 0;
    std::vector<int> triangles;
  };
  Group grownFrom(int seed, const RepairedMesh& mesh, const Edges& edges, const std::vector<char>& two_sided, Looks& look);
  bool isCovered(const std::array<Eigen::Vector3d, 3>& triangle, const Eigen::Vector3d& point, const Group& group) const;
  TriangleBvh rims(const RepairedMesh& mesh, const Edges& edges, const RunControl& control) const;

  double flat_ = 0;            // [m] allowed deviation
  double margin_ = 0;          // [m] about the rim
  std::vector<int> group_;     // per triangle of the mesh; -1: none
  std::vector<Group> groups_;  // only large ones
  TriangleBvh rim_;            // the groups' edges that lead to no triangle of the same group
};

}  // namespace collision_hulls
