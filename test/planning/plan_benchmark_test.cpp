#include "planning/plan_benchmark.h"

#include <gtest/gtest.h>

#include "plan_fixtures.h"
#include "planning/checker.h"
#include "planning/plan_queries.h"
#include "planning/plan_table.h"
#include "planning/robot_model.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

using plan_fixtures::post;

/// The rod, by the shape that a model has for it.
RobotModel modelWith(const std::variant<TriangleMesh, ConvexHull, GeometryElement>& shape) {
  Eigen::Isometry3d middle = Eigen::Isometry3d::Identity();
  middle.translation().x() = 0.5;
  return {"rod", {{1, shape, middle}}};
}

struct Turning {
  RobotDescription robot = parseRobotDescription(plan_fixtures::arm());
  Kinematics kinematics{robot};
  JointSpace space{kinematics, "turn"};
};

TEST(Checker, EveryShapeAndCheckerAnswersAlike) {
  const Turning arm;
  ASSERT_EQ(arm.robot.links[1].name, "rod");
  const ConvexHull box = boxShape({1, 0.1, 0.1});
  GeometryElement primitive;
  primitive.kind = GeometryElement::Kind::kBox;
  primitive.size = {1, 0.1, 0.1};
  primitive.origin.translation().x() = 0.5;
  RobotModel of_primitive{"rod", {{1, primitive}}};
  for (const RobotModel& model : {modelWith(box), modelWith(surface(box)), of_primitive}) {
    for (const CheckerKind kind : {CheckerKind::kBoxes, CheckerKind::kTrees, CheckerKind::kMoveIt}) {
      const auto checker = makeChecker(kind, model, arm.robot.links.size(), post(), IgnoredPairs());
      for (const auto& [angle, hit] : {std::pair(0.0, true), std::pair(0.1, true), std::pair(0.2, false), std::pair(-2.0, false)})
        EXPECT_EQ(checker->collides(arm.space.poses({angle})), hit) << name(kind) << " " << angle;
    }
  }
}

TEST(Checker, LeavesOutIgnoredPairsAndNamesTheOthers) {
  const Turning arm;
  RobotModel model = modelWith(boxShape({1, 0.1, 0.1}));
  model.bodies.push_back({0, boxShape({0.1, 0.1, 0.1})});
  IgnoredPairs ignored(arm.robot.links.size() + 1);
  const std::vector<Eigen::Isometry3d> poses = arm.space.poses({1});
  EXPECT_EQ(touchingLinks(model, ignored, poses), (std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}}));
  for (const CheckerKind kind : {CheckerKind::kBoxes, CheckerKind::kTrees, CheckerKind::kMoveIt})
    EXPECT_TRUE(makeChecker(kind, model, arm.robot.links.size(), post(), ignored)->collides(poses));
  ignored.ignore(0, 1);
  EXPECT_TRUE(touchingLinks(model, ignored, poses).empty());
  for (const CheckerKind kind : {CheckerKind::kBoxes, CheckerKind::kTrees, CheckerKind::kMoveIt})
    EXPECT_FALSE(makeChecker(kind, model, arm.robot.links.size(), post(), ignored)->collides(poses));
  EXPECT_EQ(checkerNamed("moveit"), CheckerKind::kMoveIt);
  EXPECT_EQ(checkerNamed("bullet"), std::nullopt);
}

TEST(Checker, APathThroughThePostIsSeen) {
  const Turning arm;
  const auto checker = makeChecker(CheckerKind::kBoxes, modelWith(boxShape({1, 0.1, 0.1})), arm.robot.links.size(), post(), IgnoredPairs());
  const IsFree is_free = [&](const JointValues& values) { return !checker->collides(arm.space.poses(values)); };
  EXPECT_GT(hits(alongPath(arm.space.joints(), {{-1}, {1}}, 0.001), is_free), 10u);
  EXPECT_EQ(hits(alongPath(arm.space.joints(), {{0.5}, {1}}, 0.001), is_free), 0u);
}

/// A channel that turns and is lifted: a mesh of three convex parts, before a stump that it cannot turn past but can be lifted over.
class PlanBenchmark : public ::testing::Test {
 protected:
  PlanBenchmark() {
    fixtures::write(folder_ / "rod.obj", fixtures::obj(test_shapes::uChannel(0.2, 0.8, 0.04, 0.1)));
    const std::string mesh =
        "<link name=\"rod\"><collision><origin xyz=\"0.2 0 0\"/>" + fixtures::meshTag("rod.obj") + "</collision></link>";
    fixtures::write(folder_ / "arm.urdf",
                    "<robot name=\"arm\"><link name=\"base\"/>" + mesh +
                        "<link name=\"carriage\"><collision><geometry><box size=\"0.02 0.02 0.02\"/></geometry></collision></link>" +
                        plan_fixtures::joint("lift", "prismatic", "base", "carriage") +
                        plan_fixtures::joint("turn", "revolute", "carriage", "rod") + "</robot>");
    robot_ = openInput(folder_ / "arm.urdf");
    options_.queries = 3;
    options_.request.samples = 100;
    options_.request.options.validate = false;
    options_.request.options.tolerance = lengthOf(0.03);
    options_.planner.time_limit = 60;
  }

  fixtures::TempFolder folder_;
  Input robot_;
  PlanOptions options_;
};

