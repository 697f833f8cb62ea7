// Queries over configurations: what is counted, and that bounds which are wrong are found out.
#include "verify/trials.h"

#include <gtest/gtest.h>

#include "counted_looks.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

/// A link whose original is a cube and whose result is a smaller or larger one.
struct Cube {
  explicit Cube(double scale) {
    GeometryElement cube;
    cube.kind = Kind::kBox;
    cube.size = {0.2, 0.2, 0.2};
    original.primitives = {cube};
    cube.size *= scale;
    result.primitives = {cube};
    pair = std::make_unique<LinkPair>(original, result);
    row.diagonal = diagonal(pair->surface());
    pair->measure(row);
  }
  LinkBodies original, result;
  std::unique_ptr<LinkPair> pair;
  LinkVerification row;
};

Kinematics twoLinks() {
  RobotDescription robot;
  robot.links.resize(3);
  const char* const names[] = {"a", "b", "c"};
  for (std::size_t i = 0; i < 3; ++i) robot.links[i].name = names[i];
  for (std::size_t i = 1; i < 3; ++i) {
    JointDescription joint;
    joint.name = std::string("to_") + names[i];
    joint.kind = JointDescription::Kind::kRevolute;
    joint.parent = names[i - 1];
    joint.child = names[i];
    joint.origin = Eigen::Translation3d(0.15, 0, 0);
    joint.axis = Eigen::Vector3d::UnitZ();
    joint.lower = -3;
    joint.upper = 3;
    robot.joints.push_back(joint);
    robot.links[i].parent = names[i - 1];
  }
  return Kinematics(robot);
}

Trials trialsOf(const Cube& cube) {
  return tryConfigurations(twoLinks(), {{0, cube.pair.get(), &cube.row}, {2, cube.pair.get(), &cube.row}}, 400, 1);
}

TEST(Trials, ACancelledRunHasNoResult) {
  const Cube cube(1);
  const RunControl control;
  control.cancel();
  EXPECT_THROW(tryConfigurations(twoLinks(), {{0, cube.pair.get(), &cube.row}}, 0, 1, control), Error);
}

TEST(Trials, FclLooksAtTheControlForEachNodeOfItsTrees) {
  const TriangleMesh ring = test_shapes::torus(0.3, 0.1, 30, 20);
  LinkBodies bodies;
  bodies.meshes.push_back({ring, convexParts(ring)});
  LinkPair pair(bodies, bodies);
  LinkVerification row;
  row.diagonal = diagonal(pair.surface());
  pair.measure(row);
  const std::size_t looks = looksOf([&](const RunControl& control) { tryConfigurations(twoLinks(), {{0, &pair, &row}}, 0, 1, control); });
  EXPECT_GE(looks, 2 * (2 * ring.triangles.size() - 1)) << "of the original and of the result";
}

TEST(Trials, ASmallerModelMissesAndALargerOneIsHitTooOften) {
  const Trials small = trialsOf(Cube(0.9)), large = trialsOf(Cube(1.1));
  EXPECT_GT(small.all.missed, 0u);
  EXPECT_EQ(small.all.phantom, 0u);
  EXPECT_EQ(large.all.missed, 0u);
  EXPECT_GT(large.all.phantom, 0u);
  EXPECT_EQ(small.contradictions + large.contradictions, 0u);
  EXPECT_EQ(small.all.queries, 400u * 3);  // the pair, and the box with each link
  EXPECT_EQ(small.of_link[0].queries, 400u * 2);
  EXPECT_GT(small.all.hits, small.all.missed);
}

TEST(Trials, EveryConfigurationCountsWhateverTheirNumber) {
  const Cube cube(0.9);
  const std::vector<TrialLink> links = {{0, cube.pair.get(), &cube.row}, {2, cube.pair.get(), &cube.row}};
  const Trials thousand = tryConfigurations(twoLinks(), links, 1000, 1), more = tryConfigurations(twoLinks(), links, 2500, 1);
  EXPECT_EQ(more.all.queries, 2500u * 3);
  EXPECT_GT(more.all.hits, 2 * thousand.all.hits);
  EXPECT_LT(more.all.hits, 3 * thousand.all.hits);
  EXPECT_GT(more.of_link[1].missed, 2 * thousand.of_link[1].missed);
  const Trials few = tryConfigurations(twoLinks(), links, 500, 1);
  EXPECT_NE(more.all.hits, 2 * thousand.all.hits + few.all.hits) << "the same configurations again";
}

TEST(Trials, CountsEachPairOfLinksWithoutTheBoxes) {
  const Trials small = trialsOf(Cube(0.9)), large = trialsOf(Cube(1.1)), same = trialsOf(Cube(1));
  EXPECT_TRUE(same.pairs.empty());
  ASSERT_EQ(small.pairs.size(), 1u);
  ASSERT_EQ(large.pairs.size(), 1u);
  EXPECT_EQ(large.pairs[0].first, 0u);
  EXPECT_EQ(large.pairs[0].second, 1u);
  const TrialCounts &missed = small.pairs[0].counts, &phantom = large.pairs[0].counts;
  EXPECT_EQ(phantom.queries, 400u);
  EXPECT_EQ(phantom.hits, missed.hits) << "of the same original, in the same configurations";
  EXPECT_EQ(phantom.missed + missed.phantom, 0u);
  // A link's counts hold its pair's and those with the boxes, of which there is one in each configuration.
  EXPECT_GT(phantom.phantom, 0u);
  EXPECT_LT(phantom.phantom, large.of_link[0].phantom);
  EXPECT_GT(missed.missed, 0u);
  EXPECT_LT(missed.missed, small.of_link[0].missed);
}

