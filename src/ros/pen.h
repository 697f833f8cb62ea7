// Single markers and what they are made of; the ground on which markers.h, annotations.h and the panel's region_markers.h draw.
#pragma once

#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/Marker.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

using MarkerList = std::vector<visualization_msgs::Marker>;

geometry_msgs::Point toPoint(const Eigen::Vector3d& p);
geometry_msgs::Pose toPose(const Eigen::Isometry3d& transform);
geometry_msgs::Vector3 toScale(const Eigen::Vector3d& v);

std_msgs::ColorRGBA colour(double r, double g, double b, double a);

/// Hue, saturation and value, each in [0, 1].
std_msgs::ColorRGBA fromHsv(double hue, double saturation, double value, double opacity);

/// A hue for each link: spread by the golden ratio, so that neighbours in the list differ most.
double linkHue(std::size_t link);

/// A shade of a link's hue for its n-th hull. Shades repeat after seven hulls.
std_msgs::ColorRGBA shade(double hue, std::size_t hull, double opacity);

/// Appends markers, in the frame of a link and locked to it, in the namespace `<kind>/<link>`; numbers those of a namespace from 0.
class Pen {
 public:
  visualization_msgs::Marker& add(MarkerList& list, const std::string& kind, const std::string& link, int type,
                                  const Eigen::Isometry3d& pose);

 private:
  std::map<std::string, int> next_id_;
};

/// Appends triangles to the points of a TRIANGLE_LIST.
void addTriangles(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles, visualization_msgs::Marker& marker);

}  // namespace collision_hulls
