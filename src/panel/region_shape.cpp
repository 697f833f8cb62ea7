// A face that is dragged moves the box's middle by half as much. Its new place is told by the handle's, and not by how far it was dragged
// since, so that a move that is lost or comes twice does no harm.
#include "panel/region_shape.h"

#include <algorithm>
#include <cmath>

#include "geometry/roll_pitch_yaw.h"
#include "robot/number_text.h"

namespace collision_hulls {
namespace {

constexpr double kLeastSide = 0.001;                // [m]
constexpr double kRound = 1e-4, kFineRound = 1e-6;  // [m], [rad]
constexpr double kPlane = 1.2;                      // of a link's diagonal: the piece of a plane that is drawn
constexpr double kFirst = 0.1;                      // [m]

Eigen::Vector3d rounded(const Eigen::Vector3d& v, double unit) {
  return (v / unit).array().round() * unit + 0.0;  // no negative zero
}

Eigen::Isometry3d frameOf(const RegionBox& box) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = fromRollPitchYaw(box.rpy).toRotationMatrix();
  frame.translation() = box.center;
  return frame;
}

RegionBox draggedWhole(RegionBox box, const Eigen::Isometry3d& pose) {
  const Eigen::Isometry3d before = frameOf(box);
  box.center = rounded(pose.translation(), kRound);
  if (!pose.linear().isApprox(before.linear(), kRound)) box.rpy = rounded(rollPitchYaw(pose.linear()), kRound);
  return box;
}

RegionBox draggedFace(RegionBox box, const RegionHandle& handle, const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d outward = handle.side * frameOf(box).linear().col(handle.axis);
  double& size = box.size[handle.axis];
  const double opposite = outward.dot(box.center) - size / 2;
  const double longer = std::max(kLeastSide, std::round((outward.dot(pose.translation()) - opposite) / kRound) * kRound) - size;
  size = std::round((size + longer) / kFineRound) * kFineRound;
  box.center = rounded(box.center + longer / 2 * outward, kFineRound);
  return box;
}

RegionHalfSpace draggedPlane(RegionHalfSpace half_space, const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d normal = pose.linear().col(0);
  if (!normal.isApprox(half_space.normal.normalized(), kRound)) half_space.normal = rounded(normal, kRound);
  half_space.offset = std::round(half_space.normal.dot(pose.translation()) / kRound) * kRound + 0.0;
  return half_space;
}

}  // namespace

std::string RegionHandle::name() const {
  return axis < 0 ? "whole" : std::string(side > 0 ? "+" : "-") + "xyz"[axis];
}

std::vector<RegionHandle> handlesOf(const RegionShape& shape) {
  std::vector<RegionHandle> handles{{}};
  if (!std::holds_alternative<RegionBox>(shape)) return handles;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {1, -1}) handles.push_back({axis, side});
  return handles;
}

Eigen::Isometry3d poseOf(const RegionShape& shape, const RegionHandle& handle, const Eigen::AlignedBox3d& around) {
  if (const auto* const box = std::get_if<RegionBox>(&shape)) {
    Eigen::Isometry3d pose = frameOf(*box);
    if (handle.axis >= 0) pose.translation() += handle.side * box->size[handle.axis] / 2 * pose.linear().col(handle.axis);
    return pose;
  }
  const auto& half_space = std::get<RegionHalfSpace>(shape);
  const double length = half_space.normal.norm();
  const Eigen::Vector3d normal = half_space.normal / length, middle = around.isEmpty() ? Eigen::Vector3d::Zero().eval() : around.center();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), normal).toRotationMatrix();
  pose.translation() = middle + (half_space.offset / length - normal.dot(middle)) * normal;
  return pose;
}

RegionShape dragged(const RegionShape& shape, const RegionHandle& handle, const Eigen::Isometry3d& pose) {
  if (const auto* const box = std::get_if<RegionBox>(&shape))
    return handle.axis < 0 ? draggedWhole(*box, pose) : draggedFace(*box, handle, pose);
  return draggedPlane(std::get<RegionHalfSpace>(shape), pose);
}

double drawnSize(const RegionShape& shape, const Eigen::AlignedBox3d& around) {
  if (const auto* const box = std::get_if<RegionBox>(&shape)) return box->size.maxCoeff();
  return around.isEmpty() ? kFirst : kPlane * around.diagonal().norm();
}

RegionBox firstBox(const Eigen::AlignedBox3d& around) {
  RegionBox box;
  box.size.setConstant(kFirst);
  if (around.isEmpty()) return box;
  box.size = rounded(around.sizes(), kRound).cwiseMax(kLeastSide);
  box.size.z() = std::max(kLeastSide, std::round(box.size.z() / 2 / kRound) * kRound);
  box.center = rounded(around.center(), kRound);
  box.center.z() = std::ceil(around.max().z() / kRound) * kRound + box.size.z() / 2;
  return box;
}

RegionHalfSpace firstHalfSpace(const Eigen::AlignedBox3d& around) {
  RegionHalfSpace half_space;
  half_space.normal = -Eigen::Vector3d::UnitZ();
  if (!around.isEmpty()) half_space.offset = std::ceil(-around.min().z() / kRound) * kRound + 0.0;
  return half_space;
}

}  // namespace collision_hulls
