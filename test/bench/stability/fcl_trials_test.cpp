// The pairs of bodies that FCL is tried on; and that the validator's settings are safe on all of them.
#include "bench/stability/fcl_trials.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>
#include <string>

#include "query/fcl_queries.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;

ConvexHull boxHull(const Vector3d& sides) {
  return convexHull(test_shapes::moved(test_shapes::box(sides.x(), sides.y(), sides.z()), -sides / 2).vertices);
}

BodyPair boxesAt(const Vector3d& offset) {
  BodyPair pair{boxHull({1, 1, 1}), boxHull({1, 1, 1})};
  pair.pose.translation() = offset;
  return pair;
}

TEST(SignedDistance, OfBoxes) {
  EXPECT_NEAR(signedDistance(boxesAt({3, 0, 0})), 2, 1e-9);
  EXPECT_NEAR(signedDistance(boxesAt({2, 2, 0})), std::sqrt(2), 1e-9);
  EXPECT_NEAR(signedDistance(boxesAt({0.75, 0.1, 0})), -0.25, 1e-9);
  EXPECT_NEAR(signedDistance(boxesAt({0, 0, 0})), -1, 1e-9);
  BodyPair within = boxesAt({0.1, 0, 0});
  within.second = boxHull({0.2, 0.2, 0.2});
  EXPECT_NEAR(signedDistance(within), -0.5, 1e-9);
}

TEST(SignedDistance, EdgesMayBeTheWayOut) {
  BodyPair pair = boxesAt({0.9, 0.9, 0});  // rotated, an edge along z of each meets an edge along x + y of the other: out along (1, 1, 0)
  pair.pose.linear() = Eigen::AngleAxisd(test_shapes::kPi / 4, Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  const double depth = -signedDistance(pair);
  EXPECT_GT(depth, 0);
  EXPECT_LT(depth, 2 * std::sqrt(0.5) - 0.9 * std::sqrt(2) + 1e-9);
}

TEST(BodyPair, MatchesItsKind) {
  for (std::uint64_t number = 0; number < 20; ++number) {
    const auto distance = [&](PairKind kind) { return signedDistance(bodyPair(kind, 3, number)); };
    EXPECT_GE(distance(PairKind::kFar), 1 - 1e-9);
    EXPECT_GT(distance(PairKind::kNear), 0);
    EXPECT_LE(distance(PairKind::kNear), 0.01 + 1e-9);
    EXPECT_NEAR(distance(PairKind::kTouching), 0, 1e-9);
    EXPECT_LT(distance(PairKind::kContained), 0);
    EXPECT_LT(distance(PairKind::kIdentical), 0);
    EXPECT_GE(distance(PairKind::kFlat), 0.01 - 1e-9);
    EXPECT_GE(distance(PairKind::kNeedle), 0.01 - 1e-9);
    EXPECT_LT(bodyPair(PairKind::kMillimetre, 3, number).size, 1.01e-3);
    EXPECT_GT(bodyPair(PairKind::kUnequal, 3, number).size, 3);
  }
}

TEST(Fcl, NamesAreDistinct) {
  std::set<std::string> names;
  for (const FclSetting& setting : fclSettings())
    names.insert(queryName(setting) + name(setting.solver) + std::to_string(1e9 * setting.tolerance));
  EXPECT_EQ(names.size(), fclSettings().size());
}

/// The validator's settings give correct answers for all kinds of pairs, except that meshes have no inside, which the validator allows for.
TEST(Fcl, TheValidatorsSettingsAreSafe) {
  int settings = 0;
  for (const FclSetting& setting : fclSettings()) {
    if (setting.query != FclSetting::Query::kValidator) continue;
    ++settings;
    for (const PairKind kind : allPairKinds()) {
      if (setting.bodies == FclSetting::Bodies::kBvhBvh && kind == PairKind::kContained) continue;
      for (std::uint64_t number = 0; number < 40; ++number) {
        const FclTrial trial = tryFcl(setting, bodyPair(kind, 1, number));
        EXPECT_EQ(trial.outcome, FclTrial::Outcome::kExact)
            << queryName(setting) << ", " << name(kind) << " " << number << ": " << name(trial.outcome) << ", off by " << trial.error;
      }
    }
  }
  EXPECT_EQ(settings, 2);
}

TEST(Fcl, AMeshHasNoInside) {
  const FclSetting setting{FclSetting::Query::kDistance, FclSetting::Bodies::kBvhBvh, FclSetting::Solver::kNone, 0};
  EXPECT_EQ(tryFcl(setting, bodyPair(PairKind::kContained, 1, 0)).outcome, FclTrial::Outcome::kOff);
  EXPECT_EQ(tryFcl(setting, bodyPair(PairKind::kDeep, 1, 0)).outcome, FclTrial::Outcome::kExact);
}

TEST(Fcl, UnsignedDistanceOfAnOverlapIsMinusOne) {
  const FclSetting setting{FclSetting::Query::kDistance, FclSetting::Bodies::kConvexConvex, FclSetting::Solver::kLibccd, 1e-9};
  EXPECT_EQ(tryFcl(setting, bodyPair(PairKind::kDeep, 1, 0)).outcome, FclTrial::Outcome::kMinusOne);
}

}  // namespace
}  // namespace collision_hulls
