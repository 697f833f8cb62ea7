// Fits of a sliding channel to simple scenes, where the number and kind of bodies that a scene needs are known.
// Also tests src/fit/comparison.cpp, src/fit/fitting.cpp, src/fit/pair_rules.cpp and src/fit/planner_model.cpp.
#include "collision_hulls/fit/fit.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "collision_hulls/error.h"
#include "collision_hulls/measure/measures.h"
#include "fit/fit_fixtures.h"
#include "fit/fit_report.h"

namespace collision_hulls {
namespace {

using namespace fit_fixtures;

ErrorCode errorOf(const FitProblem& problem, const FitOptions& options, const RunControl& control = {}) {
  try {
    fitScene(problem, options, control);
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return ErrorCode::kInternal;
}

TEST(FitScene, RejectsInvalidOptionsAndProblems) {
  FitProblem problem = overPost();
  EXPECT_EQ(errorOf(problem, fitOptions(0)), ErrorCode::kBadOption);
  EXPECT_EQ(errorOf(problem, fitOptions(-0.01)), ErrorCode::kBadOption);
  EXPECT_EQ(errorOf(problem, fitOptions(std::numeric_limits<double>::quiet_NaN())), ErrorCode::kBadOption);
  EXPECT_EQ(errorOf(problem, fitOptions(0.01, 0)), ErrorCode::kBadOption);
  EXPECT_NO_THROW(check(fitOptions(0.01, 10'000'000)));
  EXPECT_THROW(check(fitOptions(0.01, 10'000'001)), Error);  // before it takes the memory
  problem.elements.clear();
  EXPECT_EQ(errorOf(problem, fitOptions()), ErrorCode::kBadOption);
}

TEST(FitScene, RefusesMorePairsThanItCanHold) {
  FitProblem problem;
  problem.robot = carriages(2001);
  for (std::size_t link = 1; link <= 2001; ++link)
    problem.elements.push_back({"c" + std::to_string(link), link, Eigen::Isometry3d::Identity(), channelMesh()});
  EXPECT_EQ(errorOf(problem, fitOptions()), ErrorCode::kTooLarge);
}

TEST(FitScene, CancelledAtOnce) {
  RunControl control;
  control.cancel();
  EXPECT_EQ(errorOf(overPost(), fitOptions(), control), ErrorCode::kCancelled);
}

TEST(FitScene, EmptySceneLeavesOneHull) {
  FitProblem problem = overPost();
  problem.scene.bodies.clear();
  const SceneFit fit = fitScene(problem, fitOptions());
  ASSERT_EQ(fit.elements.size(), 1u);
  EXPECT_EQ(fit.elements[0].hulls.size(), 1u);
  ASSERT_EQ(fit.report.links.size(), 1u);
  EXPECT_TRUE(fit.report.links[0].proved);
  EXPECT_EQ(fit.report.links[0].link, "c0");
}

TEST(FitScene, PostInTheGapOpensTheHull) {
  const FitProblem problem = overPost();
  const SceneFit fit = fitScene(problem, fitOptions());
  EXPECT_EQ(fit.elements[0].hulls.size(), 3u);
  EXPECT_EQ(uncovered(problem.elements[0].mesh->original, fit.elements[0].hulls), 0);
  EXPECT_GT(fit.report.counterexamples, 0u);
  EXPECT_EQ(fit.report.missed, 0u);
  EXPECT_EQ(fit.report.phantom, 0u);
  EXPECT_EQ(fit.report.original_hits, 0u);
  EXPECT_NEAR(fit.report.phantom_rate_bound, 3.69 / 1000, 1e-5);  // by the first batch
  EXPECT_FALSE(fit.report.links[0].proved);
  EXPECT_EQ(fit.report.links[0].reason.substr(0, 22), "3 boxes: against post ") << fit.report.links[0].reason;
}

TEST(FitScene, UsesABoxWhereItSuffices) {
  FitProblem problem = overPost();
  problem.scene.bodies[0].pose.translation().x() += 0.5;  // beside the channel, beyond the clearance
  const SceneFit fit = fitScene(problem, fitOptions());
  ASSERT_EQ(fit.elements[0].primitives.size(), 1u);
  const GeometryElement& box = fit.elements[0].primitives[0];
  EXPECT_EQ(box.kind, GeometryElement::Kind::kBox);
  EXPECT_NEAR(box.size.prod(), 0.4 * 0.3 * 1, 1e-4);
  EXPECT_EQ(fit.elements[0].cut.size(), 1u);
  ASSERT_EQ(fit.elements[0].hulls.size(), 1u);
  EXPECT_EQ(uncovered(problem.elements[0].mesh->original, fit.elements[0].hulls), 0);
  EXPECT_EQ(fit.report.links[0].primitive, "box");
  EXPECT_EQ(fit.report.links[0].hulls, 0u);
  EXPECT_EQ(fit.report.primitives, 1u);

  FitOptions hulls_only = fitOptions();
  hulls_only.primitives = false;
  const SceneFit hull = fitScene(problem, hulls_only);
  EXPECT_TRUE(hull.elements[0].primitives.empty());
  EXPECT_EQ(hull.report.links[0].hulls, 1u);
}

/// A carriage with a mesh, and a post.
FitProblem carriageBeside(const TriangleMesh& mesh, const Eigen::Vector3d& post) {
  FitProblem problem = overPost();
  problem.elements[0].mesh = fitMesh(mesh);
  problem.scene.bodies[0] = boxBody("post", Eigen::Vector3d::Constant(0.1), post);
  return problem;
}

TEST(FitScene, SphereForABall) {
  const SceneFit fit = fitScene(carriageBeside(test_shapes::sphere(0.2, 8), {0.27, 0, 0}), fitOptions());
  ASSERT_EQ(fit.elements[0].primitives.size(), 1u);
  EXPECT_EQ(fit.elements[0].primitives[0].kind, GeometryElement::Kind::kSphere);
  EXPECT_NEAR(fit.elements[0].primitives[0].size.x(), 0.2, 0.02);  // the hull, of 64 vertices, reaches further out than the ball
  EXPECT_EQ(fit.report.links[0].primitive, "sphere");
  EXPECT_EQ(fit.report.links[0].reason.substr(0, 10), "1 sphere: ");
  EXPECT_EQ(fit.report.missed + fit.report.phantom, 0u);
}

/// A round carriage among posts all around it, 2 cm away: a box around it touches them whichever way it is turned.
FitProblem roundAmongPosts() {
  const double radius = 0.2, out = radius + 0.02 + 0.05;
  FitProblem problem = carriageBeside(surface(cylinderShape(radius, 1)), {out, 0, 0});
  for (int i = 1; i < 8; ++i) {
    const double angle = EIGEN_PI / 4 * i;
    SceneBody post{"post" + std::to_string(i), boxShape(Eigen::Vector3d::Constant(0.1))};
    post.pose = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * Eigen::Translation3d(out, 0, 0);
    problem.scene.bodies.push_back(post);
  }
  return problem;
}

TEST(FitScene, UsesACylinderWhereTheBoxTouches) {
  const SceneFit fit = fitScene(roundAmongPosts(), fitOptions());
  ASSERT_EQ(fit.elements[0].primitives.size(), 1u);
  EXPECT_EQ(fit.elements[0].primitives[0].kind, GeometryElement::Kind::kCylinder);
  EXPECT_NEAR(fit.elements[0].primitives[0].size.x(), 0.2, 1e-3);
  EXPECT_EQ(fit.report.missed + fit.report.phantom, 0u);
  EXPECT_EQ(fit.report.links[0].reason.substr(0, 25), "1 cylinder: never within ") << fit.report.links[0].reason;
}

TEST(FitScene, TakesBackABoxEvenIfTheOriginalIsNearerThanTheClearance) {
  const SceneFit fit = fitScene(roundAmongPosts(), fitOptions(0.04));
  ASSERT_EQ(fit.elements[0].primitives.size(), 1u);
  EXPECT_EQ(fit.elements[0].primitives[0].kind, GeometryElement::Kind::kCylinder);
  EXPECT_EQ(fit.report.model_hits, 0u);
}

TEST(FitScene, EachPrimitiveReplacesOneHull) {
  FitOptions options = fitOptions(0.01, 200);
  options.compare = true;
  for (const FitProblem& problem : {overPost(), roundAmongPosts()}) {
    const SceneFit fit = fitScene(problem, options);
    const auto row = [&](const std::string& model) {
      const auto found =
          std::find_if(fit.report.models.begin(), fit.report.models.end(), [&](const ModelRow& r) { return r.model == model; });
      return found == fit.report.models.end() ? ModelRow() : *found;
    };
    EXPECT_GT(fit.report.primitives, 0u);
    EXPECT_GT(row("fitted").hulls, 0u);
    EXPECT_EQ(row("fitted").hulls, row("fitted_hulls").hulls);
    EXPECT_EQ(row("fitted").false_hits, row("fitted_hulls").false_hits);
  }
}

TEST(FitScene, ProvesAFarPostAway) {
  FitProblem problem = overPost();
  problem.scene.bodies[0].pose.translation().x() += 3;
  const SceneFit fit = fitScene(problem, fitOptions());
  EXPECT_EQ(fit.elements[0].hulls.size(), 1u);
  EXPECT_EQ(fit.report.proved_pairs, 1u);
  EXPECT_TRUE(fit.report.links[0].proved);
  EXPECT_NE(fit.report.links[0].reason.find("never within"), std::string::npos) << fit.report.links[0].reason;
}

TEST(FitScene, RefusesAConfigurationOfAnotherSize) {
  FitProblem problem = overPost();
  problem.configurations = {{0}, {}};
  EXPECT_EQ(errorOf(problem, fitOptions()), ErrorCode::kBadOption);
  problem.configurations = {{0, 0}};
  EXPECT_EQ(errorOf(problem, fitOptions()), ErrorCode::kBadOption);
}

TEST(FitScene, WallThatTheOriginalHitsAnywayNeedsOneHullOnly) {
  FitProblem problem = overPost();
  const Eigen::AlignedBox3d box = boundingBox(channel());
  problem.scene.bodies[0] = boxBody("wall", {1, 1, 0.1}, {0, 0, box.max().z() + 1});
  const SceneFit fit = fitScene(problem, fitOptions());
  EXPECT_EQ(fit.elements[0].hulls.size(), 1u);
  EXPECT_GT(fit.report.original_hits, 0u);
  EXPECT_EQ(fit.report.missed, 0u);
}

TEST(FitScene, GapNarrowerThanTheClearanceStillCounts) {
  // The post is never as far from the channel as the clearance, so half of their usual distance counts.
  FitProblem problem = overPost();
  problem.robot = carriages(1, 0.2);
  const SceneFit fit = fitScene(problem, fitOptions(5));
  EXPECT_EQ(fit.elements[0].hulls.size(), 3u);
  ASSERT_FALSE(fit.report.notes.empty());
  EXPECT_NE(
      fit.report.notes[0].find("1 pair is hardly ever 5 m apart, and counts as clear from half of its usual distance on: c0 and post ("),
      std::string::npos)
      << fit.report.notes[0];
}

TEST(FitScene, ChecksAFixedBodyNearerThanTheClearance) {
  FitProblem problem = overPost();
  problem.elements[0].link = 0;  // the base itself is the channel: the post is 9 cm from its walls, whatever the joint does
  const SceneFit fit = fitScene(problem, fitOptions(0.1));
  EXPECT_EQ(fit.elements[0].hulls.size(), 3u);
  EXPECT_TRUE(fit.report.left_out.empty());
  problem.scene.bodies[0] = boxBody("wall", {1, 1, 1}, Eigen::Vector3d::Zero());
  const SceneFit within = fitScene(problem, fitOptions(0.1));
  ASSERT_EQ(within.report.left_out.size(), 1u);
  EXPECT_EQ(within.report.left_out[0].reason, "Fixed");
  EXPECT_FALSE(within.report.links[0].proved);
}

TEST(FitScene, LinkWithAPairLeftOutIsNotProvedAwayFromEverything) {
  FitProblem problem = overPost();
  problem.scene.bodies[0].pose.translation().x() += 3;
  problem.scene.bodies.push_back(boxBody("track", {2, 0.5, 6}, boundingBox(channel()).min()));  // always in contact
  const SceneFit fit = fitScene(problem, fitOptions());
  EXPECT_FALSE(fit.report.links[0].proved);
  EXPECT_NE(fit.report.links[0].reason.find("of anything but track, proved"), std::string::npos) << fit.report.links[0].reason;
  const auto track = std::find_if(fit.report.left_out.begin(), fit.report.left_out.end(),
                                  [](const LeftOutPair& pair) { return pair.first == "c0" && pair.second == "track"; });
  ASSERT_NE(track, fit.report.left_out.end());
  EXPECT_EQ(track->known, "in contact in 400 of 400 samples");
}

TEST(FitScene, CapOnHullsHolds) {
  FitProblem problem = overPost();
  const auto mesh = std::make_shared<FitMesh>(*problem.elements[0].mesh);
  mesh->max_hulls = 2;
  problem.elements[0].mesh = mesh;
  const SceneFit fit = fitScene(problem, fitOptions());
  EXPECT_LE(fit.elements[0].hulls.size(), 2u);
  EXPECT_GT(fit.report.phantom, 0u);
  EXPECT_GT(fit.report.phantom_rate_bound, 0.1);
}

TEST(FitScene, ARateIsBoundByOne) {
  FitProblem problem = overPost();
  problem.scene.bodies.clear();
  EXPECT_EQ(fitScene(problem, fitOptions(0.01, 2)).report.phantom_rate_bound, 1);  // of none in two, the Poisson limit is 1.84
}

TEST(FitScene, ReportsATreeThatIsTooCoarse) {
  FitProblem problem = overPost();
  problem.elements[0].mesh = fitMesh(channel(), 1);
  const SceneFit fit = fitScene(problem, fitOptions());
  EXPECT_EQ(fit.elements[0].hulls.size(), 1u);
  EXPECT_EQ(fit.report.leaf_contacts, fit.report.phantom);
  EXPECT_GT(fit.report.leaf_contacts, 0u);
  EXPECT_EQ(fit.report.leaf_contact.substr(0, 16), "c0 against post ") << fit.report.leaf_contact;
}

TEST(FitScene, FitsToGivenConfigurationsOnly) {
  FitProblem problem = overPost();
  problem.configurations = {{1.9}, {1.95}, {2.0}};  // the channel, which extends half a metre either way, is beyond the post
  const SceneFit away = fitScene(problem, fitOptions());
  EXPECT_EQ(away.elements[0].hulls.size(), 1u);
  EXPECT_TRUE(away.report.given);
  EXPECT_EQ(away.report.samples, 3u);
  EXPECT_EQ(away.report.phantom_rate_bound, 0);
  problem.configurations.push_back({0.0});
  EXPECT_EQ(fitScene(problem, fitOptions()).elements[0].hulls.size(), 3u);
}

TEST(FitScene, AdjacentDisabledAndTouchingLinksAreLeftOut) {
  FitProblem problem;
  problem.robot = carriages(3);
  const auto mesh = fitMesh(test_shapes::box(0.1, 0.1, 0.1));
  for (std::size_t link = 1; link <= 3; ++link) {
    const Eigen::Vector3d place(link == 3 ? 0.08 : 0.0, link == 2 ? 1 : 0, 0);  // the third overlaps the first at rest
    problem.elements.push_back({"", link, Eigen::Isometry3d(Eigen::Translation3d(place)), mesh});
  }
  problem.disabled.push_back({"c1", "c0", "User", ""});
  const SceneFit fit = fitScene(problem, fitOptions());
  ASSERT_EQ(fit.report.left_out.size(), 2u);
  EXPECT_EQ(fit.report.left_out[0].reason, "Disabled");
  EXPECT_EQ(fit.report.left_out[1].reason, "Default");
  EXPECT_EQ(fit.report.left_out[1].second, "c2");
  EXPECT_EQ(fit.report.proved_pairs, 1u);
  ASSERT_EQ(fit.disabled.size(), 3u);
  EXPECT_EQ(fit.disabled[0].reason, "User");
  EXPECT_EQ(fit.disabled[1].reason, "Default");
  EXPECT_EQ(fit.disabled[2].reason, "Never");
  EXPECT_NE(fit.disabled[2].known.find("proved"), std::string::npos);
}

TEST(FitScene, GivenOrFewSamplesAloneDisableNoPair) {
  // Two blocks that slide past each other, and collide where both are in the middle.
  FitProblem problem;
  problem.robot = carriages(2);
  const auto mesh = fitMesh(test_shapes::box(0.1, 0.1, 0.1));
  for (const std::size_t link : {1, 2})
    problem.elements.push_back({"", link, Eigen::Isometry3d(Eigen::Translation3d(0, 0, link == 2 ? 1 : 0)), mesh});
  problem.configurations = {{1, 1}, {0.5, 0.5}};
  EXPECT_TRUE(fitScene(problem, fitOptions()).disabled.empty());
  problem.configurations = {{1, 0}, {0.5, -0.5}};  // in contact in all of them
  const SceneFit in_contact = fitScene(problem, fitOptions());
  EXPECT_TRUE(in_contact.disabled.empty());
  ASSERT_EQ(in_contact.report.left_out.size(), 1u);
  EXPECT_EQ(in_contact.report.left_out[0].known, "in contact in 2 of 2 given configurations");
  problem.configurations.clear();
  EXPECT_TRUE(fitScene(problem, fitOptions(0.01, 1)).disabled.empty());
}

TEST(FitScene, ProvesNothingAcrossAFloatingJoint) {
  FitProblem problem;
  const std::string joint = "<joint name='f' type='floating'><parent link='a'/><child link='b'/><origin xyz='3 0 0'/></joint>";
  const std::string fixed = "<joint name='g' type='fixed'><parent link='b'/><child link='c'/><origin xyz='3 0 0'/></joint>";
  const std::string turns = "<joint name='h' type='continuous'><parent link='c'/><child link='d'/><origin xyz='3 0 0'/></joint>";
  problem.robot = parseRobotDescription("<robot name='r'><link name='a'/><link name='b'/><link name='c'/><link name='d'/>" + joint + fixed +
                                        turns + "</robot>");
  const auto mesh = fitMesh(test_shapes::box(0.1, 0.1, 0.1));
  for (const std::size_t link : {0, 3}) problem.elements.push_back({"", link, Eigen::Isometry3d::Identity(), mesh});
  const SceneFit fit = fitScene(problem, fitOptions(0.01, 20'000));
  EXPECT_EQ(fit.report.pairs, 1u);
  EXPECT_EQ(fit.report.proved_pairs, 0u);
  EXPECT_FALSE(fit.report.links[0].proved);
  EXPECT_TRUE(fit.disabled.empty());
}

TEST(FitScene, AComponentInsideALinkCountsInAnyOrder) {
  const auto mesh = fitMesh(test_shapes::box(1, 1, 1));
  const TriangleMesh within = test_shapes::moved(test_shapes::box(0.1, 0.1, 0.1), {0.4, 0.4, 0.4});
  const TriangleMesh beside = test_shapes::moved(test_shapes::box(0.1, 0.1, 0.1), {1.5, 0.4, 0.4});
  for (const bool first : {true, false}) {
    FitProblem problem;
    problem.robot = carriages(1, 0.01);
    problem.elements.push_back({"", 1, Eigen::Isometry3d::Identity(), mesh});
    SceneBody body = boxBody("two", {1, 1, 1}, Eigen::Vector3d::Zero());
    body.shape = first ? test_shapes::merged({within, beside}) : test_shapes::merged({beside, within});
    problem.scene.bodies.push_back(body);
    const SceneFit fit = fitScene(problem, fitOptions(0.01, 10));
    ASSERT_EQ(fit.report.left_out.size(), 1u) << first;
    EXPECT_EQ(fit.report.left_out[0].reason, "Always");
  }
}

TEST(FitScene, SelfCollisionTableCountsBeforeAndAfter) {
  // A block that slides through the channel's gap: it collides with the single hull wherever the two are side by side.
  FitProblem problem = overPost();
  problem.scene.bodies.clear();
  problem.robot = carriages(2);
  problem.elements.push_back({"c1/0", 2, Eigen::Isometry3d(Eigen::Translation3d(gap())),
                              fitMesh(test_shapes::moved(test_shapes::box(0.1, 0.1, 0.1), {-0.05, -0.05, -0.05}))});
  const SceneFit fit = fitScene(problem, fitOptions());
  EXPECT_EQ(fit.elements[0].hulls.size(), 3u);
  EXPECT_EQ(fit.elements[1].hulls.size(), 1u);
  ASSERT_EQ(fit.report.self.size(), 1u);
  EXPECT_EQ(fit.report.self[0].original, 0u);
  EXPECT_EQ(fit.report.self[0].after, 0u);
  // Both slide by 2 m either way; the block, 0.1 m long, and the channel, 1 m long, overlap with probability 1.1 / 4 - 1.1^2 / 64.
  EXPECT_NEAR(static_cast<double>(fit.report.self[0].before) / 1000, 1.1 / 4 - 1.1 * 1.1 / 64, 0.05);
}

TEST(FitScene, IsTheSameForAnyNumberOfThreads) {
  const FitProblem problem = overPost();
  SceneFit one, two;
  tbb::task_arena(1).execute([&] { one = fitScene(problem, fitOptions()); });
  tbb::task_arena(2).execute([&] { two = fitScene(problem, fitOptions()); });
  EXPECT_EQ(one.elements[0].cut, two.elements[0].cut);
  EXPECT_EQ(one.report.counterexamples, two.report.counterexamples);
  EXPECT_EQ(one.report.asked, two.report.asked);
  EXPECT_EQ(one.report.links[0].reason, two.report.links[0].reason);
}

TEST(FitScene, ComparesTheFittedModelWithOthers) {
  FitOptions options = fitOptions(0.01, 200);
  options.compare = true;
  const SceneFit fit = fitScene(overPost(), options);
  const auto row = [&](const std::string& model) {
    for (const ModelRow& candidate : fit.report.models)
      if (candidate.model == model) return candidate;
    ADD_FAILURE() << "no row " << model;
    return ModelRow();
  };
  EXPECT_EQ(row("original").phantom + row("original").missed, 0u);
  EXPECT_GT(row("single_hull").phantom, 0u);
  EXPECT_EQ(row("single_hull").hulls, 1u);
  EXPECT_EQ(row("fitted").hulls, 3u);
  EXPECT_EQ(row("fitted").phantom + row("fitted").missed, 0u);
  EXPECT_EQ(row("uniform_adequate").phantom, 0u);
  EXPECT_EQ(row("uniform_adequate").hulls, 3u);
  EXPECT_GT(row("fitted").collision_us, 0);
  EXPECT_EQ(fit.report.clear, row("fitted").clear);
  EXPECT_EQ(fit.report.clear_of, 200u);
  EXPECT_GT(fit.report.clear, 0u);
}

/// The k-th batch may err with a probability of 5 % / 2^k.
TEST(RateBound, OfLaterBatchesIsLarger) {
  double risk = 0;
  for (std::size_t batch = 1; batch <= 13; ++batch) {
    risk += std::exp(-1000 * rateBound(0, 1000, batch));  // Poisson: of none where the mean is the bound's
    EXPECT_LE(risk, 0.05);
  }
  EXPECT_GT(risk, 0.0499);
  EXPECT_NEAR(rateBound(2, 1000, 3), upperBound(2, 0.05 / 8) / 1000, 1e-12);
  EXPECT_EQ(rateBound(5, 5, 1), 1);
}

/// Few samples find counterexamples late, so that the first batch is hardly ever the last.
TEST(FitScene, CountsTheBatchesThatItTriedToVerifyBy) {
  const FitProblem problem = overPost();
  FitOptions options = fitOptions(0.01, 20);
  options.primitives = false;
  const FitReport report = fitScene(problem, options).report;
  EXPECT_EQ(report.phantom, 0u);
  EXPECT_NEAR(report.phantom_rate_bound, rateBound(0, 20, 2), 1e-12);
}

TEST(UpperBound, OfThePoissonDistribution) {
  EXPECT_NEAR(upperBound(0, 0.05), 2.9957, 1e-3);
  EXPECT_NEAR(upperBound(1, 0.05), 4.7439, 1e-3);
  EXPECT_NEAR(upperBound(10, 0.05), 16.962, 1e-2);
  EXPECT_NEAR(upperBound(700, 0.05), 745.111, 1e-2);
  EXPECT_NEAR(upperBound(1000, 0.05), 1053.60, 1e-2);
  EXPECT_NEAR(upperBound(10'000'000, 0.05), 10'005'203, 1);
}

}  // namespace
}  // namespace collision_hulls
