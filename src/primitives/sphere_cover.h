// Whether spheres cover a surface, with proof.
#pragma once

#include <vector>

#include "collision_hulls/primitives/spheres.h"

namespace collision_hulls {

struct CoverSearch {
  /// [m] > 0: a point counts as uncovered if no sphere holds it this deep. The larger, the sooner the search ends.
  double depth = 0;
  /// [m] pieces longer than this are divided even if a point in them is uncovered, so that more such points are found.
  double grain = 0;
};

/// Points of the surface that are in no sphere, or not deep in one: some 20,000 of them at most. If there are none, the spheres are proved
/// to cover all of the surface.
std::vector<Eigen::Vector3d> gapsIn(const TriangleMesh& mesh, const std::vector<Sphere>& spheres, const CoverSearch& search,
                                    const RunControl& control);

}  // namespace collision_hulls
