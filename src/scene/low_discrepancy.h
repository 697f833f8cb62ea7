// A sequence of points that fills a cube evenly at any length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace collision_hulls {

/// Steps of Richtmyer's sequence, index * sqrt(prime) mod 1, with one prime per dimension. Steps are fractions of 2^64, so no index is too
/// large. (Halton's sequence, and powers of a single root as in Roberts' R-sequence, correlate in a robot's tens of dimensions.)
std::vector<std::uint64_t> richtmyerSteps(std::size_t dimensions);

/// A fraction of 2^64 as a number in [0, 1).
inline double toUnit(std::uint64_t fraction) {
  return static_cast<double>(fraction >> 11) * 0x1p-53;
}

/// Hashes a number (SplitMix64).
inline std::uint64_t mixed(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

}  // namespace collision_hulls
