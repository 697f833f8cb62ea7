// Evidence by queries: compares the original with its hulls through FCL's collision and distance
// queries.
//
// For example:
//
//     const Validation seen = validate({{"cup", mesh, hulls, bound}}, {});
//     if (seen.missed + seen.phantom > 0) std::cerr << seen.remarks.front() << '\n';
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/measure/solid.h"
#include "collision_hulls/primitives/spheres.h"

namespace collision_hulls {

/// A mesh element of a link, before and after. Coordinates are in the frame of the robot in its
/// zero configuration or, for a single mesh, in the mesh's own frame.
struct ValidationPair {
  std::string name;               ///< link and element, for messages
  TriangleMesh original;          ///< as read and scaled, not repaired
  std::vector<ConvexHull> hulls;  ///< as written
  double protrusion = 0;          ///< [m] certified
  /// The solid that the original represents, in its own frame, placed by `solid_pose`; null: it is
  /// made from the original.
  std::shared_ptr<const Solid> solid = nullptr;
  Eigen::Isometry3d solid_pose = Eigen::Isometry3d::Identity();
  /// As written, in place of the last hulls, which are polyhedra about them.
  std::vector<Sphere> spheres = {};
};

struct ValidationOptions {
  int queries_per_pair = 200;  ///< seeded probes around each element; 0 or more
  std::uint64_t seed = 1;
};

/// Field names and meanings as in the report's "validation" object. Verdicts allow for 1e-6 of the
/// element's extent, the accuracy of FCL's answers; `phantom` also allows for the distance that
/// welding moved vertices when the solid was made from the original. A probe wholly inside the
/// solid counts as hitting the original; a probe in a void between the hulls, inside the solid, is
/// not a miss.
struct Validation {
  std::size_t queries = 0;
  std::size_t missed = 0;  ///< original hit, hulls not: must be 0
  /// hulls hit although the original is further than the certified protrusion: must be 0
  std::size_t phantom = 0;
  /// [m] largest (distance to original - distance to hulls); bounded by the protrusion
  double max_underestimate = 0;
  /// exceptions thrown by FCL; our own computation answered instead
  std::size_t exceptions = 0;
  std::size_t timeouts = 0;  ///< queries that took FCL longer than a second
  /// FCL answered NaN, or the pair could not be checked because it holds non-finite numbers
  std::size_t nan = 0;
  /// FCL's distance and ours differ by more than FCL's tolerance; ours was used
  std::size_t disagreements = 0;
  double mesh_query_us = 0;  ///< [us] median time of a distance query to the original (BVH)
  double hull_query_us = 0;  ///< [us] the same to the element's hulls
  /// One line for each miss, false collision, exception, disagreement, underestimate beyond the
  /// protrusion, and pair that was not checked; at most 20.
  std::vector<std::string> remarks;

  /// Whether the queries found nothing that the proof rules out.
  bool holds() const { return missed + phantom == 0; }
};

/// Distance queries with probes (spheres, boxes, and other elements' hulls) at seeded poses around
/// each element, and point-in-solid samples. Pairs, and the queries of a pair, run in parallel.
/// Deterministic except for times and timeouts. A pair with a fault, such as a number that is not
/// finite, is not checked and counts as `nan`. Throws kBadOption for a negative number of queries,
/// kIndexOutOfRange for a triangle that names a vertex that is not there, kCancelled.
Validation validate(std::vector<ValidationPair> pairs, const ValidationOptions& options,
                    const RunControl& control = {});

}  // namespace collision_hulls
