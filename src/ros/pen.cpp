// Conversions to messages, colours, and the numbering of markers.
#include "pen.h"

#include <algorithm>
#include <cmath>

namespace collision_hulls {

using visualization_msgs::Marker;

geometry_msgs::Point toPoint(const Eigen::Vector3d& p) {
  geometry_msgs::Point point;
  point.x = p.x();
  point.y = p.y();
  point.z = p.z();
  return point;
}

geometry_msgs::Pose toPose(const Eigen::Isometry3d& transform) {
  const Eigen::Quaterniond rotation(transform.rotation());
  geometry_msgs::Pose pose;
  pose.position = toPoint(transform.translation());
  pose.orientation.x = rotation.x();
  pose.orientation.y = rotation.y();
  pose.orientation.z = rotation.z();
  pose.orientation.w = rotation.w();
  return pose;
}

geometry_msgs::Vector3 toScale(const Eigen::Vector3d& v) {
  geometry_msgs::Vector3 scale;
  scale.x = v.x();
  scale.y = v.y();
  scale.z = v.z();
  return scale;
}

std_msgs::ColorRGBA colour(double r, double g, double b, double a) {
  std_msgs::ColorRGBA result;
  result.r = static_cast<float>(r);
  result.g = static_cast<float>(g);
  result.b = static_cast<float>(b);
  result.a = static_cast<float>(a);
  return result;
}

std_msgs::ColorRGBA fromHsv(double hue, double saturation, double value, double opacity) {
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + 6.0 * hue, 6.0);
    return value - value * saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
  };
  return colour(channel(5), channel(3), channel(1), opacity);
}

double linkHue(std::size_t link) {
  constexpr double kGoldenRatio = 0.6180339887498949, kFirst = 0.58;  // a blue; red is for the arrows
  const double turns = kFirst + kGoldenRatio * static_cast<double>(link);
  return turns - std::floor(turns);
}

std_msgs::ColorRGBA shade(double hue, std::size_t hull, double opacity) {
  constexpr double kSaturation[] = {0.75, 0.6, 0.9, 0.65, 0.8, 0.55, 0.95}, kValue[] = {0.95, 0.75, 0.85, 1.0, 0.65, 0.9, 0.7};
  return fromHsv(hue, kSaturation[hull % 7], kValue[hull % 7], opacity);
}

Marker& Pen::add(MarkerList& list, const std::string& kind, const std::string& link, int type, const Eigen::Isometry3d& pose) {
  Marker marker;
  marker.header.frame_id = link;
  marker.ns = kind + "/" + link;
  marker.id = next_id_[marker.ns]++;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose = toPose(pose);
  marker.scale = toScale(Eigen::Vector3d::Ones());
  marker.frame_locked = true;
  list.push_back(marker);
  return list.back();
}

void addTriangles(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles, Marker& marker) {
  marker.points.reserve(marker.points.size() + 3 * triangles.size());
  for (const Triangle& triangle : triangles) {
    for (const int corner : triangle) marker.points.push_back(toPoint(vertices[static_cast<std::size_t>(corner)]));
  }
}

}  // namespace collision_hulls
