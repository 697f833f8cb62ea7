// FCL's types behind QueryBody; for this room's files only.
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <memory>

#include "collision_hulls/query/query_body.h"

namespace collision_hulls {

// FCL's thresholds are absolute, so bodies are enlarged; by a power of two, so that nothing is rounded.
constexpr double kQueryEnlarged = 1024;
constexpr double kQueryDistanceTolerance = 1e-9;

struct QueryBody::Impl {
  std::shared_ptr<fcl::CollisionGeometryd> geometry;
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  // [m] the geometry's pose in the body's frame
};

}  // namespace collision_hulls
