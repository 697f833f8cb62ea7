// A triangle's key is a hash of its corners' coordinates in ascending order of their own hashes, 64 bits wide: among a million triangles
// two share a key by accident once in some ten million runs, and such an accident cannot outlive the certificate.
#include "decompose/certified/known_facets.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "base/random.h"

namespace collision_hulls {

namespace {

constexpr std::size_t kMostRemembered = 1'000'000;  // triangles remembered; then all are forgotten

std::uint64_t keyOf(const Eigen::Vector3d& p) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double value = p[axis] == 0 ? 0 : p[axis];  // -0 is 0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    key = mixed(key ^ bits);
  }
  return key;
}

std::vector<std::uint64_t> keysOf(const ConvexHull& hull) {
  std::vector<std::uint64_t> corners, result;
  for (const Eigen::Vector3d& v : hull.vertices) corners.push_back(keyOf(v));
  for (const Triangle& t : hull.triangles) {
    std::array<std::uint64_t, 3> key{};
    for (std::size_t k = 0; k < 3; ++k) key[k] = corners[static_cast<std::size_t>(t[k])];
    std::sort(key.begin(), key.end());
    result.push_back(mixed(mixed(mixed(key[0]) ^ key[1]) ^ key[2]));
  }
  return result;
}

}  // namespace

std::vector<char> KnownFacets::within(double distance, const ConvexHull& hull) const {
  std::vector<char> result;
  for (const std::uint64_t key : keysOf(hull)) {
    const auto known = bounds_.find(key);
    result.push_back(known != bounds_.end() && known->second <= distance);
  }
  return result;
}

std::size_t KnownFacets::unknown(double distance, const ConvexHull& hull) const {
  const std::vector<char> known = within(distance, hull);
  return static_cast<std::size_t>(std::count(known.begin(), known.end(), 0));
}

void KnownFacets::learn(std::uint64_t key, double bound) {
  const auto [known, is_new] = bounds_.emplace(key, bound);
  if (!is_new) known->second = std::min(known->second, bound);
}

void KnownFacets::learn(const ConvexHull& hull, double bound) {
  if (bounds_.size() > kMostRemembered) bounds_.clear();
  for (const std::uint64_t key : keysOf(hull)) learn(key, bound);
}

void KnownFacets::learn(const KnownFacets& other) {
  for (const auto& [key, bound] : other.bounds_) learn(key, bound);
}

}  // namespace collision_hulls
