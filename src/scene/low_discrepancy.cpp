// Primes by trial division: a robot has tens of joints.
#include "scene/low_discrepancy.h"

#include <algorithm>
#include <cmath>

namespace collision_hulls {

std::vector<std::uint64_t> richtmyerSteps(std::size_t dimensions) {
  std::vector<std::uint64_t> primes, steps;
  for (std::uint64_t n = 2; steps.size() < dimensions; ++n) {
    if (std::any_of(primes.begin(), primes.end(), [&](std::uint64_t p) { return n % p == 0; })) continue;
    primes.push_back(n);
    const double root = std::sqrt(static_cast<double>(n));  // correctly rounded, the same everywhere
    steps.push_back(static_cast<std::uint64_t>((root - std::floor(root)) * 0x1p64));
  }
  return steps;
}

}  // namespace collision_hulls
