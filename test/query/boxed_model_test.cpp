#include "collision_hulls/query/boxed_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "query/query_model.h"
#include "random_points.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;
using Poses = std::vector<Eigen::Isometry3d>;

/// A random pose in a cube of this size.
Eigen::Isometry3d anyPose(RandomPoints& random, double size) {
  const Eigen::Translation3d place(random.inCube(size / 2));
  return place * Eigen::Isometry3d(random.rotation());
}

/// Elongated bodies of all kinds, around which boxes say little; each off the middle of its frame.
std::vector<QueryBody> bodies() {
  const Eigen::Isometry3d aside = Eigen::Translation3d(0.3, -0.2, 0.1) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  return {QueryBody(boxHull({0, 0, 0}, {1.2, 0.1, 0.2})),
          QueryBody(box(0.9, 0.2, 0.3)),
          QueryBody(uChannel(0.6, 0.6, 0.1, 1)),
          {{QueryShape::Kind::kBox, {1, 0.2, 0.1}}, aside},
          {{QueryShape::Kind::kCylinder, {0.1, 1, 0}}, aside},
          QueryBody(boxHull({-0.1, -0.1, -0.5}, {0.1, 0.1, 0.5}))};
}

TEST(BoxedModel, NothingTouchesNothing) {
  BoxedModel none, box;
  box.add(0, QueryBody(boxHull({0, 0, 0}, {1, 1, 1})));
  none.place({});
  box.place(posesAt({{0, 0, 0}}));
  for (BoxedModel* model : {&none, &box}) {
    EXPECT_FALSE(model->collides());
    EXPECT_EQ(model->distance(), std::numeric_limits<double>::infinity());
    EXPECT_FALSE(model->collides(none));
    EXPECT_EQ(model->distance(none), std::numeric_limits<double>::infinity());
  }
  EXPECT_FALSE(none.collides(box));
  EXPECT_EQ(none.distance(box), std::numeric_limits<double>::infinity());
}

TEST(BoxedModel, ItsOwnLinks) {
  IgnoredPairs ignored(4);
  const auto chain = [&] {
    BoxedModel model(ignored);
    for (std::size_t link = 0; link < 4; ++link) model.add(link, QueryBody(boxHull({0, 0, 0}, {1, 1, 1})));
    model.add(3, QueryBody(boxHull({0.5, 0, 0}, {1.5, 1, 1})));  // overlaps its own link's other body, which does not count
    model.place(posesAt({{0, 0, 0}, {0.5, 0, 0}, {3, 0, 0}, {4.25, 0, 0}}));
    return model;
  };
  EXPECT_TRUE(chain().collides());
  EXPECT_EQ(chain().distance(), 0);
  ignored.ignore(1, 0);
  EXPECT_FALSE(chain().collides());
  EXPECT_NEAR(chain().distance(), 0.25, 1e-9);
  ignored.ignore(2, 3);
  EXPECT_NEAR(chain().distance(), 1.5, 1e-9);
}

TEST(BoxedModel, ASceneMayMoveAndHaveIgnoredPairs) {
  IgnoredPairs ignored(3);  // one link, two scene objects
  BoxedModel scene;
  for (std::size_t thing = 1; thing < 3; ++thing) scene.add(thing, QueryBody(boxHull({0, 0, 0}, {1, 1, 1})));
  const auto robot = [&] {
    BoxedModel model(ignored);
    model.add(0, QueryBody(box(0.1, 0.1, 0.1)));
    model.place(posesAt({{1.5, 0.2, 0.2}}));
    return model;
  };
  scene.place(posesAt({{0, 0, 0}, {0, 0, 0}, {3, 0, 0}}));
  EXPECT_FALSE(robot().collides(scene));
  EXPECT_NEAR(robot().distance(scene), 0.5, 1e-9);
  scene.place(posesAt({{0, 0, 0}, {0, 0, 0}, {1.55, 0, 0}}));
  EXPECT_TRUE(robot().collides(scene));
  EXPECT_EQ(robot().distance(scene), 0);
  ignored.ignore(0, 2);
  EXPECT_FALSE(robot().collides(scene));
  EXPECT_NEAR(robot().distance(scene), 0.5, 1e-9);
}

struct Placed {
  std::size_t part;
  QueryBody body;
  Eigen::Isometry3d origin;
};

/// Compares every pair of bodies of links, or of links and a scene's objects, that is not ignored.
double leastDistance(const std::vector<Placed>& bodies, std::size_t links, bool of_scene, const IgnoredPairs& ignored, const Poses& poses) {
  double least = std::numeric_limits<double>::infinity();
  for (const Placed& a : bodies)
    for (const Placed& b : bodies)
      if (a.part < links && a.part < b.part && (b.part >= links) == of_scene && !ignored(a.part, b.part))
        least = distanceBelow(least, a.body, b.body, (poses[a.part] * a.origin).inverse() * poses[b.part] * b.origin);
  return least;
}

