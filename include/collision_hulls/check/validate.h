// Proof by query: collision and distance queries through FCL, original against hulls. The only room that sees FCL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

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
};

struct ValidationOptions {
  int queries_per_pair = 200;  ///< seeded probes around each element
  std::uint64_t seed = 1;
};

/// Field names and meanings: the report's "validation" object.
struct Validation {
  std::size_t queries = 0;
  std::size_t missed = 0;        ///< original hit, hulls not: must be 0
  std::size_t phantom = 0;       ///< hulls hit though the original is further than the certified protrusion: must be 0
  double max_underestimate = 0;  ///< [m] largest (distance to original - distance to hulls); the protrusion bounds it
  std::size_t exceptions = 0;    ///< thrown by FCL, answered by our own computation instead
  std::size_t timeouts = 0;
  std::size_t nan = 0;
  std::size_t disagreements = 0;     ///< FCL and our own computation differ by more than FCL's tolerance; ours counted
  double mesh_query_us = 0;          ///< [us] median time of a distance query to the original (BVH)
  double hull_query_us = 0;          ///< [us] the same to its hulls
  std::vector<std::string> remarks;  ///< one line for each missed, phantom, exception or disagreement, at most 20
};

/// Distance queries of probes (spheres, boxes, and the other elements' hulls) at seeded poses around each element, and
/// point-in-solid samples. Deterministic but for the times. Throws kCancelled.
Validation validate(const std::vector<ValidationPair>& pairs, const ValidationOptions& options, const RunControl& control = {});

}  // namespace collision_hulls
