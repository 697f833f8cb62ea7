// Proof by query: collision and distance queries through FCL, original against hulls. The only room that sees FCL.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "collision_hulls/check/solid.h"
#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// A mesh element of a link, before and after; coordinates in the frame of the robot in its zero configuration or, for a
/// single mesh, in the mesh's own.
struct ValidationPair {
  std::string name;               ///< link and element, for messages
  TriangleMesh original;          ///< as read and scaled, not repaired
  std::vector<ConvexHull> hulls;  ///< as written
  double protrusion = 0;          ///< [m] certified
  /// What the original stands for, in a frame of its own that `solid_pose` places; null: it is made from the original.
  std::shared_ptr<const Solid> solid = nullptr;
  Eigen::Isometry3d solid_pose = Eigen::Isometry3d::Identity();
};

struct ValidationOptions {
  int queries_per_pair = 200;  ///< seeded probes around each element
  std::uint64_t seed = 1;
};

/// Field names and meanings: the report's "validation" object. Verdicts allow for 1e-6 of the element's extent, which is what FCL's
/// answers are good for, and `phantom` for the distance that welding moved vertices when the solid was made from the original.
/// A probe wholly inside the solid counts as hitting the original; one in a hole of the hulls within the solid as no miss.
struct Validation {
  std::size_t queries = 0;
  std::size_t missed = 0;         ///< original hit, hulls not: must be 0
  std::size_t phantom = 0;        ///< hulls hit though the original is further than the certified protrusion: must be 0
  double max_underestimate = 0;   ///< [m] largest (distance to original - distance to hulls); the protrusion bounds it
  std::size_t exceptions = 0;     ///< thrown by FCL, answered by our own computation instead
  std::size_t timeouts = 0;       ///< queries that took FCL longer than a second
  std::size_t nan = 0;            ///< FCL answered NaN, or the pair holds numbers that are not finite and could not be checked
  std::size_t disagreements = 0;  ///< FCL and our own computation differ by more than FCL's tolerance; ours counted
  double mesh_query_us = 0;       ///< [us] median time of a distance query to the original (BVH)
  double hull_query_us = 0;       ///< [us] the same to its hulls
  /// One line for each missed, phantom, exception, disagreement, underestimate beyond the protrusion, and pair that was not
  /// checked; the first 20.
  std::vector<std::string> remarks;
};

/// Distance queries of probes (spheres, boxes, and the other elements' hulls) at seeded poses around each element, and
/// point-in-solid samples. Pairs, and the queries of a pair, run in parallel. Deterministic but for the times and timeouts. Throws
/// kCancelled (seen between queries; building FCL's tree, half a second for a million triangles, is not interrupted), kBadOption,
/// kIndexOutOfRange.
Validation validate(const std::vector<ValidationPair>& pairs, const ValidationOptions& options, const RunControl& control = {});

}  // namespace collision_hulls
