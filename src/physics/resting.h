// The poses in which a rigid body can stand on a table.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Of a body of 1 kg with uniform density.
struct MassProperties {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   ///< [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< [kg m^2] about the centre
};
MassProperties massProperties(const ConvexHull& hull);

/// A face of the hull on which the body can stand: the centre of mass is above the face.
struct RestingPose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< turns the face down
  double stability = 0;                                    ///< [rad] how far it can be tilted before it tips over
};

/// At most `most` poses, the most stable first, no two of them with nearly parallel faces; empty if the body can stand on no face.
std::vector<RestingPose> restingPoses(const ConvexHull& hull, const Eigen::Vector3d& center, std::size_t most);

}  // namespace collision_hulls
