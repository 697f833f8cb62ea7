#include "ros/planning_scene.h"

#include <gtest/gtest.h>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

using shape_msgs::SolidPrimitive;

geometry_msgs::Pose at(double x, double y, double z) {
  geometry_msgs::Pose pose;
  pose.position.x = x;
  pose.position.y = y;
  pose.position.z = z;
  pose.orientation.w = 1;
  return pose;
}

SolidPrimitive primitive(std::uint8_t type, const std::vector<double>& dimensions) {
  SolidPrimitive result;
  result.type = type;
  result.dimensions.assign(dimensions.begin(), dimensions.end());
  return result;
}

/// One object in the root link's frame, without shapes.
moveit_msgs::PlanningScene sceneOf(const std::string& frame = "base") {
  moveit_msgs::PlanningScene scene;
  scene.name = "cell";
  scene.world.collision_objects.resize(1);
  scene.world.collision_objects[0].id = "thing";
  scene.world.collision_objects[0].header.frame_id = frame;
  return scene;
}

/// The same with a ball of 0.1 m at (1, 0, 0).
moveit_msgs::PlanningScene ballIn(const std::string& frame) {
  moveit_msgs::PlanningScene scene = sceneOf(frame);
  scene.world.collision_objects[0].primitives = {primitive(SolidPrimitive::SPHERE, {0.1})};
  scene.world.collision_objects[0].primitive_poses = {at(1, 0, 0)};
  return scene;
}

Eigen::Vector3d placeOf(const Scene& scene) {
  return scene.bodies.at(0).pose.translation();
}

TEST(PlanningScene, Empty) {
  EXPECT_TRUE(toScene(sceneOf(), "base").bodies.empty());
}

TEST(PlanningScene, NoWholeScene) {
  moveit_msgs::PlanningScene difference = ballIn("base");
  difference.is_diff = true;
  EXPECT_THROW(toScene(difference, "base"), Error);
}

TEST(PlanningScene, ShapesOfEveryKind) {
  moveit_msgs::PlanningScene message = sceneOf();
  moveit_msgs::CollisionObject& object = message.world.collision_objects[0];
  object.pose = at(0, 0, 2);
  object.primitives = {primitive(SolidPrimitive::BOX, {1, 2, 3}), primitive(SolidPrimitive::CYLINDER, {3, 0.5}),
                       primitive(SolidPrimitive::CONE, {3, 0.5})};
  object.primitive_poses = {at(0, 1, 0), at(0, 0, 0), at(0, 0, 0)};
  object.meshes.resize(1);
  object.meshes[0].vertices.resize(3);
  object.meshes[0].vertices[1].x = object.meshes[0].vertices[2].y = 1;
  object.meshes[0].triangles.resize(1);
  object.meshes[0].triangles[0].vertex_indices = {0, 1, 2};
  object.planes.resize(1);
  object.planes[0].coef = {0, 0, 1, 0};

  const Scene scene = toScene(message, "base");
  EXPECT_EQ(scene.name, "cell");
  ASSERT_EQ(scene.bodies.size(), 5u);
  EXPECT_EQ(scene.bodies[0].name, "thing/1");
  EXPECT_TRUE(boundingBox(std::get<ConvexHull>(scene.bodies[0].shape)).sizes().isApprox(Eigen::Vector3d(1, 2, 3)));
  EXPECT_TRUE(placeOf(scene).isApprox(Eigen::Vector3d(0, 1, 2)));
  EXPECT_NEAR(volume(std::get<ConvexHull>(scene.bodies[1].shape)), EIGEN_PI * 0.75, 0.02);
  EXPECT_NEAR(volume(std::get<ConvexHull>(scene.bodies[2].shape)), EIGEN_PI * 0.25, 0.02);
  EXPECT_EQ(std::get<TriangleMesh>(scene.bodies[3].shape).triangles.size(), 1u);
  EXPECT_NEAR(scene.bodies[4].pose.translation().z(), 2 - kPlaneDepth / 2, 1e-12);
}

TEST(PlanningScene, WhatIsNoShape) {
  moveit_msgs::PlanningScene message = ballIn("base");
  SolidPrimitive& ball = message.world.collision_objects[0].primitives[0];
  ball.dimensions = {};
  EXPECT_THROW(toScene(message, "base"), Error);
  ball = primitive(SolidPrimitive::SPHERE, {-1});
  EXPECT_THROW(toScene(message, "base"), Error);
  ball = primitive(17, {1});
  EXPECT_THROW(toScene(message, "base"), Error);
  message = ballIn("base");
  message.world.collision_objects[0].primitives.clear();  // a pose of nothing
  EXPECT_THROW(toScene(message, "base"), Error);
}

TEST(PlanningScene, Frames) {
  EXPECT_TRUE(placeOf(toScene(ballIn("/base"), "base")).isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_THROW(toScene(ballIn("world"), "base"), Error);

  moveit_msgs::PlanningScene fixed = ballIn("table");
  fixed.fixed_frame_transforms.resize(1);
  fixed.fixed_frame_transforms[0].header.frame_id = "base";
  fixed.fixed_frame_transforms[0].child_frame_id = "table";
  fixed.fixed_frame_transforms[0].transform.translation.y = 2;
  EXPECT_TRUE(placeOf(toScene(fixed, "base")).isApprox(Eigen::Vector3d(1, 2, 0)));
  fixed.fixed_frame_transforms[0].header.frame_id = "/base";
  fixed.fixed_frame_transforms[0].child_frame_id = "/table";
  EXPECT_TRUE(placeOf(toScene(fixed, "base")).isApprox(Eigen::Vector3d(1, 2, 0))) << "as ROS once named frames";

  moveit_msgs::PlanningScene round = ballIn("a");
  round.fixed_frame_transforms.resize(2);
  round.fixed_frame_transforms[0].header.frame_id = round.fixed_frame_transforms[1].child_frame_id = "b";
  round.fixed_frame_transforms[1].header.frame_id = round.fixed_frame_transforms[0].child_frame_id = "a";
  EXPECT_THROW(toScene(round, "base"), Error);

  // The robot stands at (0, 0, 1) in the world.
  moveit_msgs::PlanningScene floating = ballIn("world");
  floating.robot_state.multi_dof_joint_state.header.frame_id = "world";
  floating.robot_state.multi_dof_joint_state.transforms.resize(1);
  floating.robot_state.multi_dof_joint_state.transforms[0].translation.z = 1;
  EXPECT_TRUE(placeOf(toScene(floating, "base")).isApprox(Eigen::Vector3d(1, 0, -1)));
  floating.robot_state.multi_dof_joint_state.header.frame_id = "/world";
  EXPECT_TRUE(placeOf(toScene(floating, "base")).isApprox(Eigen::Vector3d(1, 0, -1)));
}

TEST(PlanningScene, Octomap) {
  moveit_msgs::PlanningScene message = ballIn("base");
  octomap_msgs::OctomapWithPose& map = message.world.octomap;
  map.header.frame_id = "base";
  map.origin = at(0, 0, 5);
  map.octomap.binary = true;
  map.octomap.id = "OcTree";
  map.octomap.resolution = 1;
  map.octomap.data = {0, static_cast<std::int8_t>(0x80)};
  const Scene scene = toScene(message, "base");
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(scene.bodies[1].name, "octomap/1");
  EXPECT_TRUE(scene.bodies[1].pose.translation().isApprox(Eigen::Vector3d(16384, 16384, 16389)));
}

}  // namespace
}  // namespace collision_hulls
