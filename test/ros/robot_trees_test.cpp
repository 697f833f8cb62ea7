#include "ros/preview/robot_trees.h"

#include <gtest/gtest.h>

#include "collision_hulls/error.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "counted_looks.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

/// A robot of two links: a torus, and the same twice as large beside a box.
class RobotTreesTest : public testing::Test {
 protected:
  RobotTreesTest() {
    fixtures::write(folder_ / "torus.obj", fixtures::obj(test_shapes::torus(0.1, 0.03, 24, 12)));
    robot_ = parseRobotDescription(
        R"(<robot name="r"><link name="small"><visual><geometry><mesh filename="torus.obj"/></geometry></visual></link>
      <link name="large"><visual><geometry><mesh filename="torus.obj" scale="2 2 2"/></geometry></visual>
        <visual><geometry><box size="1 1 1"/></geometry></visual></link>
      <joint name="j" type="fixed"><parent link="small"/><child link="large"/></joint></robot>)",
        folder_ / "r.urdf");
    options_.tolerance = lengthOf(0.02);
    options_.tree = lengthOf(0.005);
  }

  RobotResult build(const RunControl& control = {}) { return trees_.build(robot_, defaultPackageFinder(robot_.path), options_, control); }

  void expectTheHullsOfARun() {
    const RobotResult built = build(), run = decomposeRobot(robot_, defaultPackageFinder(robot_.path), options_, folder_ / "out");
    ASSERT_EQ(run.elements.size(), built.elements.size());
    for (std::size_t i = 0; i < run.elements.size(); ++i) {
      ASSERT_EQ(run.elements[i].hulls.size(), built.elements[i].hulls.size());
      for (std::size_t h = 0; h < run.elements[i].hulls.size(); ++h)
        EXPECT_EQ(run.elements[i].hulls[h].vertices, built.elements[i].hulls[h].vertices);
      EXPECT_EQ(run.report.links[i].protrusion, built.report.links[i].protrusion);
    }
  }

  LinkOptions at(double tolerance) const {
    LinkOptions options = options_;
    options.tolerance = lengthOf(tolerance);
    return options;
  }

  LinkResult cut(int link, double tolerance) {
    const auto made = trees_.cut(robot_.links[static_cast<std::size_t>(link)], at(tolerance));
    EXPECT_TRUE(made);
    return made.value_or(LinkResult());
  }

  const fixtures::TempFolder folder_;
  RobotDescription robot_;
  Options options_;
  RobotTrees trees_;
};

TEST_F(RobotTreesTest, WithoutABuildThereIsNoCut) {
  EXPECT_FALSE(trees_.cut(robot_.links[0], options_));
  EXPECT_TRUE(trees_.steps(robot_.links[0], options_).empty());
}

TEST_F(RobotTreesTest, ABuildGivesTheHullsOfARun) {
  expectTheHullsOfARun();
}

TEST_F(RobotTreesTest, ABuildPadsAsARunDoes) {
  options_.padding = 0.01;
  expectTheHullsOfARun();
}

TEST_F(RobotTreesTest, ABuildKeepsRegionsAsARunDoes) {
  options_.tree.reset();
  RegionRule hole;
  hole.pattern = "small";
  hole.shape = RegionBox{{0, 0, 0}, {0.1, 0.1, 0.1}, {0, 0, 0}};
  options_.region_rules = {hole};
  expectTheHullsOfARun();
}

// Its numbers are probably millimetres. A mesh that is held already is looked at like a new one.
TEST_F(RobotTreesTest, ABuildRefusesALengthForAHugeMeshAsARunDoes) {
  robot_ = parseRobotDescription(
      R"(<robot name="r"><link name="huge"><visual><geometry><mesh filename="torus.obj" scale="1000 1000 1000"/></geometry></visual></link></robot>)",
      folder_ / "r.urdf");
  options_.tree.reset();
  options_.tolerance = shareOf(0.1);
  EXPECT_EQ(build().report.links.at(0).status, Status::kOk);
  options_.tolerance = lengthOf(0.5);
  EXPECT_EQ(build().report.links.at(0).error, "TooLarge");
}

TEST_F(RobotTreesTest, ACutHasAsManyHullsAsARunWithThatTolerance) {
  build();
  for (const double tolerance : {0.006, 0.02, 0.08}) {
    Options options = options_;
    options.tolerance = lengthOf(tolerance);
    const RobotResult run = decomposeRobot(robot_, defaultPackageFinder(robot_.path), options, folder_ / "out");
    for (int link = 0; link < 2; ++link)
      EXPECT_EQ(run.elements[static_cast<std::size_t>(link)].hulls.size(), cut(link, tolerance).rows.at(0).hulls);
  }
}

