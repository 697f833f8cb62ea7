// The demo robot's rewritten description in DART: it loads, and its gripper holds a box if the hulls follow the fingers closely.
#include "physics/robot.h"

#include <gtest/gtest.h>

#include <dart/dynamics/BodyNode.hpp>
#include <dart/simulation/World.hpp>

#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/pipeline/output.h"
#include "physics/engine.h"
#include "physics/grip.h"
#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace {

using fixtures::TempFolder;

struct Rewritten {
  TempFolder folder;
  RobotResult result;
  dart::dynamics::SkeletonPtr robot;
};

std::unique_ptr<Rewritten> rewritten(Method method, const std::string& links) {
  auto made = std::make_unique<Rewritten>();
  const Input input = openInput(DEMO_ROBOT "/urdf/demo_arm.urdf");
  Options options;
  options.method = method;
  options.tolerance = shareOf(0.02);
  options.links = links;
  options.uri = UriStyle::kFile;
  options.validate = false;
  const std::string output = made->folder / "out";
  made->result = decompose(input, options, output);
  writeOutput(made->result, output);
  made->robot = loadRobot(made->result.urdf, input.robot.path, input.find_package);
  return made;
}

GripResult gripped(Method method) {
  return grip(rewritten(method, "(left|right)_finger_link")->robot);
}

TEST(RewrittenRobot, LoadsWithOneShapePerHull) {
  const auto made = rewritten(Method::kSingleHull, "");
  std::size_t shapes = 0, hulls = 0;
  for (const auto* const body : made->robot->getBodyNodes()) shapes += body->getNumShapeNodesWith<dart::dynamics::CollisionAspect>();
  for (const ElementResult& element : made->result.elements) hulls += element.hulls.size();
  EXPECT_EQ(hulls, 11u);
  EXPECT_EQ(shapes, hulls + 3) << "plus the wrist's two cylinders and the camera's box";
  EXPECT_EQ(made->robot->getNumDofs(), 8u);
  const auto world = newWorld(Way::kMesh, {0, 0, -kEarth});
  world->addSkeleton(made->robot);
  for (int i = 0; i < 100; ++i) world->step();
  EXPECT_TRUE(made->robot->getPositions().allFinite());
}

TEST(Grip, CertifiedHullsHoldTheBox) {
  const GripResult result = gripped(Method::kCertified);
  EXPECT_EQ(result.outcome, "held");
  EXPECT_LT(result.slip, 0.005) << "the hooks are 3 mm below the box";
  EXPECT_LT(result.opening, 0.016) << "the arms must reach the box, which is 40 mm wide";
  EXPECT_GT(result.hulls, 4u);
}

TEST(Grip, SingleHullsLetItSlip) {
  const GripResult result = gripped(Method::kSingleHull);
  EXPECT_EQ(result.outcome, "lost");
  EXPECT_GT(result.opening, 0.03) << "the hulls fill the space behind the hooks";
}

TEST(Grip, RejectsARobotWithoutTheGripper) {
  const char* const urdf = "<robot name='r'><link name='a'/></robot>";
  try {
    grip(loadRobot(urdf, "/r.urdf", [](const std::string&) { return std::nullopt; }));
    FAIL() << "no gripper, no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNotARobot);
    EXPECT_NE(std::string(error.what()).find("left_finger_joint"), std::string::npos);
  }
}

TEST(LoadRobot, LeavesOutVisualsAndNothingElse) {
  const std::string ball = "<geometry><sphere radius='1'/></geometry>",
                    lost = "<geometry><mesh filename='package://p/a.dae' scale='-1 1 1'/></geometry>";
  const auto robot =
      loadRobot("<robot name='r'><link name='a'><collision>" + ball + "</collision><visual name='v'>" + lost +
                    "</visual><!-- <visual> --></link><gazebo><visualize>false</visualize></gazebo><link name='b'><collision>" + ball +
                    "</collision><visual\n>" + lost +
                    "</visual></link><joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint></robot>",
                "/r.urdf", [](const std::string&) { return std::nullopt; });
  ASSERT_EQ(robot->getNumBodyNodes(), 2u);
  for (const auto* const body : robot->getBodyNodes()) {
    EXPECT_EQ(body->getNumShapeNodesWith<dart::dynamics::CollisionAspect>(), 1u);
    EXPECT_EQ(body->getNumShapeNodes(), 1u);
  }
}

TEST(LoadRobot, LeavesOutAVisualWithinAnotherOnce) {
  const auto robot = loadRobot(
      "<robot name='r'><link name='a'><visual><visual name='inner'/></visual></link><link name='b'/>"
      "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint></robot>",
      "/r.urdf", [](const std::string&) { return std::nullopt; });
  EXPECT_EQ(robot->getNumBodyNodes(), 2u);
}

TEST(LoadRobot, RejectsTextThatIsNoDescription) {
  EXPECT_THROW(loadRobot("rubbish", "/r.urdf", [](const std::string&) { return std::nullopt; }), Error);
}

}  // namespace
}  // namespace collision_hulls
