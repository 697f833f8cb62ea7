// Few spheres in a space that cover a surface.
#pragma once

#include <optional>
#include <vector>

#include "collision_hulls/primitives/spheres.h"
#include "primitives/set_cover.h"
#include "primitives/sphere_candidates.h"
#include "primitives/tolerable_space.h"

namespace collision_hulls {

struct ChoiceLimits {
  std::size_t max_spheres = 0;
  std::size_t work = 0;    ///< of the search for fewer; one unit is a look at a point
  std::size_t enough = 1;  ///< the search ends at so many spheres
};

/// The spheres, which lie in the space and are proved to cover the mesh; nullopt if no cover within the limit was found. The search starts
/// from covers of up to twice the limit. Deterministic. Reports progress only once a cover is within the limit.
std::optional<std::vector<Sphere>> fewSpheres(const TriangleMesh& mesh, const TolerableSpace& space, const ChoiceLimits& limits,
                                              const RunControl& control);

}  // namespace collision_hulls
