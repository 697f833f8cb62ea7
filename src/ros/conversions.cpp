#include "conversions.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace collision_hulls {
namespace {

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

geometry_msgs::Vector3 toScale(double x, double y, double z) {
  geometry_msgs::Vector3 scale;
  scale.x = x;
  scale.y = y;
  scale.z = z;
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

/// Hue, saturation and value, each in [0, 1].
std_msgs::ColorRGBA fromHsv(double hue, double saturation, double value) {
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + 6.0 * hue, 6.0);
    return value - value * saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
  };
  return colour(channel(5), channel(3), channel(1), 1);
}

/// Builds the markers of one result; numbers those of a namespace from 0.
class MarkerList {
 public:
  MarkerList() {
    Marker marker;
    marker.action = Marker::DELETEALL;
    array_.markers.push_back(marker);
  }

  Marker& add(const ElementResult& element, const std::string& kind, int type) {
    Marker marker;
    marker.header.frame_id = element.report.link;
    marker.ns = kind + "/" + element.report.link;
    marker.id = next_id_[marker.ns]++;
    marker.type = type;
    marker.action = Marker::ADD;
    marker.pose = toPose(element.source.origin);
    marker.scale = toScale(1, 1, 1);
    marker.frame_locked = true;
    array_.markers.push_back(marker);
    return array_.markers.back();
  }

  visualization_msgs::MarkerArray take() { return std::move(array_); }

 private:
  visualization_msgs::MarkerArray array_;
  std::map<std::string, int> next_id_;
};

void addTriangles(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles, Marker& marker) {
  marker.points.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles) {
    for (const int corner : triangle) marker.points.push_back(toPoint(vertices[static_cast<std::size_t>(corner)]));
  }
}

/// Sizes are shares of the mesh's diagonal, so that the place is seen on a finger as on an arm.
void addWorst(const ElementResult& element, MarkerList& markers) {
  const ElementReport& report = element.report;
  const auto red = colour(1, 0.05, 0.05, 1);
  Marker& sphere = markers.add(element, "worst", Marker::SPHERE);
  sphere.pose = toPose(element.source.origin * Eigen::Translation3d(report.worst));
  const double diameter = 0.03 * report.diagonal;
  sphere.scale = toScale(diameter, diameter, diameter);
  sphere.color = red;
  Marker& arrow = markers.add(element, "worst", Marker::ARROW);
  arrow.scale = toScale(0.3 * diameter, 0.6 * diameter, 0);
  arrow.points = {toPoint(report.worst), toPoint(report.worst_nearest)};
  arrow.color = red;
}

}  // namespace

LinkReport toMessage(const ElementReport& report) {
  LinkReport message;
  message.link = report.link;
  message.element = report.element;
  message.uri = report.uri;
  message.status = name(report.status);
  message.reason = report.reason;
  message.triangles = static_cast<std::uint32_t>(report.triangles);
  message.hulls = static_cast<std::uint32_t>(report.hulls);
  message.hull_vertices = static_cast<std::uint32_t>(report.hull_vertices);
  message.tolerance = report.tolerance;
  message.uncovered = report.uncovered;
  message.protrusion = report.protrusion;
  message.protrusion_found = report.protrusion_found;
  const StageSeconds& s = report.seconds;
  message.seconds = s.read + s.repair + s.decompose + s.certify + s.write;
  return message;
}

std::vector<LinkReport> toMessages(const Report& report) {
  std::vector<LinkReport> messages;
  for (const ElementReport& element : report.links) messages.push_back(toMessage(element));
  return messages;
}

DecomposeFeedback toMessage(const Step& step) {
  DecomposeFeedback feedback;
  feedback.stage = step.stage;
  feedback.link = step.item;
  feedback.done = static_cast<std::uint32_t>(step.done);
  feedback.total = static_cast<std::uint32_t>(step.total);
  feedback.hulls = static_cast<std::uint32_t>(step.hulls);
  return feedback;
}

std::string summary(const Report& report) {
  std::size_t hulls = 0, failed = 0;
  std::string failures;
  for (const ElementReport& element : report.links) {
    hulls += element.hulls;
    if (element.status != Status::kFailed) continue;
    ++failed;
    failures += "\n" + element.link + " (element " + std::to_string(element.element) + "): " + element.reason;
  }
  std::string text = std::to_string(report.links.size()) + " meshes, " + std::to_string(hulls) + " hulls";
  if (failed > 0) text += ", " + std::to_string(failed) + " meshes failed:" + failures;
  for (const std::string& note : report.notes) text += "\nnote: " + note;
  return text;
}

std_msgs::ColorRGBA hullColour(std::size_t index) {
  constexpr double kGoldenRatio = 0.6180339887498949;
  constexpr double kSaturation[] = {0.7, 0.5, 0.85}, kValue[] = {1.0, 1.0, 0.9};
  const double turns = kGoldenRatio * static_cast<double>(index);
  return fromHsv(turns - std::floor(turns), kSaturation[index % 3], kValue[index % 3]);
}

visualization_msgs::MarkerArray toMarkers(const RobotResult& result) {
  MarkerList markers;
  std::size_t index = 0;
  for (const ElementResult& element : result.elements) {
    for (const ConvexHull& hull : element.hulls) {
      Marker& marker = markers.add(element, "hulls", Marker::TRIANGLE_LIST);
      addTriangles(hull.vertices, hull.triangles, marker);
      marker.color = hullColour(index++);
    }
    for (const ConvexHull& hull : element.unneeded) {
      Marker& marker = markers.add(element, "unneeded", Marker::TRIANGLE_LIST);
      addTriangles(hull.vertices, hull.triangles, marker);
      marker.color = colour(0.5, 0.5, 0.5, 0.35);
    }
    if (!element.original.triangles.empty()) {
      Marker& marker = markers.add(element, "original", Marker::TRIANGLE_LIST);
      addTriangles(element.original.vertices, element.original.triangles, marker);
      marker.color = colour(0.6, 0.6, 0.6, 0.25);
    }
    if (element.report.protrusion_found > 0) addWorst(element, markers);
  }
  return markers.take();
}

}  // namespace collision_hulls
