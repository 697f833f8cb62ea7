// The bounds hold for whatever the joints do within their box, and are tight where a closed form is known.
#include "reach/box_movement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "random_points.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;

ChainJoint joint(bool turns, const Vector3d& axis, const Eigen::Isometry3d& origin = Eigen::Isometry3d::Identity()) {
  ChainJoint result;
  result.turns = turns;
  result.axis = axis;
  result.origin = origin;
  return result;
}

PointMatrix column(const Vector3d& p) {
  return PointMatrix(p);
}

TEST(BoxMovement, OfOneTurningJointIsTheChord) {
  const ChainJoint hinge = joint(true, Vector3d::UnitZ());
  const BoxedBody body(column({2, 0, 1}), {{&hinge, 0, 0.5, 0.3}});
  EXPECT_LT((body.points().col(0) - Vector3d(2 * std::cos(0.5), 2 * std::sin(0.5), 1)).norm(), 1e-12);
  std::vector<double> shares(1);
  EXPECT_NEAR(body.movement(shares), 4 * std::sin(0.15), 1e-12);
  EXPECT_NEAR(shares[0], 4 * std::sin(0.15), 1e-12);
  const Vector3d tangent(-std::sin(0.5), std::cos(0.5), 0), outward(std::cos(0.5), std::sin(0.5), 0);
  EXPECT_NEAR(body.movementAlong(tangent, shares), 2 * std::sin(0.3), 1e-12);
  EXPECT_NEAR(body.movementAlong(-outward, shares), 2 * (1 - std::cos(0.3)), 1e-12) << "grows with the square of the angle";
  EXPECT_NEAR(body.movementAlong(Vector3d::UnitZ(), shares), 0, 1e-12);
}

TEST(BoxMovement, IsAsExactFarAlongTheAxis) {
  const ChainJoint hinge = joint(true, Vector3d::UnitZ());
  const BoxedBody body(column({1e-9, 0, 1}), {{&hinge, 0, 0, 0.3}});
  std::vector<double> shares(1);
  EXPECT_NEAR(body.movement(shares), 2e-9 * std::sin(0.15), 1e-15);
}

TEST(BoxMovement, OfOneSlidingJointIsItsWay) {
  const ChainJoint slide = joint(false, Vector3d::UnitX());
  const BoxedBody body(column({1, 2, 3}), {{&slide, 0, 0, 0.25}});
  std::vector<double> shares(1);
  EXPECT_NEAR(body.movement(shares), 0.25, 1e-15);
  EXPECT_NEAR(body.movementAlong(Vector3d(0.6, 0.8, 0), shares), 0.15, 1e-15);
}

/// Where the joints, at these values, take a point.
Vector3d carried(Vector3d p, const std::vector<BoxedJoint>& joints, const std::vector<double>& values) {
  for (std::size_t i = joints.size(); i-- > 0;) p = joints[i].joint->origin * (motion(*joints[i].joint, values[i]) * p);
  return p;
}

TEST(BoxMovement, AJointTurnsTheMovementsOfThoseAfterIt) {
  const ChainJoint first = joint(true, Vector3d::UnitZ());
  const ChainJoint second = joint(true, Vector3d::UnitZ(), Eigen::Isometry3d(Eigen::Translation3d(1, 0, 0)));
  const std::vector<BoxedJoint> joints{{&first, 0, 0, 0.2}, {&second, 1, 0, 0.01}};
  const Vector3d p(-1, 0, 0);  // on the first joint's axis, so that this joint alone does not move it
  const BoxedBody body(column(p), joints);
  std::vector<double> shares(2);
  const double bound = body.movementAlong(Vector3d::UnitX(), shares), moved = carried(p, joints, {0.2, 0.01}).x();
  EXPECT_LE(moved, bound);
  EXPECT_GE(moved, 0.99 * bound);
}

TEST(BoxMovement, NoConfigurationInTheBoxMovesAPointFurther) {
  RandomPoints random(3);
  double tightest = 0, tightest_along = 0;
  for (int chain = 0; chain < 60; ++chain) {
    std::vector<ChainJoint> joints;
    for (int i = 0; i < 3; ++i) {
      Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
      origin.linear() = random.rotation();
      origin.translation() = random.inCube();
      joints.push_back(joint(random.number() < 0.6, random.onSphere(), origin));
    }
    std::vector<BoxedJoint> boxed;
    for (std::size_t i = 0; i < joints.size(); ++i)
      boxed.push_back({&joints[i], i, random.number(), random.number(0, chain % 2 ? 0.4 : 2.5)});
    const Vector3d p = random.inCube(), n = random.onSphere();
    const BoxedBody body(column(p), boxed);
    std::vector<double> shares(3), shares_along(3);
    const double most = body.movement(shares), most_along = body.movementAlong(n, shares_along);
    EXPECT_LE(most_along, most + 1e-12);
    for (int sample = 0; sample < 300; ++sample) {
      std::vector<double> values;
      for (const BoxedJoint& at : boxed)
        values.push_back(at.middle + at.way * (sample % 3 == 0 ? std::copysign(1, random.number()) : random.number()));
      const Vector3d moved = carried(p, boxed, values) - body.points().col(0);
      ASSERT_LE(moved.norm(), most + 1e-12) << chain;
      ASSERT_LE(moved.dot(n), most_along + 1e-12) << chain;
      tightest = std::max(tightest, moved.norm() / most);
      tightest_along = std::max(tightest_along, moved.dot(n) / most_along);
    }
  }
  EXPECT_GT(tightest, 0.95) << "a bound that is never met says little";
  EXPECT_GT(tightest_along, 0.95);
}

}  // namespace
}  // namespace collision_hulls
