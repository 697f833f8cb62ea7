// Indices are int, as in meshes; containers count in std::size_t.
#pragma once

#include <cstddef>

namespace collision_hulls {

/// An index (>= 0) as containers want it: `list[at(i)]`.
inline std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace collision_hulls
