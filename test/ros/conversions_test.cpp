#include "ros/conversions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace collision_hulls {
namespace {

using visualization_msgs::Marker;

/// A link's mesh at (0, 0, 0.5), turned by a quarter about z, with `hulls` tetrahedra; it protrudes by 1 cm at (0.1, 0, 0).
ElementResult element(const std::string& link, std::size_t hulls) {
  ElementResult result;
  result.report.link = link;
  result.report.hulls = hulls;
  result.report.diagonal = 1;
  result.report.protrusion_found = 0.01;
  result.report.worst = {0.1, 0, 0};
  result.report.worst_nearest = {0.09, 0, 0};
  result.source.origin = Eigen::Translation3d(0, 0, 0.5) * Eigen::AngleAxisd(EIGEN_PI / 2, Eigen::Vector3d::UnitZ());
  result.original.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  result.original.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  result.hulls.assign(hulls, convexHull(result.original.vertices));
  return result;
}

std::vector<std::string> namespaces(const visualization_msgs::MarkerArray& array) {
  std::vector<std::string> result;
  for (const Marker& marker : array.markers) result.push_back(marker.ns + ":" + std::to_string(marker.id));
  return result;
}

TEST(ToMarkers, NothingStillDeletesWhatWasThere) {
  const auto markers = toMarkers({}).markers;
  ASSERT_EQ(1u, markers.size());
  EXPECT_EQ(Marker::DELETEALL, markers[0].action);
}

TEST(ToMarkers, FailedMeshHasItsOriginalAlone) {
  RobotResult result;
  result.elements = {element("arm", 0)};
  result.elements[0].report.protrusion_found = 0;
  EXPECT_EQ((std::vector<std::string>{":0", "original/arm:0"}), namespaces(toMarkers(result)));
}

TEST(ToMarkers, IdsCountWithinANamespace) {
  RobotResult result;
  result.elements = {element("arm", 2), element("arm", 1), element("hand", 1)};
  const std::vector<std::string> expected = {":0",           "hulls/arm:0",     "hulls/arm:1",    "original/arm:0", "worst/arm:0",
                                             "worst/arm:1",  "hulls/arm:2",     "original/arm:1", "worst/arm:2",    "worst/arm:3",
                                             "hulls/hand:0", "original/hand:0", "worst/hand:0",   "worst/hand:1"};
  EXPECT_EQ(expected, namespaces(toMarkers(result)));
}

TEST(ToMarkers, WhatWasNotNeededIsGrey) {
  RobotResult result;
  result.elements = {element("arm", 1)};
  result.elements[0].unneeded.assign(2, result.elements[0].hulls.front());
  int found = 0;
  for (const Marker& marker : toMarkers(result).markers) {
    if (marker.ns != "unneeded/arm") continue;
    ++found;
    EXPECT_EQ(marker.color.r, marker.color.g);
    EXPECT_EQ(marker.color.r, marker.color.b);
    EXPECT_LT(marker.color.a, 1);
  }
  EXPECT_EQ(found, 2);
}

TEST(ToMarkers, PlacesAreInTheLinksFrame) {
  RobotResult result;
  result.elements = {element("arm", 1)};
  const auto markers = toMarkers(result).markers;
  const Marker &hull = markers[1], &sphere = markers[3], &arrow = markers[4];
  EXPECT_EQ("arm", hull.header.frame_id);
  EXPECT_EQ(0.5, hull.pose.position.z);
  EXPECT_NEAR(std::sqrt(0.5), hull.pose.orientation.z, 1e-12);
  EXPECT_EQ(12u, hull.points.size());
  EXPECT_NEAR(0, sphere.pose.position.x, 1e-12);
  EXPECT_NEAR(0.1, sphere.pose.position.y, 1e-12);
  ASSERT_EQ(2u, arrow.points.size());
  EXPECT_EQ(0.1, arrow.points[0].x);
  EXPECT_EQ(0.09, arrow.points[1].x);
  EXPECT_EQ(hull.pose.orientation.z, arrow.pose.orientation.z);
}

TEST(HullColour, NeverTheSameAndNeverPale) {
  std::set<std::tuple<float, float, float>> colours;
  for (std::size_t index = 0; index < 1000; ++index) {
    const auto colour = hullColour(index);
    colours.emplace(colour.r, colour.g, colour.b);
    EXPECT_GT(std::max({colour.r, colour.g, colour.b}) - std::min({colour.r, colour.g, colour.b}), 0.4f) << index;
    EXPECT_EQ(1, colour.a);
  }
  EXPECT_EQ(1000u, colours.size());
}

TEST(Summary, NamesEachFailure) {
  Report report;
  EXPECT_EQ("0 meshes, 0 hulls", summary(report));
  report.links.resize(2);
  report.links[0].hulls = 3;
  report.links[1].link = "hand";
  report.links[1].status = Status::kFailed;
  report.links[1].reason = "no such file";
  EXPECT_EQ("2 meshes, 3 hulls, 1 meshes failed:\nhand (element 0): no such file", summary(report));
  report.notes = {"mind the gap"};
  EXPECT_EQ("2 meshes, 3 hulls, 1 meshes failed:\nhand (element 0): no such file\nnote: mind the gap", summary(report));
}

TEST(ToMessage, LinkReport) {
  ElementReport report;
  report.link = "arm";
  report.element = 2;
  report.status = Status::kDegraded;
  report.reason = "capped";
  report.triangles = 12;
  report.protrusion = 0.002;
  report.seconds = {1, 2, 3, 4, 5};
  const LinkReport message = toMessage(report);
  EXPECT_EQ("arm", message.link);
  EXPECT_EQ(2, message.element);
  EXPECT_EQ("degraded", message.status);
  EXPECT_EQ("capped", message.reason);
  EXPECT_EQ(12u, message.triangles);
  EXPECT_EQ(0.002, message.protrusion);
  EXPECT_EQ(15, message.seconds);
}

}  // namespace
}  // namespace collision_hulls