TEST_F(RobotTreesTest, EachMeshOfACutIsALookAtTheControl) {
  build();
  EXPECT_EQ(looksAfterCancel(1, [&](const RunControl& control) { trees_.cut(robot_.links[0], at(0.02), control); }), 1u);
  EXPECT_EQ(looksAfterCancel(1, [&](const RunControl& control) { trees_.steps(robot_.links[0], at(0.02), control); }), 1u);
}

TEST_F(RobotTreesTest, TheBoundOfACutHoldsAndIsTight) {
  build();
  const TriangleMesh torus = readMesh(folder_ / "torus.obj").mesh;
  const Solid solid(repair(torus));
  for (const double tolerance : {0.006, 0.015, 0.05}) {
    const LinkResult made = cut(0, tolerance);
    const Protrusion proof = protrusion(made.elements.at(0).hulls, solid, 1e-5);
    EXPECT_LE(proof.found, made.rows.at(0).protrusion);
    EXPECT_GE(proof.bound, 0.9 * made.rows.at(0).protrusion);
    EXPECT_LE(made.rows.at(0).protrusion, tolerance);
    EXPECT_LE(uncovered(torus, made.elements.at(0).hulls), 1e-5);  // up to the margin: a run rounds them outward
  }
}

TEST_F(RobotTreesTest, EveryStepChangesTheNumberOfHulls) {
  build();
  const std::vector<double> steps = trees_.steps(robot_.links[0], at(0.02));
  ASSERT_GT(steps.size(), 3u);
  EXPECT_DOUBLE_EQ(0.005, steps.front());
  for (std::size_t i = 1; i < steps.size(); ++i) {
    EXPECT_LT(cut(0, steps[i]).rows.at(0).hulls, cut(0, steps[i - 1]).rows.at(0).hulls) << steps[i];
    EXPECT_EQ(cut(0, steps[i]).rows.at(0).hulls, cut(0, 1.004 * steps[i]).rows.at(0).hulls + 0) << steps[i];
  }
  EXPECT_EQ(1u, cut(0, steps.back()).rows.at(0).hulls);
}

TEST_F(RobotTreesTest, ALimitOnHullsThatExceedsTheToleranceIsDegraded) {
  build();
  LinkOptions options = at(0.006);
  options.max_hulls = 2;
  const auto made = trees_.cut(robot_.links[0], options);
  ASSERT_TRUE(made);
  EXPECT_EQ(2u, made->rows.at(0).hulls);
  EXPECT_EQ(Status::kDegraded, made->rows.at(0).status);
  EXPECT_NE(std::string::npos, made->rows.at(0).reason.find("max_hulls"));
}

TEST_F(RobotTreesTest, FinerLeavesOrAnotherEffortNeedABuild) {
  build();
  EXPECT_FALSE(trees_.cut(robot_.links[0], at(0.004)));
  LinkOptions best = at(0.02);
  best.effort = Effort::kBest;
  EXPECT_FALSE(trees_.cut(robot_.links[0], best));
  EXPECT_TRUE(trees_.cut(robot_.links[0], at(0.005)));
}

TEST_F(RobotTreesTest, AnotherRobotTakesTheTreesAway) {
  build();
  RobotDescription other = robot_;
  other.text += " ";
  options_.links = "large";
  trees_.build(other, defaultPackageFinder(robot_.path), options_);
  EXPECT_FALSE(trees_.cut(robot_.links[0], at(0.02)));
  EXPECT_TRUE(trees_.cut(robot_.links[1], at(0.02)));
}

TEST_F(RobotTreesTest, ABuildOfSomeLinksKeepsTheTreesOfOthers) {
  build();
  options_.links = "large";
  build();
  EXPECT_TRUE(trees_.cut(robot_.links[0], at(0.02)));
}

TEST_F(RobotTreesTest, TreesThatTheLastBuildsDidNotAskForGo) {
  const auto build_with = [&](double leaves) {
    options_.tree = lengthOf(leaves);
    build();
  };
  const auto is_held = [&](int link, double leaves) {
    LinkOptions options = at(0.02);
    options.tree = lengthOf(leaves);
    return trees_.cut(robot_.links[static_cast<std::size_t>(link)], options).has_value();
  };
  build_with(0.005);
  options_.links = "large";
  for (const double leaves : {0.006, 0.007, 0.008, 0.009}) {
    EXPECT_TRUE(is_held(1, 0.005)) << leaves;
    build_with(leaves);
  }
  EXPECT_FALSE(is_held(1, 0.005));
  EXPECT_TRUE(is_held(1, 0.006));
  EXPECT_TRUE(is_held(0, 0.005));  // of the link that no build touched
}

