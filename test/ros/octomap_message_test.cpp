#include "ros/octomap_message.h"

#include <gtest/gtest.h>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

/// The eighth of all space beyond the middle, occupied.
octomap_msgs::Octomap message() {
  octomap_msgs::Octomap result;
  result.header.frame_id = "base";
  result.binary = true;
  result.id = "OcTree";
  result.resolution = 0.25;
  result.data = {0, static_cast<std::int8_t>(0x80)};
  return result;
}

TEST(OctomapMessage, OccupiedCells) {
  const Scene scene = toScene(message(), "base");
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(scene.bodies[0].name, "octomap/1");
  EXPECT_TRUE(scene.bodies[0].pose.translation().isApprox(Eigen::Vector3d::Constant(0.25 * 16384)));
}

TEST(OctomapMessage, InAnotherFrame) {
  EXPECT_THROW(toScene(message(), "other"), Error);
}

}  // namespace
}  // namespace collision_hulls
