#include "reach/obstacle.h"

#include "geometry/random_stream.h"
#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

PointMatrix pointsOf(const std::vector<Eigen::Vector3d>& vertices) {
  PointMatrix result(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) result.col(static_cast<Eigen::Index>(i)) = vertices[i];
  return result;
}

TEST(Obstacle, ConvexBodyAtItsPose) {
  SceneBody body{"a", boxShape({1, 1, 1})};
  body.pose.translation().x() = 3;
  const Gap gap = Obstacle(body).gapTo(pointsOf({{0, 0, 0}}), kEndless);
  EXPECT_NEAR(gap.at_least, 2.5, 1e-5);
  EXPECT_NEAR(gap.at_most, 2.5, 1e-5);
}

TEST(Obstacle, MeshHasNoInterior) {
  const Obstacle room(SceneBody{"room", surface(boxShape({4, 4, 4}))});
  EXPECT_NEAR(room.gapTo(pointsOf(boxShape({1, 1, 1}).vertices), kEndless).at_least, 1.5, 3e-3);
}

/// The box of slanted triangles is nearer than that of flat ones, which are nearer themselves, by less than is searched for.
TEST(Obstacle, GapIsNoMoreThanThatToABoxThatWasNotOpened) {
  TriangleMesh mesh;
  const auto add = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  constexpr double kFlat = 0.9995;
  for (int i = 0; i < 4; ++i) {
    add({std::sqrt(2.0), 0, -0.1}, {std::sqrt(2.0), 0, 0.1}, {0, std::sqrt(2.0), 0});  // 1 m from the origin
    add({-kFlat, -0.1, -0.1}, {-kFlat, 0.1, -0.1}, {-kFlat, 0, 0.2});
  }
  const Gap gap = Obstacle(SceneBody{"mesh", mesh}).gapTo(pointsOf({{0, 0, 0}}), kEndless);
  EXPECT_LE(gap.at_least, kFlat * (1 + 1e-9));
  EXPECT_GE(gap.at_least, kFlat * (1 - 1e-5));
}

TEST(Obstacle, GapIsThatOfTheNearestTriangle) {
  Random random(11, 0, 0);
  TriangleMesh mesh;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d middle = 3 * Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(middle + random.uniform(0, 0.3) * random.direction());
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Obstacle obstacle(SceneBody{"mesh", mesh});
  for (int i = 0; i < 50; ++i) {
    std::vector<Eigen::Vector3d> body;
    const Eigen::Vector3d middle = 5 * random.direction();
    for (int k = 0; k < 8; ++k) body.push_back(middle + 0.5 * random.direction());
    double least = kEndless;
    for (int t = 0; t < 300; ++t) {
      least = std::min(least, convexGap(pointsOf(body), pointsOf({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)})).at_most);
    }
    const Gap gap = obstacle.gapTo(pointsOf(body), kEndless);
    EXPECT_LE(gap.at_least, least + 1e-12);
    EXPECT_GE(gap.at_least, least * (1 - 2e-3));
    EXPECT_GE(gap.at_most, least * (1 - 1e-5));
    EXPECT_LE(gap.at_most, least * (1 + 2e-3));
    const double enough = 0.5 * least;
    EXPECT_GE(obstacle.gapTo(pointsOf(body), enough).at_least, enough);
  }
}

}  // namespace
}  // namespace collision_hulls
