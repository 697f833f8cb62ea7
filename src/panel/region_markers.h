// Regions as interactive markers: what the view shows of them, with handles for those that are chosen.
#pragma once

#include <visualization_msgs/InteractiveMarker.h>

#include <string>

#include "panel/region_shape.h"

namespace collision_hulls {

/// A region of one link, in whose frame it is.
struct ShownRegion {
  std::string region, link;  ///< names
  RegionShape shape;
  Eigen::AlignedBox3d around;  ///< the link's bodies; empty: unknown
  bool has_handles = false;
};

/// The marker of one handle; that of the whole region draws it, too. Its name is unique among regions with other names or links.
visualization_msgs::InteractiveMarker toMarker(const ShownRegion& shown, const RegionHandle& handle);

Eigen::Isometry3d toPose(const geometry_msgs::Pose& pose);

}  // namespace collision_hulls
