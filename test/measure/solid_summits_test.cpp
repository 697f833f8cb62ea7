// Where the distance to a solid may have local maxima.
#include <gtest/gtest.h>

#include <algorithm>

#include "collision_hulls/measure/solid.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::RandomPoints;
using test_shapes::solidOf;
using test_shapes::withoutSummit;

/// A prism whose outline crosses itself has a lobe, x > 0, that is inside out: its lower wall, in y = 0, faces up. Below it lies a block
/// with a pit in its top. All surface near the pit's middle faces up, and yet the distance has a summit there, a quarter from all of it.
TriangleMesh pitUnderInvertedLobe() {
  const TriangleMesh lobes = test_shapes::prism({{-3, -1}, {2, 2.0 / 3}, {2, 0}, {-3, 0}}, {{0, 1, 2}, {0, 2, 3}}, 1);
  const auto corner = [](std::size_t k, double y) { return Vector3d(k == 1 || k == 2 ? 1.8 : 0.6, y, k >= 2 ? 1.1 : -0.1); };
  test_shapes::MeshBuilder block;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t l = (k + 1) % 4;
    block.triangle(corner(l, -0.3), corner(k, -0.3), {1.2, -0.6, 0.5});
    block.quad(corner(k, -0.3), corner(l, -0.3), corner(l, -0.9), corner(k, -0.9));
  }
  block.quad(corner(0, -0.9), corner(1, -0.9), corner(2, -0.9), corner(3, -0.9));
  return test_shapes::merged({lobes, block.mesh()});
}

TEST(Solid, ASummitInFrontOfABackIsNotRuledOut) {
  const Solid solid = solidOf(pitUnderInvertedLobe());
  EXPECT_FALSE(solid.contains({1.2, -0.25, 0.5}));
  EXPECT_FALSE(solid.contains({1.5, 0.1, 0.5})) << "the lobe is inside out";
  EXPECT_TRUE(solid.contains({-2, -0.3, 0.5}));
  double highest = 0;
  Vector3d top = Vector3d::Zero();
  for (double y = -0.55; y < 0; y += 0.001)
    if (solid.distance({1.2, y, 0.5}) > highest) top = {1.2, y, 0.5}, highest = solid.distance(top);
  for (int k = 0; k < 6; ++k) EXPECT_LT(solid.distance(top + 0.02 * (k % 2 ? 1 : -1) * Vector3d::Unit(k / 2)), highest) << "a summit";
  EXPECT_FALSE(withoutSummit(solid, top, 0.02));
}

// Between two plates the distance has its summit half way. A ball that just holds it may have all of one plate and none of the other within
// its radius of what is nearest to its middle: a point of it may be nearer to the other by its own way from there.
TEST(Solid, ASummitHalfWayBetweenPlatesIsNotRuledOut) {
  const TriangleMesh plate = test_shapes::box(20, 20, 5);
  const Solid solid = solidOf(test_shapes::merged({test_shapes::moved(plate, {-10, -10, -5}), test_shapes::moved(plate, {-10, -10, 1})}));
  const Vector3d p(0.1, 0.2, 0.3);
  for (const double radius : {0.201, 0.25, 0.3}) EXPECT_FALSE(withoutSummit(solid, p, radius)) << radius;
  EXPECT_TRUE(withoutSummit(solid, p, 0.199)) << "so that the test can tell";
}

// The summit is on the ball's border, up to rounding, which may not decide.
TEST(Solid, ASummitThatIsAsFarAwayAsTheRadiusIsNotRuledOut) {
  const TriangleMesh plate = test_shapes::box(20, 20, 5);
  const TriangleMesh plates = test_shapes::merged({test_shapes::moved(plate, {-10, -10, -5}), test_shapes::moved(plate, {-10, -10, 1})});
  RandomPoints random(7);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Isometry3d pose = Eigen::Translation3d(random.inCube(3)) * Eigen::Isometry3d(random.rotation());
    const Solid solid = solidOf(transformed(plates, pose));
    for (int k = 0; k < 20; ++k) {
      const double height = random.number(0.05, 0.45);
      EXPECT_FALSE(withoutSummit(solid, pose * Vector3d(0.1, 0.2, height), 0.5 - height)) << height;
    }
  }
}

TEST(Solid, TheDistanceHasNoSummitWhereNoneIsPredicted) {
  // A maximum inside a ball that exceeds all values on the ball's border is a summit.
  int without = 0, with = 0;
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    RandomPoints random(seed);
    const std::vector<TriangleMesh> meshes{test_shapes::openBox(1, 1, 1, 0.05, 3), test_shapes::torus(0.8, 0.2, 16, 8),
                                           test_shapes::uChannel(1, 1, 0.1, 1, 2), pitUnderInvertedLobe()};
    for (const TriangleMesh& mesh : meshes) {
      const Solid solid = solidOf(mesh);
      for (int i = 0; i < 60; ++i) {
        const Vector3d p = random.inBox(boundingBox(mesh));
        const double radius = random.number(0.01, 0.15);
        if (!withoutSummit(solid, p, radius)) {
          ++with;
          continue;
        }
        ++without;
        double within = 0, border = 0;
        for (int k = 0; k < 200; ++k) {
          within = std::max(within, solid.distance(p + radius * random.number(0, 0.5) * random.onSphere()));
          border = std::max(border, solid.distance(p + radius * random.onSphere()));
        }
        EXPECT_LE(within, border) << p.transpose() << ", radius " << radius;
      }
    }
  }
  EXPECT_GT(without, 50);
  EXPECT_GT(with, 20);
}

}  // namespace
}  // namespace collision_hulls
