// What tolerance a mesh's coordinates, which have single precision, can bear.
#pragma once

#include <string>

#include "base/millimetres.h"
#include "base/positive_length.h"
#include "collision_hulls/error.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

constexpr double kFinestTolerance = 1e-6;  // of the diagonal

/// Throws kBadOption for a tolerance that is finer, for which the work would never end. `mesh`: its name; both lengths in metres; `of`:
/// whose tolerance it is, as in " of region 'gap'", if not the mesh's.
inline void expectResolvable(double tolerance, double diagonal, const std::string& mesh, const std::string& of = "") {
  if (!(tolerance < kFinestTolerance * diagonal)) return;  // a diagonal that is not finite is for others to refuse
  throw Error(ErrorCode::kBadOption, "the tolerance" + of + " of " + millimetres(tolerance) + " is less than a millionth of " +
                                         (mesh.empty() ? "the mesh" : "'" + mesh + "'") + ", which is " + millimetres(diagonal) +
                                         " across, and finer than its coordinates: a number without a unit is in metres; give " +
                                         millimetres(kFinestTolerance * diagonal) + " or more");
}

/// The same for a tolerance from anywhere, also one that is not a positive length. `name`: what the message calls it.
inline void expectUsable(double tolerance, const TriangleMesh& mesh, const std::string& name = "tolerance") {
  expectPositiveLength(name, tolerance);
  expectResolvable(tolerance, diagonal(mesh), "");
}

}  // namespace collision_hulls
