// Random numbers, directions and rotations in streams: each query has one of its own, so that any can be repeated alone.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>

namespace collision_hulls {

/// The same on every platform (SplitMix64, Steele et al. 2014).
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t pair, std::uint64_t query);
  std::uint64_t bits();
  std::size_t below(std::size_t n);  ///< 0 .. n - 1; n > 0
  double uniform(double low, double high);
  double logUniform(double low, double high);  ///< 0 < low < high
  Eigen::Vector3d direction();                 ///< of unit length
  Eigen::Quaterniond rotation();

 private:
  std::uint64_t state_;
};

}  // namespace collision_hulls
