// Colours for the nodes of a graph.
#pragma once

#include <cstddef>
#include <vector>

#include "decompose/least/clique.h"

namespace collision_hulls {

/// Whether it is proved that so many colours do not suffice for the graph if neighbours must differ. `clique`: gets different colours from
/// the start. The search ends without a proof after `most_steps`.
bool needsMoreColours(const Graph& graph, const std::vector<std::size_t>& clique, std::size_t colours, long most_steps);

}  // namespace collision_hulls
