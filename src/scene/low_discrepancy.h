// A sequence of points that fills a cube evenly at any length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace collision_hulls {

/// Steps of Richtmyer's sequence, index * sqrt(prime) mod 1, with one prime per dimension. Steps are fractions of 2^64, so no index is too
/// large. (Halton's sequence, and powers of a single root as in Roberts' R-sequence, correlate in a robot's tens of dimensions.)
std::vector<std::uint64_t> richtmyerSteps(std::size_t dimensions);

}  // namespace collision_hulls
