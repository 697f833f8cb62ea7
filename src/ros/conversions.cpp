#include "conversions.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "collision_hulls/pipeline/progress_text.h"
#include "collision_hulls/pipeline/totals.h"

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

LinkReport toMessage(const ElementResult& element) {
  const ElementReport& report = element.report;
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
  if (report.status != Status::kFailed) {
    message.worst = toPoint(element.source.origin * report.worst);
    message.worst_nearest = toPoint(element.source.origin * report.worst_nearest);
  }
  const StageSeconds& s = report.seconds;
  message.seconds = s.read + s.repair + s.decompose + s.certify + s.write;
  return message;
}

std::vector<LinkReport> toMessages(const RobotResult& result) {
  std::vector<LinkReport> messages;
  for (const ElementResult& element : result.elements) messages.push_back(toMessage(element));
  return messages;
}

RunTotals toTotals(const Report& report) {
  const Totals sums = totals(report);
  RunTotals message;
  message.links = static_cast<std::uint32_t>(sums.links);
  message.meshes = static_cast<std::uint32_t>(sums.meshes);
  message.triangles = static_cast<std::uint32_t>(sums.triangles);
  message.hulls = static_cast<std::uint32_t>(sums.hulls);
  message.hull_vertices = static_cast<std::uint32_t>(sums.hull_vertices);
  message.degraded = static_cast<std::uint32_t>(sums.degraded);
  message.failed = static_cast<std::uint32_t>(sums.failed);
  for (const ElementReport& row : report.links) {
    if (row.protrusion <= message.protrusion) continue;
    message.protrusion = row.protrusion;
    message.worst_link = row.link;
  }
  message.seconds = report.seconds;
  return message;
}

DecomposeFeedback toMessage(const Step& step) {
  DecomposeFeedback feedback;
  feedback.stage = step.stage;
  feedback.link = step.item;
  feedback.done = static_cast<std::uint32_t>(step.done);
  feedback.total = static_cast<std::uint32_t>(step.total);
  feedback.hulls = static_cast<std::uint32_t>(step.hulls);
  feedback.fraction = step.fraction;
  feedback.seconds_left = step.seconds_left < 0 ? -1 : step.seconds_left;
  feedback.text = stepText(step);
  return feedback;
}

std::string summary(const Report& report) {
  const auto count = [](std::size_t n, const char* one, const char* many) { return std::to_string(n) + " " + (n == 1 ? one : many); };
  const Totals sums = totals(report);
  std::string text;
  for (const ElementReport& row : report.links)
    if (row.status == Status::kFailed) text += row.link + ", " + row.uri + " failed: " + row.reason + "\n";
  return text + count(sums.hulls, "hull", "hulls") + " for " + count(sums.meshes - sums.failed, "mesh", "meshes") +
         (sums.failed > 0 ? ", " + std::to_string(sums.failed) + " failed" : "");
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
