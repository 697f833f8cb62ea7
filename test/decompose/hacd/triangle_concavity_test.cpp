#include "decompose/hacd/triangle_concavity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;
using test_shapes::RandomPoints;
const double kInfinity = std::numeric_limits<double>::infinity();

ConvexHull hullOf(const TriangleMesh& mesh) {
  return convexHull(mesh.vertices);
}

double concavityOf(const ConvexHull& hull, const Corners& corners, const Eigen::Vector3d& normal, double known = 0) {
  return concavityOfTriangle(ExitFaces(hull), corners, normal, known);
}

/// The first exit, from the distances to all faces.
int firstOfAll(const ConvexHull& hull, const ExitFaces& faces, const Eigen::Vector3d& origin, const Eigen::Vector3d& m,
               const Eigen::Vector3d& along) {
  int first = -1;
  double least = kInfinity;
  for (std::size_t f = 0; f < hull.faces.size(); ++f) {
    if (!(hull.faces[f].normal.dot(along) > 1e-6)) continue;
    const double t = faces.exitFunction(static_cast<int>(f), origin, along)(m);
    if (t < least) least = t, first = static_cast<int>(f);
  }
  return first;
}

/// Compares rays from the surface and from the inside, along random directions and along those in which faces tie.
void expectFirstExits(const ConvexHull& hull, RandomPoints& random) {
  const ExitFaces faces(hull);
  const Eigen::Vector3d middle = boundingBox(hull).center();
  const std::vector<Eigen::Vector3d> directions = random.cloud(300);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Eigen::Vector3d& origin = hull.vertices[i % hull.vertices.size()];
    const Eigen::Vector3d target = hull.vertices[(7 * i + 3) % hull.vertices.size()];
    const double share = static_cast<double>(i % 5) / 4 - 0.25;  // 0: on the surface; below 0: outside
    const Eigen::Vector3d m = share * (middle - origin);
    for (const Eigen::Vector3d& way :
         {directions[i], Eigen::Vector3d(target - origin - m), Eigen::Vector3d(Eigen::Vector3d::Unit(i % 3))}) {
      if (way.isZero(0)) continue;
      const Eigen::Vector3d along = way.normalized();
      ASSERT_EQ(faces.firstExit(origin, m, along), firstOfAll(hull, faces, origin, m, along)) << "ray " << i;
    }
  }
}

TEST(ExitFaces, AgreeWithComparingAllFaces) {
  RandomPoints random(3);
  for (const TriangleMesh& mesh : {test_shapes::box(1, 2, 3, 3), test_shapes::sphere(1, 16), test_shapes::torus(1, 0.3, 60, 30),
                                   test_shapes::sheet(1, 2, 6), test_shapes::singleTriangle()})
    expectFirstExits(hullOf(mesh), random);
  for (const int count : {4, 20, 2000}) expectFirstExits(convexHull(random.cloud(count)), random);
}

TEST(ExitFaces, AgreeWithComparingAllFacesFarFromTheOriginAndInThinHulls) {
  RandomPoints random(4);
  TriangleMesh far = test_shapes::sphere(1e-3, 12), thin = test_shapes::sphere(1, 12);
  for (Eigen::Vector3d& v : far.vertices) v += Eigen::Vector3d(1, -2, 0.5);
  for (Eigen::Vector3d& v : thin.vertices) v.z() *= 1e-5;
  expectFirstExits(hullOf(far), random);
  expectFirstExits(hullOf(thin), random);
}

TEST(TriangleConcavity, ZeroOnTheHullsOwnFace) {
  const ConvexHull cube = hullOf(test_shapes::box(1, 1, 1));
  EXPECT_NEAR(concavityOf(cube, Corners{{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}, {0, 0, 1}), 0, 1e-9);
}

TEST(TriangleConcavity, DistanceToTheOppositeFace) {
  const ConvexHull cube = hullOf(test_shapes::box(1, 1, 1));
  EXPECT_NEAR(concavityOf(cube, Corners{{{0, 0, 0.25}, {1, 0, 0.25}, {0, 1, 0.25}}}, {0, 0, 1}), 0.75, 1e-9);
}

TEST(TriangleConcavity, LargestInsideTheTriangle) {
  const ConvexHull pyramid = convexHull({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0.1, 0, 1}});
  EXPECT_NEAR(concavityOf(pyramid, Corners{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}}, {0, 0, 1}), 1, 1e-9);
}

TEST(TriangleConcavity, LargestOnASideOfTheTriangle) {
  const ConvexHull pyramid = convexHull({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}});
  // Of the part of the triangle beyond y = 1/2, the middle of its lower side is nearest to the axis.
  EXPECT_NEAR(concavityOf(pyramid, Corners{{{-0.5, 0.5, 0}, {0.5, 0.5, 0}, {0, 0.9, 0}}}, {0, 0, 1}), 0.5, 1e-9);
}

TEST(TriangleConcavity, StopsOnceItIsKnownToBeSmaller) {
  const ConvexHull cube = hullOf(test_shapes::box(1, 1, 1));
  EXPECT_LE(concavityOf(cube, Corners{{{0, 0, 0.25}, {1, 0, 0.25}, {0, 1, 0.25}}}, {0, 0, 1}, 2.0), 2.0);
}

TEST(TriangleConcavity, AgreesWithDenseSampling) {
  const unsigned seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto point = [&] { return Eigen::Vector3d(uniform(random), uniform(random), uniform(random)); };
  for (int repeat = 0; repeat < 200; ++repeat) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 20; ++i) points.push_back(point());
    const Corners corners{points[0], points[1], points[2]};
    const ConvexHull hull = convexHull(points);
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    double sampled = 0;
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const Eigen::Vector3d m = corners[0] + (corners[1] - corners[0]) * i / kSteps + (corners[2] - corners[0]) * j / kSteps;
        double exit = kInfinity;
        for (const HalfSpace& face : hull.faces)
          if (face.normal.dot(normal) > 1e-9) exit = std::min(exit, -face.distance(m) / face.normal.dot(normal));
        sampled = std::max(sampled, exit);
      }
    }
    const double exact = concavityOf(hull, corners, normal);
    EXPECT_GE(exact, sampled - 1e-9) << "repeat " << repeat;
    EXPECT_LE(exact, sampled + 0.2) << "repeat " << repeat;
  }
}

}  // namespace
}  // namespace collision_hulls