Scene stump() {
  Scene scene{"stump", {}};
  SceneBody body{"stump", boxShape({0.05, 0.05, 0.05})};
  body.pose.translation() = Eigen::Vector3d(0.5, 0, 0);
  addBody(scene, body);
  return scene;
}

TEST_F(PlanBenchmark, ModelsCoverTheSameLinksAndPlansRepeat) {
  ModelMaker maker(robot_, allModels(), options_.request);
  const SceneModels made = maker.make(stump());
  ASSERT_EQ(made.models.size(), 5u);
  EXPECT_EQ(made.models[0].bodies.size(), 2u) << "the mesh, and the carriage's box";
  EXPECT_TRUE(std::holds_alternative<TriangleMesh>(made.models[0].bodies[0].shape));
  EXPECT_EQ(made.models[1].bodies.size(), 2u);
  EXPECT_EQ(made.models[2].bodies.size(), 4u) << "a channel is three hulls";
  EXPECT_TRUE(std::holds_alternative<GeometryElement>(made.models[4].bodies[0].shape)) << "spheres";
  for (const RobotModel& model : made.models) EXPECT_EQ(model.bodies[0].link, 1u) << model.name;
  EXPECT_TRUE(made.ignored(1, 2)) << "neighbours";
}

TEST_F(PlanBenchmark, ARowForEachQueryModelAndChecker) {
  options_.models = {"original", "single_hull", "default"};
  options_.checkers = {CheckerKind::kBoxes, CheckerKind::kMoveIt};
  std::size_t taken = 0;
  const PlanResults first = runPlanBenchmark(robot_, {stump()}, options_, [&](const PlanRow&) { ++taken; });
  const PlanResults second = runPlanBenchmark(robot_, {stump()}, options_, [](const PlanRow&) {});
  ASSERT_EQ(first.rows.size(), 3u * 3 * 2);
  EXPECT_EQ(taken, first.rows.size());
  for (std::size_t i = 0; i < first.rows.size(); ++i) {
    const PlanRow &a = first.rows[i], &b = second.rows[i];
    EXPECT_EQ(a.model, b.model);
    EXPECT_EQ(a.outcome, b.outcome);
    EXPECT_EQ(a.checks, b.checks);
    EXPECT_EQ(a.path_states, b.path_states);
    EXPECT_EQ(a.path_hits, b.path_hits);
    EXPECT_TRUE(a.model != "original" || a.outcome == Plan::Outcome::kSolved);
    EXPECT_GE(a.seconds, a.check_seconds);
    EXPECT_EQ(a.lost_to.empty(), a.outcome != Plan::Outcome::kLost);
  }
  EXPECT_NE(first.rows[0].checker, first.rows[6].checker) << "another one begins";
}

TEST_F(PlanBenchmark, BadOptionsAreNamed) {
  options_.planner.step = 0;
  expectError(ErrorCode::kBadOption, {"step", "0.5"}, [&] { check(options_); });
  options_.planner.step = 0.01;
  options_.models = {"original", "best"};
  expectError(ErrorCode::kBadOption, {"'best'", "fitted"}, [&] { check(options_); });
}

TEST(PlanTable, SummarizesSolvedQueries) {
  EXPECT_EQ(quartiles({}), nullptr);
  EXPECT_EQ(quartiles({4, 1, 2, 3, 5}), nlohmann::json({1, 2, 3, 4, 5}));
  EXPECT_EQ(quartiles({0, 1}), nlohmann::json({0, 0.25, 0.5, 0.75, 1}));
  PlanResults results;
  results.sizes = {{"post", "original", 1, 0, 12}, {"post", "default", 3, 0, 36}};
  const auto row = [&](const std::string& model, std::size_t query, Plan::Outcome outcome, double seconds, std::size_t path_hits) {
    results.rows.push_back({"post", model, CheckerKind::kBoxes, query, outcome, seconds, seconds / 2, 100, 10, path_hits});
  };
  row("original", 0, Plan::Outcome::kSolved, 0.4, 0);
  row("original", 1, Plan::Outcome::kTimeout, 5, 0);
  row("default", 0, Plan::Outcome::kSolved, 0.1, 2);
  row("default", 1, Plan::Outcome::kLost, 0, 0);
  results.rows.back().lost_to = "hand and wrist";
  PlanOptions options;
  options.checkers = {CheckerKind::kBoxes};
  const nlohmann::json summary = planSummary(results, "rod", {}, options), model = summary["models"][1];
  EXPECT_EQ(summary["models"][0]["timeout"], 1);
  EXPECT_EQ(model["solved"], 1);
  EXPECT_EQ(model["lost_to"], nlohmann::json({{"hand and wrist", 1}}));
  EXPECT_DOUBLE_EQ(model["times_faster"][2], 4);
  EXPECT_DOUBLE_EQ(model["planning_ms"][2], 100);
  EXPECT_DOUBLE_EQ(model["check_us"][2], 500);
  EXPECT_DOUBLE_EQ(model["checking_share"][2], 0.5);
  EXPECT_EQ(model["paths_hit"], 1);
  EXPECT_EQ(toCsv(results.rows[2]), "post,boxes,0,default,solved,0.1,0.05,100,10,2,\n");
  EXPECT_EQ(toCsv(results.rows[3]), "post,boxes,1,default,lost,,,,,,hand and wrist\n");
}

}  // namespace
}  // namespace collision_hulls
