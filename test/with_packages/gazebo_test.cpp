// libsdformat loads what --for gazebo writes, with every link where the description has it.
#include <gtest/gtest.h>

#include <map>
#include <sdf/sdf.hh>

#include "collision_hulls/robot/robot_description.h"
#include "with_packages/written.h"

namespace collision_hulls {
namespace {

/// Every link with its collisions, or a frame for it, where it is when all joints are at zero.
void expectTheSame(const std::string& out) {
  sdf::Root root;
  const sdf::Errors errors = root.Load(out + "/model.sdf");
  for (const sdf::Error& error : errors) ADD_FAILURE() << out << ": " << error.Message();
  const sdf::Model* const model = root.Model();
  ASSERT_NE(model, nullptr);
  for (const auto& file : std::filesystem::directory_iterator(out + "/urdf")) {
    const RobotDescription robot = readRobotDescription(file.path().string());
    std::map<std::string, Eigen::Isometry3d> places;  // of links whose joints are at zero
    for (const LinkDescription& link : robot.links) places[link.name] = Eigen::Isometry3d::Identity();
    for (const JointDescription& joint : robot.joints) places[joint.child] = places[joint.parent] * joint.origin;
    for (const LinkDescription& link : robot.links) {
      if (link.name == "world") continue;
      const sdf::Link* const other = model->LinkByName(link.name);
      const sdf::Frame* const frame = model->FrameByName(link.name);
      ASSERT_NE(other == nullptr, frame == nullptr) << link.name;
      EXPECT_EQ(other ? other->CollisionCount() : 0, link.collisions.size()) << link.name;
      auto pose = other ? other->RawPose() : frame->RawPose();
      EXPECT_TRUE((other ? other->SemanticPose() : frame->SemanticPose()).Resolve(pose, "__model__").empty()) << link.name;
      const Eigen::Vector3d p = places[link.name].translation();
      EXPECT_NEAR(pose.Pos().X(), p.x(), 1e-9) << link.name;
      EXPECT_NEAR(pose.Pos().Y(), p.y(), 1e-9) << link.name;
      EXPECT_NEAR(pose.Pos().Z(), p.z(), 1e-9) << link.name;
      const Eigen::Quaterniond q(places[link.name].linear());
      EXPECT_NEAR(std::abs(pose.Rot().W() * q.w() + pose.Rot().X() * q.x() + pose.Rot().Y() * q.y() + pose.Rot().Z() * q.z()), 1, 1e-9)
          << link.name;
    }
    EXPECT_EQ(model->JointCount() + model->FrameCount(), robot.joints.size()) << "each frame is fixed by a joint that is none";
  }
}

class Gazebo : public ::testing::Test {
 protected:
  fixtures::TempFolder folder_;
};

TEST_F(Gazebo, LoadsTheDemoRobot) {
  ASSERT_TRUE(fixtures::writeFor("gazebo", DEMO_ROBOT "/urdf/demo_arm.urdf", folder_ / "out",
                                 std::string("--package-path '" DEMO_ROBOT "'") + fixtures::kQuick));
  expectTheSame(folder_ / "out");
  const std::string text = fixtures::read(folder_ / "out/model.sdf");
  EXPECT_NE(text.find("<uri>model://out/meshes/base_link/0_0.stl</uri>"), std::string::npos);
  EXPECT_NE(fixtures::read(folder_ / "out/model.config").find("<sdf version=\"1.9\">model.sdf</sdf>"), std::string::npos);
}

TEST_F(Gazebo, LoadsTheSharedRobots) {
  if (fixtures::sharedRobots().empty()) GTEST_SKIP() << "no robots beside the repository";
  for (const std::string& robot : fixtures::sharedRobots()) {
    const std::string out = folder_ / std::filesystem::path(robot).filename().string();
    if (fixtures::writeFor("gazebo", robot, out, fixtures::kQuick)) expectTheSame(out);
  }
}

}  // namespace
}  // namespace collision_hulls
