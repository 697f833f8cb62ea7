// The rotation is yaw * pitch * roll. Near gimbal lock the entries that yaw is read from are rounding alone, so roll is read after yaw is
// undone: then both agree on the rotation, whatever yaw was found.
#include "geometry/roll_pitch_yaw.h"

#include <cmath>

namespace collision_hulls {

Eigen::Quaterniond fromRollPitchYaw(const Eigen::Vector3d& rpy) {
  return Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX());
}

Eigen::Vector3d rollPitchYaw(const Eigen::Matrix3d& r) {
  const double yaw = std::atan2(r(1, 0), r(0, 0));
  const double s = std::sin(yaw), c = std::cos(yaw);
  const double pitch = std::atan2(-r(2, 0), c * r(0, 0) + s * r(1, 0));
  const double roll = std::atan2(s * r(0, 2) - c * r(1, 2), c * r(1, 1) - s * r(0, 1));
  return {roll, pitch, yaw};
}

}  // namespace collision_hulls
