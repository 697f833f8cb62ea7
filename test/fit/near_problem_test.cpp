// What a fit sets aside as too far away, and what it says of that.
#include "fit/near_problem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fit/fit_fixtures.h"

namespace collision_hulls {
namespace {

using namespace fit_fixtures;

TEST(NearProblem, SetsAsideWhatIsFar) {
  // The channel travels 2 m from its frame's origin, no point of it further than some reach.
  double reach = 0;
  for (const Eigen::Vector3d& v : channel().vertices) reach = std::max(reach, 2 + v.norm());
  FitProblem problem = overPost();
  for (const double times : {1.9, 2.1, 5.0})
    problem.scene.bodies.push_back(boxBody(std::to_string(times), {0.1, 0.1, 0.1}, {times * reach, 0, 0}));
  SceneBody ground{"ground", TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {30, 0, 0}, {31, 0, 0}, {30, 1, 0}}, {{3, 4, 5}, {0, 1, 2}}}};
  ground.pose.translation().x() = -25;
  problem.scene.bodies.push_back(ground);
  const NearProblem near = nearProblem(problem, 0.01, {});
  ASSERT_EQ(near.problem.scene.bodies.size(), 3u);
  EXPECT_EQ(near.problem.scene.bodies[1].name, "1.900000");
  EXPECT_EQ(near.far_bodies, 2u);
  EXPECT_EQ(near.links, 1u);
  const auto& left = std::get<TriangleMesh>(near.problem.scene.bodies[2].shape);
  EXPECT_EQ(left.triangles.size(), 1u);
  EXPECT_EQ(left.vertices, (std::vector<Eigen::Vector3d>{{30, 0, 0}, {31, 0, 0}, {30, 1, 0}}));
  EXPECT_NEAR(near.far[1], 1.1 * reach - 0.05, 1e-9);
  EXPECT_TRUE(std::isinf(near.far[0])) << "a link without geometry";
  EXPECT_EQ(nearProblem(problem, 2 * reach, {}).far_bodies, 1u) << "a clearance above the reach counts instead";

  const SceneFit fit = fitScene(problem, fitOptions());
  EXPECT_EQ(fit.report.far_bodies, 2u);
  EXPECT_EQ(fit.report.pairs, 5u);
  EXPECT_EQ(fit.report.proved_pairs, 4u);
  EXPECT_EQ(fit.elements[0].cut, fitScene(overPost(), fitOptions()).elements[0].cut);
}

TEST(NearProblem, GivenConfigurationsBeyondALimitCountForWhatIsFar) {
  FitProblem problem = overPost();
  problem.scene.bodies[0].pose.translation().z() += 10;
  EXPECT_EQ(nearProblem(problem, 0.01, {}).far_bodies, 1u);
  problem.configurations = {{0}, {9}};
  EXPECT_EQ(nearProblem(problem, 0.01, {}).far_bodies, 0u);
}

TEST(NearProblem, NothingIsFarFromALinkWhosePlaceDependsOnEarlierTurns) {
  FitProblem problem;
  const auto arm = [](const std::string& mimic) {
    return parseRobotDescription(
        "<robot name='r'><link name='a'/><link name='b'/><link name='c'/>"
        "<joint name='turn' type='continuous'><parent link='a'/><child link='b'/></joint>"
        "<joint name='slow' type='continuous'><parent link='b'/><child link='c'/>" +
        mimic + "</joint></robot>");
  };
  problem.elements.push_back({"", 2, Eigen::Isometry3d::Identity(), fitMesh(test_shapes::box(0.1, 0.1, 0.1))});
  problem.scene.bodies.push_back(boxBody("far", {1, 1, 1}, {20, 0, 0}));
  problem.robot = arm("");
  EXPECT_EQ(nearProblem(problem, 0.01, {}).far_bodies, 1u);
  problem.robot = arm("<mimic joint='turn' multiplier='0.5'/>");
  EXPECT_EQ(nearProblem(problem, 0.01, {}).far_bodies, 0u);
}

TEST(NearProblem, SaysHowFarEverythingStaysIfAllIsFar) {
  FitProblem problem = overPost();
  problem.scene.bodies[0].pose.translation().x() += 30;
  const SceneFit fit = fitScene(problem, fitOptions());
  EXPECT_EQ(fit.report.far_bodies, 1u);
  EXPECT_EQ(fit.report.pairs, 1u);
  EXPECT_TRUE(fit.report.links[0].proved);
  EXPECT_NE(fit.report.links[0].reason.find("never within 27 m of anything, proved"), std::string::npos) << fit.report.links[0].reason;
}

}  // namespace
}  // namespace collision_hulls
