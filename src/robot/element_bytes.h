// Elements as bytes, for answers about descriptions and for the cache.
#pragma once

#include "collision_hulls/robot/robot_description.h"
#include "geometry/bytes.h"

namespace collision_hulls {

template <typename Archive>
void fields(Archive& archive, Eigen::Isometry3d& pose) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) archive(pose.matrix()(row, column));
}

/// A new member does not compile until it is listed here, too.
template <typename Archive>
void fields(Archive& archive, GeometryElement& element) {
  auto& [kind, uri, scale, size, origin, name, fault] = element;
  archive(kind, uri, scale, size, origin, name, fault);
}

}  // namespace collision_hulls