TEST(BoxedModel, AgreesWithFclsDynamicTrees) {
  RandomPoints random(1);
  const std::vector<QueryBody> all = bodies();
  const std::size_t links = 8, things = 12;
  IgnoredPairs ignored(links + things);
  for (std::size_t link = 1; link < links; ++link) ignored.ignore(link - 1, link);
  for (std::size_t thing = links; thing < links + 6; ++thing) ignored.ignore(2, thing);
  BoxedModel robot(ignored), scene;
  QueryModel robot_tree, scene_tree;
  std::vector<Placed> bodies;
  for (std::size_t part = 0; part < links + things; ++part) {
    for (const std::size_t other : {part, 3 * part + 1}) {
      bodies.push_back({part, all[other % all.size()], anyPose(random, 0.5)});
      (part < links ? robot : scene).add(part, bodies.back().body, bodies.back().origin);
      (part < links ? robot_tree : scene_tree).add(part, bodies.back().body, bodies.back().origin);
    }
  }
  std::size_t own = 0, hits = 0;
  Poses poses(links + things);
  for (int state = 0; state < 300; ++state) {
    const bool moves = state % 10 == 0;
    for (std::size_t part = 0; part < (moves ? links + things : links); ++part) poses[part] = anyPose(random, part < links ? 4 : 8);
    robot.place(poses);
    robot_tree.place(poses);
    if (moves) {
      scene.place(poses);
      scene_tree.place(poses);
    }
    ASSERT_EQ(robot.collides(), robot_tree.collides(ignored)) << state;
    ASSERT_EQ(robot.collides(scene), robot_tree.collides(scene_tree, ignored)) << state;
    ASSERT_NEAR(robot.distance(), leastDistance(bodies, links, false, ignored, poses), 1e-6) << state;
    ASSERT_NEAR(robot.distance(scene), leastDistance(bodies, links, true, ignored, poses), 1e-6) << state;
    for (const double limit : {0.1, 1.0}) {
      ASSERT_EQ(robot.distance(limit), std::min(limit, robot.distance())) << state;
      ASSERT_EQ(robot.distance(scene, limit), std::min(limit, robot.distance(scene))) << state;
    }
    own += robot.collides();
    hits += robot.collides(scene);
  }
  EXPECT_GT(own, 30U);
  EXPECT_LT(own, 270U);
  EXPECT_GT(hits, 30U);
  EXPECT_LT(hits, 270U);
}

TEST(BoxedModel, RejectsQueriesItCannotAnswer) {
  const auto codeOf = [](const auto& ask) {
    try {
      ask();
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kCancelled;
  };
  const QueryBody cube(boxHull({0, 0, 0}, {1, 1, 1}));
  BoxedModel model, scene;
  model.add(1, cube);
  EXPECT_EQ(codeOf([&] { model.collides(); }), ErrorCode::kInternal);
  EXPECT_EQ(codeOf([&] { model.place(posesAt({{0, 0, 0}})); }), ErrorCode::kIndexOutOfRange);
  EXPECT_EQ(codeOf([&] { model.collides(scene); }), ErrorCode::kInternal) << "still not placed";
  Poses poses = posesAt({{0, 0, 0}, {0, 0, 0}});
  model.place(poses);
  EXPECT_FALSE(model.collides(scene));
  poses[1].translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(codeOf([&] { model.place(poses); }), ErrorCode::kNonFiniteCoordinate);
  EXPECT_EQ(codeOf([&] { model.add(0, cube, poses[1]); }), ErrorCode::kNonFiniteCoordinate);
  model.place(posesAt({{0, 0, 0}, {0, 0, 0}}));
  scene.add(2, cube);
  EXPECT_EQ(codeOf([&] { model.distance(scene); }), ErrorCode::kInternal);
  scene.place(posesAt({{0, 0, 0}, {0, 0, 0}, {0.5, 0, 0}}));
  EXPECT_TRUE(model.collides(scene));
  model.add(1, cube, Eigen::Isometry3d(Eigen::Translation3d(5, 0, 0)));
  EXPECT_EQ(codeOf([&] { model.distance(); }), ErrorCode::kInternal);
  EXPECT_EQ(codeOf([] { IgnoredPairs(2).ignore(0, 2); }), ErrorCode::kIndexOutOfRange);
}

TEST(BoxedModel, BoxesAreApartIfFclSaysSo) {
  RandomPoints random(2);
  std::size_t apart_count = 0, along_edges = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto half = [&]() -> Eigen::Vector3d { return Eigen::Vector3d(0.05, 0.05, 0.05) + 0.95 * random.inCube().cwiseAbs(); };
    const Eigen::Vector3d a = half(), b = half();
    const Eigen::AlignedBox3d first(-a, a), second(b, 2 * b);
    const Eigen::Isometry3d pose = anyPose(random, 4);
    const QueryBody of_first(boxHull(first.min(), first.max())), of_second(boxHull(second.min(), second.max()));
    const bool are_apart = apart(first, second, pose);
    ASSERT_EQ(are_apart, !touch(of_first, of_second, pose)) << i;
    ASSERT_EQ(are_apart, apart(second, first, pose.inverse())) << i;
    apart_count += are_apart;
    along_edges += are_apart && first.intersects(placed(second, pose)) && second.intersects(placed(first, pose.inverse()));
  }
  EXPECT_GT(apart_count, 1000U);
  EXPECT_GT(along_edges, 20U) << "pairs that no face of a box separates";
}

TEST(BoxedModel, JudgesNearlyParallelBoxesCorrectly) {
  // Poses rounded to single precision: edges cross at angles that are mere rounding.
  RandomPoints random(3);
  const Eigen::AlignedBox3d bar(Eigen::Vector3d(-0.5, -0.05, -0.05), Eigen::Vector3d(0.5, 0.05, 0.05));
  for (int i = 0; i < 3000; ++i) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (int k = 0; k < 9; ++k) pose.linear()(k / 3, k % 3) += random.number(-2e-7, 2e-7);
    pose.translation() = random.inBox({Eigen::Vector3d(-0.999, -0.0999, -0.0999), Eigen::Vector3d(0.999, 0.0999, 0.0999)});
    ASSERT_FALSE(apart(bar, bar, pose)) << i;
    pose.translation().y() = 0.1001;
    ASSERT_TRUE(apart(bar, bar, pose)) << i;
  }
}

}  // namespace
}  // namespace collision_hulls
