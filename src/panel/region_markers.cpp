// Each face has a marker of its own beside that of the whole box: rviz moves what is dragged by itself, and a face must not take the box
// along.
#include "panel/region_markers.h"

#include <visualization_msgs/InteractiveMarkerControl.h>
#include <visualization_msgs/Marker.h>

#include <algorithm>

#include "ros/pen.h"

namespace collision_hulls {
namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::Marker;

constexpr double kControls = 1.35;                     // of what is drawn: arrows and rings are beyond the handles on the faces
constexpr double kHandle = 0.1, kLeastHandle = 0.004;  // of a box's longest side; [m]
constexpr double kThin = 0.004, kArrow = 0.3;          // of the piece of a plane
constexpr double kAxisColors[3][3] = {{0.85, 0.1, 0.1}, {0.1, 0.65, 0.1}, {0.15, 0.3, 0.9}};

Marker body(int type, const Eigen::Vector3d& scale, const std_msgs::ColorRGBA& color) {
  Marker marker;
  marker.type = type;
  marker.pose.orientation.w = 1;
  marker.scale = toScale(scale);
  marker.color = color;
  return marker;
}

Marker edges(const Eigen::Vector3d& size) {
  Marker lines = body(Marker::LINE_LIST, {size.maxCoeff() / 150, 0, 0}, colour(0.7, 0.4, 0, 1));
  const auto corner = [&](int bits) {
    return toPoint(size.cwiseProduct(Eigen::Vector3d(bits & 1 ? 0.5 : -0.5, bits & 2 ? 0.5 : -0.5, bits & 4 ? 0.5 : -0.5)));
  };
  for (int from = 0; from < 8; ++from)
    for (const int bit : {1, 2, 4})
      if ((from & bit) == 0) lines.points.insert(lines.points.end(), {corner(from), corner(from | bit)});
  return lines;
}

/// Along or about an axis of the marker.
InteractiveMarkerControl control(int mode, int axis) {
  InteractiveMarkerControl control;
  control.interaction_mode = static_cast<std::uint8_t>(mode);
  control.name = std::string(mode == InteractiveMarkerControl::MOVE_AXIS ? "move " : "turn ") + "xyz"[axis];
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), Eigen::Vector3d::Unit(axis));
  control.orientation.w = turn.w();
  control.orientation.x = turn.x();
  control.orientation.y = turn.y();
  control.orientation.z = turn.z();
  return control;
}

void draw(const RegionShape& shape, double size, InteractiveMarkerControl& drawn) {
  const std_msgs::ColorRGBA fill = colour(1, 0.65, 0.1, 0.35);
  if (const auto* const box = std::get_if<RegionBox>(&shape)) {
    drawn.markers = {body(Marker::CUBE, box->size, fill), edges(box->size)};
    return;
  }
  drawn.markers = {body(Marker::CUBE, {kThin * size, size, size}, fill),
                   body(Marker::ARROW, {kArrow * size, kArrow * size / 12, kArrow * size / 8}, colour(0.9, 0.5, 0, 1))};
}

/// A box moves and turns along and about all axes, a plane along its normal and about the others.
void addControls(bool is_box, InteractiveMarker& marker) {
  for (int axis = 0; axis < 3; ++axis) {
    if (is_box || axis == 0) marker.controls.push_back(control(InteractiveMarkerControl::MOVE_AXIS, axis));
    if (is_box || axis > 0) marker.controls.push_back(control(InteractiveMarkerControl::ROTATE_AXIS, axis));
  }
}

void addWhole(const ShownRegion& shown, InteractiveMarker& marker) {
  const double size = drawnSize(shown.shape, shown.around);
  marker.scale = static_cast<float>(kControls * size);
  marker.description = shown.region;
  InteractiveMarkerControl drawn;
  drawn.name = "drawn";
  drawn.orientation.w = 1;
  drawn.interaction_mode = InteractiveMarkerControl::NONE;
  drawn.always_visible = 1;
  draw(shown.shape, size, drawn);
  marker.controls.push_back(drawn);
  if (shown.has_handles) addControls(std::holds_alternative<RegionBox>(shown.shape), marker);
}

void addFace(const ShownRegion& shown, int axis, InteractiveMarker& marker) {
  const double size = std::max(kLeastHandle, kHandle * drawnSize(shown.shape, shown.around));
  const auto& rgb = kAxisColors[axis];
  marker.scale = static_cast<float>(size);
  InteractiveMarkerControl face = control(InteractiveMarkerControl::MOVE_AXIS, axis);
  face.always_visible = 1;
  face.markers.push_back(body(Marker::SPHERE, Eigen::Vector3d::Constant(size), colour(rgb[0], rgb[1], rgb[2], 1)));
  marker.controls.push_back(face);
}

}  // namespace

Eigen::Isometry3d toPose(const geometry_msgs::Pose& message) {
  const Eigen::Quaterniond turn(message.orientation.w, message.orientation.x, message.orientation.y, message.orientation.z);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (turn.norm() > 0) pose.linear() = turn.normalized().toRotationMatrix();
  pose.translation() = Eigen::Vector3d(message.position.x, message.position.y, message.position.z);
  return pose;
}

InteractiveMarker toMarker(const ShownRegion& shown, const RegionHandle& handle) {
  InteractiveMarker marker;
  marker.header.frame_id = shown.link;
  marker.name = shown.link + "/" + shown.region + "/" + handle.name();
  marker.pose = toPose(poseOf(shown.shape, handle, shown.around));
  if (handle.axis < 0) {
    addWhole(shown, marker);
  } else {
    addFace(shown, handle.axis, marker);
  }
  return marker;
}

}  // namespace collision_hulls
