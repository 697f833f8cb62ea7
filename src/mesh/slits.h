// Openings that are narrow, however long: the slits between two rims that run along each other.
#pragma once

#include <vector>

#include "collision_hulls/control.h"
#include "mesh/boundary.h"

namespace collision_hulls {

/// Per surface: whether it would be almost closed if rims that run along each other were welded. The surfaces that such slits join count
/// as one: their openings are below kSmallOpening of their area. None is where there are over a thousand rims. `boundary`: of oriented
/// surfaces; `area`: per surface [m^2].
std::vector<char> closedButForSlits(const std::vector<Eigen::Vector3d>& vertices, std::vector<BoundaryEdge> boundary,
                                    const std::vector<double>& area, const RunControl& control);

}  // namespace collision_hulls
