// The depth of the deepest notch, the paper's straight-line concavity, against closed forms.
#include "decompose/acd/notches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using test_shapes::lBracket;

constexpr double kRounding = 1e-9;

double concavity(const TriangleMesh& mesh, bool two_sided = false) {
  return deepestNotch(mesh, convexHull(mesh.vertices), two_sided, {}).concavity;
}

TEST(Notches, ConvexShapesHaveNone) {
  EXPECT_EQ(concavity(test_shapes::singleTriangle()), 0);
  EXPECT_EQ(concavity(test_shapes::singleTriangle(), true), 0);
  EXPECT_EQ(concavity(test_shapes::box(1, 2, 3, 4)), 0);
  EXPECT_EQ(concavity(test_shapes::sphere()), 0);
}

TEST(Notches, LBracketsNotchBelowItsBridge) {
  // The bridge is the plane from (leg, t) to (t, leg), the notch at (t, t).
  EXPECT_NEAR(concavity(lBracket(1, 0.1, 1)), 0.9 / std::sqrt(2), kRounding);
  EXPECT_NEAR(concavity(lBracket(1, 0.1, 1, 5)), 0.9 / std::sqrt(2), kRounding);
}

TEST(Notches, UChannelsNotchesBelowItsOpening) {
  // The end faces contain the notches' ends but are not bridges: the notches do not open towards them.
  EXPECT_NEAR(concavity(test_shapes::uChannel(3, 1, 0.1, 2)), 0.9, kRounding);
}

TEST(Notches, ASheetsRidgeIsANotchFromBelow) {
  test_shapes::MeshBuilder builder;
  builder.quad({-1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {-1, 1, 0});
  builder.quad({0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1});
  TriangleMesh roof = builder.mesh();
  for (Triangle& t : roof.triangles) std::swap(t[1], t[2]);  // whichever way it faces
  for (int turn = 0; turn < 2; ++turn) {
    EXPECT_NEAR(concavity(roof, true), 1, kRounding);
    for (Triangle& t : roof.triangles) std::swap(t[1], t[2]);
  }
}

/// The definition, with all faces of the hull for each end and middle of each reflex edge.
double concavityByAllFaces(const TriangleMesh& mesh) {
  const ConvexHull hull = convexHull(mesh.vertices);
  std::map<std::pair<int, int>, Eigen::Vector3d> normals;  // of the triangle beside each directed edge
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d a = mesh.corner(static_cast<int>(t), 0), b = mesh.corner(static_cast<int>(t), 1),
                          c = mesh.corner(static_cast<int>(t), 2);
    for (std::size_t k = 0; k < 3; ++k) normals[{mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]}] = (b - a).cross(c - a).normalized();
  }
  double most = 0;
  for (const auto& [edge, normal] : normals) {
    const Eigen::Vector3d a = mesh.vertices[static_cast<std::size_t>(edge.first)], b = mesh.vertices[static_cast<std::size_t>(edge.second)];
    const Eigen::Vector3d& beyond = normals.at({edge.second, edge.first});
    if (edge.first > edge.second || (b - a).cross(normal).dot(beyond) >= 0) continue;
    const Eigen::Vector3d out = (normal + beyond).normalized();
    for (const Eigen::Vector3d& p : {Eigen::Vector3d((a + b) / 2), a, b}) {
      double least = std::numeric_limits<double>::infinity();
      for (const HalfSpace& face : hull.faces)
        if (face.normal.dot(out) >= 0.1) least = std::min(least, -face.distance(p));
      if (std::isfinite(least)) most = std::max(most, least);
    }
  }
  return most;
}

TEST(Notches, TheDeepestOfManyIsThatOfTheDefinition) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    test_shapes::RandomPoints random(seed);
    TriangleMesh mesh = test_shapes::sphere();
    const Eigen::Vector3d offset = 10 * random.inCube();
    for (Eigen::Vector3d& v : mesh.vertices) v = random.number(0.6, 1) * v + offset;
    const double expected = concavityByAllFaces(mesh);
    EXPECT_GT(expected, 0.1);
    EXPECT_NEAR(concavity(mesh), expected, 1e-12) << seed;
  }
}

}  // namespace
}  // namespace collision_hulls
