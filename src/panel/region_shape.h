// How a region looks in the view, and what dragging its handles makes of it. Knows neither ROS nor Qt. All in the link's frame.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <variant>
#include <vector>

#include "collision_hulls/report/options.h"

namespace collision_hulls {

using RegionShape = std::variant<RegionBox, RegionHalfSpace>;

/// What can be dragged: the region as a whole, which is moved and turned, or a face of a box, along its normal.
struct RegionHandle {
  int axis = -1;  ///< of the box's frame; -1: the whole region
  int side = 0;   ///< 1: the face that looks along the axis; -1: the opposite one

  std::string name() const;  ///< "whole", "+x", "-z"
};

/// Those that a shape has, the whole first.
std::vector<RegionHandle> handlesOf(const RegionShape& shape);

/// Where a handle is. A box's axes are the pose's. The x axis is a half-space's normal, and the origin the point of its plane that is
/// nearest to the middle of `around`, the box around the link's bodies, or else to the link's origin.
Eigen::Isometry3d poseOf(const RegionShape& shape, const RegionHandle& handle, const Eigen::AlignedBox3d& around);

/// The shape after the handle was dragged to `pose`. Of a box whose face was dragged, the opposite face stays; no side gets shorter than
/// 1 mm. Lengths are rounded to 0.1 mm and angles to 1e-4 rad, as nobody drags more exactly.
RegionShape dragged(const RegionShape& shape, const RegionHandle& handle, const Eigen::Isometry3d& pose);

/// [m] The edge of what is drawn: the longest of a box, or of the piece of a plane that is drawn for a half-space.
double drawnSize(const RegionShape& shape, const Eigen::AlignedBox3d& around);

/// A first region, for the user to move: a box half as high as the link's bodies that stands on them, or what is below them. Neither meets
/// them, so nothing has to be divided until the user moves it. 10 cm about the origin where there are none.
RegionBox firstBox(const Eigen::AlignedBox3d& around);
RegionHalfSpace firstHalfSpace(const Eigen::AlignedBox3d& around);

}  // namespace collision_hulls
