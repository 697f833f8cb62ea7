// Closes a surface along its rim, so that inside and outside can be told apart.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "measure/rim.h"

namespace collision_hulls {

/// Triangles that close the surface: with all of them, every edge is used equally often in both directions. A loop of the rim that is no
/// wider than the weld tolerance is a crack, as where one triangle's long side meets two short ones: its lids lie within it and count as
/// surface wherever inside and outside are told apart. Other loops are openings.
struct Lids {
  std::vector<Eigen::Vector3d> vertices;  // those of the surface, and apexes; none: there is no rim
  std::vector<Triangle> of_cracks, of_openings;
  Rim rim_of_openings;
  double crack_width = 0;  // [m] of the widest crack
};

/// `rim`: that of the mesh. Cracks: lemma 7 of doc/certified.md.
Lids lidsOf(const TriangleMesh& mesh, const Rim& rim, const RunControl& control);

}  // namespace collision_hulls
