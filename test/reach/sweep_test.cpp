#include "reach/sweep.h"

#include <cmath>

#include "geometry/random_stream.h"
#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

constexpr double kPi = 3.14159265358979323846;

ConvexHull hullOf(const PointMatrix& points) {
  std::vector<Eigen::Vector3d> list;
  for (Eigen::Index i = 0; i < points.cols(); ++i) list.emplace_back(points.col(i));
  return convexHull(list);
}

TEST(Sweep, NoLinkAndNoJoints) {
  EXPECT_EQ(sweeps({}, {}, {}).at(0).cols(), 0);
  Chain chain;
  chain.end.translation() = Eigen::Vector3d(1, 2, 3);
  const std::vector<PointMatrix> still = sweeps(boxShape({1, 1, 1}), chain, {});
  ASSERT_EQ(still.size(), 1u);
  EXPECT_TRUE(boundingBox(hullOf(still[0])).center().isApprox(Eigen::Vector3d(1, 2, 3)));
}

TEST(Sweep, EnclosesARoundLinkWithFewerPoints) {
  const ConvexHull sphere = sphereShape(0.2);
  const PointMatrix points = sweeps(sphere, {}, {}).at(0);
  EXPECT_LT(static_cast<std::size_t>(points.cols()), sphere.vertices.size());
  const ConvexHull body = hullOf(points);
  for (const Eigen::Vector3d& v : sphere.vertices) EXPECT_LE(planeDistance(body, v), 1e-9);
}

TEST(Sweep, SlidingBox) {
  ChainJoint joint;
  joint.turns = false;
  joint.multiplier = -2;
  joint.offset = 1;
  const JointRange range = rangeOf(joint, {{"j", 0, 3}});
  EXPECT_EQ(range.lower, -5);
  EXPECT_EQ(range.upper, 1);
  const ConvexHull body = convexHull(swept(boxShape({1, 1, 1}).vertices, joint, range));
  EXPECT_TRUE(boundingBox(body).min().isApprox(Eigen::Vector3d(-5.5, -0.5, -0.5)));
  EXPECT_NEAR(volume(body), 7, 1e-9);
}

TEST(Sweep, TurningPointsStayWithinTwoPerCentOfTheirArc) {
  ChainJoint joint;
  joint.axis = Eigen::Vector3d::UnitZ();
  for (const double length : {0.0, 0.1, 1.0, kPi, 6.0, 2 * kPi, 9.0}) {
    const ConvexHull body = convexHull(swept({{1, 0, 0}, {1, 0, 1}}, joint, {0.3, 0.3 + length}));
    for (int i = 0; i <= 1000; ++i) {
      const double angle = 0.3 + length * i / 1000;
      EXPECT_LE(planeDistance(body, {std::cos(angle), std::sin(angle), 0.5}), 1e-9) << length << " at " << angle;
    }
    for (const Eigen::Vector3d& v : body.vertices) EXPECT_LE(v.head<2>().norm(), 1.02) << length;
  }
}

TEST(Sweep, AWholeTurnFromALimitFarOut) {
  ChainJoint joint;
  joint.axis = Eigen::Vector3d::UnitZ();
  const ConvexHull body = convexHull(swept({{1, 0, 0}, {1, 0, 1}}, joint, {-1e17, 0}));
  for (double angle = 0; angle < 2 * kPi; angle += 0.01)
    EXPECT_LE(planeDistance(body, {std::cos(angle), std::sin(angle), 0.5}), 1e-9) << angle;
}

TEST(Sweep, EnclosesTheLinkInAllConfigurations) {
  const RobotDescription robot = readRobotDescription(DEMO_ROBOT "/urdf/demo_arm.urdf");
  const Kinematics kinematics(robot);
  const ConvexHull link = boxShape({0.1, 0.2, 0.3});
  Random random(3, 0, 0);
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const Chain chain = kinematics.chain(l);
    const std::vector<PointMatrix> bodies = sweeps(link, chain, kinematics.variables());
    ASSERT_EQ(bodies.size(), chain.joints.size() + 1);
    for (int i = 0; i < 20; ++i) {
      const Configuration configuration = kinematics.sample([&] { return random.uniform(0, 1); });
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // of the frame that joint k moves
      for (std::size_t k = 0; k < bodies.size(); ++k) {
        const ConvexHull body = hullOf(bodies[k]);
        for (const Eigen::Vector3d& v : link.vertices) {
          const Eigen::Vector3d place = kinematics.poses(configuration)[l] * v;
          EXPECT_LE(planeDistance(body, pose.inverse() * place), 1e-9) << robot.links[l].name << " before joint " << k;
        }
        if (k == chain.joints.size()) break;
        const ChainJoint& joint = chain.joints[k];
        pose = pose * joint.origin * motion(joint, joint.multiplier * configuration[joint.variable] + joint.offset);
      }
    }
  }
}

}  // namespace
}  // namespace collision_hulls
