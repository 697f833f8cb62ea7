// Random numbers that are the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace collision_hulls {

/// By how much the state of SplitMix64 grows from one number to the next: 2^64 over the golden ratio.
constexpr std::uint64_t kGoldenStep = 0x9e3779b97f4a7c15u;

/// SplitMix64 (Steele, Lea & Flood 2014): a bijection that mixes all bits.
inline std::uint64_t mixed(std::uint64_t x) {
  x += kGoldenStep;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Maps 64 random bits, or a fraction of 2^64, to a number in [0, 1).
inline double unitInterval(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(mixed(seed)) {}
  std::uint64_t bits() { return state_ = mixed(state_); }
  double unit() { return unitInterval(bits()); }  ///< in [0, 1)
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(unit() * static_cast<double>(n)); }

 private:
  std::uint64_t state_;
};

}  // namespace collision_hulls
