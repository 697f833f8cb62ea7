// The field of rims against that of many short pieces, and the way that follows from it against circles, whose field is known.
#include "measure/rim_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;

struct Wires {
  std::vector<Vector3d> vertices;
  Rim rim;

  void addCircle(const Vector3d& centre, double radius, int edges) {
    const int first = static_cast<int>(vertices.size());
    for (int i = 0; i < edges; ++i) {
      const double at = 2 * test_shapes::kPi * i / edges;
      vertices.push_back(centre + radius * Vector3d(std::cos(at), std::sin(at), 0));
      rim.push_back({first + i, first + (i + 1) % edges});
    }
  }
  RimField field() const { return RimField(vertices, rim, {}); }

  /// What a path from p of this length can change of the winding number at most, and the distance to the nearest edge.
  std::pair<double, double> change(const Vector3d& p, double length) const {
    constexpr int kPieces = 200;
    double sum = 0, nearest = std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : rim) {
      const Vector3d &a = vertices[static_cast<std::size_t>(from)], &b = vertices[static_cast<std::size_t>(to)];
      for (int i = 0; i < kPieces; ++i) {
        const double d = (a + (i + 0.5) / kPieces * (b - a) - p).norm();
        nearest = std::min(nearest, d);
        sum += (b - a).norm() / kPieces / (4 * test_shapes::kPi) * length / (d * (d - length));
      }
    }
    return {sum, nearest};
  }
};

TEST(RimField, OfAnEdgeIsThatAtItsNearestPoint) {
  Wires wires;
  wires.vertices = {{0, 0, 0}, {2, 0, 0}};
  wires.rim = {{0, 1}};
  for (const auto& [p, d] : {std::pair{Vector3d(1, 0.5, 0), 0.5}, {Vector3d(-3, 0, 0), 3.0}, {Vector3d(2, 3, 4), 5.0}}) {
    const RimField::Seen seen = wires.field().from(p);
    EXPECT_DOUBLE_EQ(seen.distance, d);
    EXPECT_DOUBLE_EQ(seen.strength, 2 / (4 * test_shapes::kPi * d * d));
    EXPECT_DOUBLE_EQ(seen.way(0.1), 0.1 * d / (seen.strength * d + 0.1));
  }
}

TEST(RimField, IsThatOfACircleOnItsAxis) {
  Wires wires;
  wires.addCircle({1, 2, 3}, 0.5, 400);
  const RimField field = wires.field();
  for (const double h : {0.01, 0.2, 1.0, 5.0}) {
    const double d = std::hypot(0.5, h);
    const RimField::Seen seen = field.from({1, 2, 3 + h});
    EXPECT_LE(seen.distance, d) << h;
    EXPECT_GE(seen.distance, 0.7 * d) << h;
    EXPECT_GE(seen.strength, 0.999 * 0.5 / (2 * d * d)) << h;
    EXPECT_LE(seen.strength, 2 * 0.5 / (2 * d * d)) << h;
  }
}

// The bound never exceeds what the integral along the rim allows, and is no third of it where that matters: near a small rim, with a long
// one far away.
TEST(RimField, NoPathChangesMoreThanTheMargin) {
  Wires wires;
  wires.addCircle({0, 0, 0}, 0.05, 30);
  wires.addCircle({0, 0, 1}, 0.02, 7);
  wires.addCircle({20, 0, 0}, 10, 100);
  const RimField field = wires.field();
  test_shapes::RandomPoints random(3);
  for (int i = 0; i < 300; ++i) {
    const Vector3d p = random.inCube(i % 3 == 0 ? 15 : 0.3);
    for (const double margin : {0.01, 0.1, 0.4}) {
      const double way = field.from(p).way(margin);
      const auto [change, nearest] = wires.change(p, way);
      ASSERT_LT(way, nearest);
      EXPECT_LE(change, 1.01 * margin) << p.transpose();
      const double longer = std::min(3 * way, 0.999 * nearest);
      EXPECT_GE(wires.change(p, longer).first, margin) << p.transpose();
    }
  }
}

// Where one distance stood for all of the rim, the long one would leave a thousandth.
TEST(RimField, ALongRimFarAwayHardlyCounts) {
  Wires wires;
  wires.addCircle({0, 0, 0}, 0.05, 30);
  const double alone = wires.field().from({0, 0, 0.2}).way(0.4);
  wires.addCircle({0, 0, 1000}, 500, 1000);
  EXPECT_GT(wires.field().from({0, 0, 0.2}).way(0.4), 0.99 * alone);
}

TEST(RimField, OnTheRimAndWithoutOne) {
  Wires wires;
  EXPECT_TRUE(std::isinf(wires.field().from({0, 0, 0}).way(0.1)));
  wires.addCircle({0, 0, 0}, 1, 5);
  wires.rim.push_back({0, 0});  // no length
  EXPECT_EQ(wires.field().from(wires.vertices[0]).way(0.1), 0);
  EXPECT_EQ(wires.field().from((wires.vertices[1] + wires.vertices[2]) / 2).way(0.1), 0);
}

}  // namespace
}  // namespace collision_hulls
