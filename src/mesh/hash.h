// Where integers go in a hash table.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/random.h"

namespace collision_hulls {

/// One of `buckets`, a power of two, for the integers of a key.
template <typename Key>
std::size_t bucketOf(const Key& key, std::size_t buckets) {
  std::uint64_t hash = 0;
  for (const auto number : key) hash = (hash ^ static_cast<std::uint64_t>(number)) * kGoldenStep + (hash >> 29);
  return (hash ^ (hash >> 32)) & (buckets - 1);
}

}  // namespace collision_hulls
