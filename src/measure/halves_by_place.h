// Hulls in two halves that lie side by side, for searches that run in parallel and know most about
// their own surroundings.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// No more hulls than this are searched one by one: each gains from what the earlier ones found.
constexpr std::size_t kTogether = 16;

/// Some of the hulls, by their indices, in two halves on either side of a plane across the longest
/// side of the box of their centres.
std::pair<std::vector<std::size_t>, std::vector<std::size_t>> halvesByPlace(const std::vector<ConvexHull>& hulls,
                                                                            const std::vector<std::size_t>& some);

}  // namespace collision_hulls