TEST_F(RobotTreesTest, TreesOfAFileThatWasEditedGo) {
  const auto write = [&](double radius) {
    fixtures::write(folder_ / "torus.obj", fixtures::obj(test_shapes::torus(radius, 0.03, 24, 12)));
  };
  build();
  write(0.11);
  build();
  write(0.1);
  options_.tree = lengthOf(0.006);
  build();
  EXPECT_TRUE(trees_.cut(robot_.links[0], at(0.02)));
  options_.tree = lengthOf(0.005);
  EXPECT_FALSE(trees_.cut(robot_.links[0], at(0.02))) << "of the first build";
}

TEST_F(RobotTreesTest, AMeshThatCouldNotBeReadIsReadWhereItIsNow) {
  fixtures::fs::create_directory(folder_ / "old");
  fixtures::fs::rename(folder_ / "torus.obj", folder_ / "old/torus.obj");
  robot_ = parseRobotDescription(
      R"(<robot name="r"><link name="l"><visual><geometry><mesh filename="package://p/torus.obj"/></geometry></visual></link></robot>)",
      folder_ / "r.urdf");
  const auto build_in = [&](const std::string& package, const StepCallback& step) {
    const PackageFinder finder([&](const std::string&) { return std::optional<std::string>(folder_ / package); });
    return trees_.build(robot_, finder, options_, {}, step).report.links.at(0).status;
  };
  const auto move = [&](const Step& step) {
    if (step.stage == "decompose" && fixtures::fs::exists(folder_ / "old")) fixtures::fs::rename(folder_ / "old", folder_ / "new");
  };
  EXPECT_EQ(Status::kFailed, build_in("old", move)) << "it has moved since it was found";
  EXPECT_EQ(Status::kOk, build_in("new", {}));
}

TEST_F(RobotTreesTest, SaysWhyThereIsNoCut) {
  const auto why = [&](const LinkOptions& options) { return trees_.whyNoCut(robot_.links[0], options); };
  EXPECT_EQ("no hull tree of 'torus.obj' is held", why(at(0.02)));
  build();
  LinkOptions options = at(0.004);
  EXPECT_EQ("its hull tree has leaves of 5 mm, and 4 mm is asked for", why(options));
  options = at(0.02);
  options.max_vertices = 0;
  EXPECT_EQ("its hull tree has max_vertices 64, and 0 (no limit) is asked for", why(options));
  options = at(0.02);
  options.effort = Effort::kBest;
  EXPECT_EQ("its hull tree has effort quick, and best is asked for", why(options));
  options = at(0.02);
  options.fill = true;
  EXPECT_EQ("its hull tree has fill false, and true is asked for", why(options));
  options = at(0.02);
  options.close_openings = 0.1;
  EXPECT_EQ("no hull tree of 'torus.obj' is held", why(options)) << "of the closed mesh";
  options = at(0.02);
  options.padding = 0.01;
  EXPECT_EQ("hulls with padding are not cut from hull trees", why(options));
  options = at(0.02);
  options.shapes = Shapes::kPrimitives;
  EXPECT_EQ("shapes 'primitives' are not cut from hull trees", why(options));
  options = at(0.02);
  options.method = Method::kSingleHull;
  EXPECT_EQ("method 'single_hull' has no hull tree", why(options));
}

TEST_F(RobotTreesTest, AMissingMeshIsAFailedRow) {
  fixtures::fs::remove(folder_ / "torus.obj");
  const RobotResult result = build();
  EXPECT_EQ(Status::kFailed, result.report.links.at(0).status);
  EXPECT_FALSE(trees_.cut(robot_.links[0], at(0.02)));
}

TEST_F(RobotTreesTest, ACancelledBuildCanBeDoneAgain) {
  RunControl control;
  control.cancel();
  EXPECT_THROW(build(control), Error);
  EXPECT_FALSE(trees_.cut(robot_.links[0], at(0.02)));
  build();
  EXPECT_TRUE(trees_.cut(robot_.links[0], at(0.02)));
}

}  // namespace
}  // namespace collision_hulls
