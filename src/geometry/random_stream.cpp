// Directions and rotations are drawn from a cube until they lie in the ball, which makes them uniform; near its middle they would be
// rounded too much.
#include "geometry/random_stream.h"

#include <cmath>

#include "base/random.h"

namespace collision_hulls {

Random::Random(std::uint64_t seed, std::uint64_t pair, std::uint64_t query) : state_(seed) {
  state_ = bits() ^ pair;
  state_ = bits() ^ query;
}

std::uint64_t Random::bits() {
  const std::uint64_t result = mixed(state_);
  state_ += kGoldenStep;
  return result;
}

std::size_t Random::below(std::size_t n) {
  return static_cast<std::size_t>(bits() % n);
}

double Random::uniform(double low, double high) {
  return low + (high - low) * unitInterval(bits());
}

double Random::logUniform(double low, double high) {
  return low * std::exp(uniform(0, std::log(high / low)));
}

Eigen::Vector3d Random::direction() {
  for (;;) {
    const Eigen::Vector3d v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};  // braces: evaluated in this order
    const double n = v.squaredNorm();
    if (n > 0.01 && n <= 1) return v.normalized();
  }
}

Eigen::Quaterniond Random::rotation() {
  for (;;) {
    const Eigen::Vector4d v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    const double n = v.squaredNorm();
    if (n > 0.01 && n <= 1) return Eigen::Quaterniond(Eigen::Vector4d(v.normalized()));
  }
}

}  // namespace collision_hulls