TEST(Trials, BoundsThatAreTooSmallAreContradicted) {
  Cube small(0.9), large(1.1);
  small.row.uncovered.bound /= 10;
  large.row.protrusion.bound /= 10;
  const Trials missed = trialsOf(small), phantom = trialsOf(large);
  EXPECT_GT(missed.contradictions, 0u);
  EXPECT_GT(phantom.contradictions, 0u);
  ASSERT_FALSE(missed.remarks.empty());
  EXPECT_NE(missed.remarks[0].find("configuration "), std::string::npos);
  EXPECT_LE(phantom.remarks.size(), 10u);
}

TEST(Trials, LinesAndPointsOfAResultCountInItsDistances) {
  const TriangleMesh cube = test_shapes::box(0.2, 0.2, 0.2);
  const TriangleMesh line{{{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}}, {{0, 1, 2}}}, point{{{0.2, 0.2, 0.2}}, {{0, 0, 0}}};
  for (const TriangleMesh& thin : {line, point}) {
    TriangleMesh both = thin;  // a bound that only the thin part keeps small
    append(both, test_shapes::moved(test_shapes::box(0.01, 0.01, 0.01), {5, 5, 5}));
    LinkBodies original, result;
    original.meshes.push_back({cube, convexParts(cube)});
    result.meshes.push_back({both, convexParts(both)});
    LinkPair pair(original, result);
    LinkVerification row;
    row.diagonal = diagonal(pair.surface());
    pair.measure(row);
    EXPECT_LT(row.uncovered.bound, 1);
    const Trials trials = tryConfigurations(twoLinks(), {{0, &pair, &row}}, 200, 1);
    EXPECT_GT(trials.all.missed, 0u);
    EXPECT_EQ(trials.contradictions, 0u);
  }
}

/// A box may reach into an open box without touching it, and is then in the solid though none of its corners need be.
TEST(Trials, WhatReachesInThroughAnOpeningContradictsNothing) {
  TriangleMesh shell = test_shapes::box(0.2, 0.2, 0.2, 3);
  const auto is_in_hole = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](int v) {
      const Eigen::Vector3d& p = shell.vertices[static_cast<std::size_t>(v)];
      return p.x() > 0.19 && std::abs(p.y() - 0.1) < 0.04 && std::abs(p.z() - 0.1) < 0.04;
    });
  };
  shell.triangles.erase(std::remove_if(shell.triangles.begin(), shell.triangles.end(), is_in_hole), shell.triangles.end());
  ASSERT_EQ(shell.triangles.size(), 106u);
  LinkBodies original, result;
  original.meshes.push_back({shell, {}});
  GeometryElement full;
  full.kind = Kind::kBox;
  full.size = {0.2, 0.2, 0.2};
  full.origin.translation().setConstant(0.1);
  result.primitives.push_back(full);
  LinkPair pair(original, result);
  LinkVerification row;
  row.diagonal = diagonal(pair.surface()) / 5;  // boxes that fit through the hole
  pair.measure(row);
  ASSERT_TRUE(pair.solid().hasOpenings());
  row.protrusion.bound = 0;
  const Trials trials = tryConfigurations(twoLinks(), {{0, &pair, &row}}, 2000, 1);
  EXPECT_GT(trials.all.phantom, 0u);
  EXPECT_EQ(trials.contradictions, 0u) << trials.remarks.front();
}

/// Walls cover the surface, and that is all that a result has to do.
TEST(Trials, WhatIsInsideAndTouchesNoSurfaceIsNotMissed) {
  LinkBodies original, walls;
  GeometryElement cube;
  cube.kind = Kind::kBox;
  cube.size = {0.25, 0.25, 0.25};
  original.primitives = {cube};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      GeometryElement wall = cube;
      wall.size[axis] = 1.0 / 256;
      wall.origin.translation()[axis] = side * (0.125 - 0.5 / 256);
      walls.primitives.push_back(wall);
    }
  LinkPair pair(original, walls);
  LinkVerification row;
  row.diagonal = diagonal(pair.surface()) / 2;  // boxes that fit inside
  row.uncovered.bound = row.protrusion.bound = 0;
  const Trials trials = tryConfigurations(twoLinks(), {{0, &pair, &row}}, 10000, 1);
  EXPECT_EQ(trials.contradictions, 0u) << trials.remarks.front();
  EXPECT_EQ(trials.all.missed, 0u);
}

/// A box wholly inside the original touches no surface, and yet it collides.
TEST(Trials, ABodyInsideAnotherCollides) {
  Cube same(1);
  same.row.diagonal /= 100;  // small boxes near the surface, half of them inside
  const Trials trials = trialsOf(same);
  EXPECT_EQ(trials.all.missed + trials.all.phantom + trials.contradictions, 0u);
  EXPECT_GT(trials.of_link[0].hits, 100u);
}

}  // namespace
}  // namespace collision_hulls
