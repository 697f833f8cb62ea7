#include <cmath>
#include <limits>

#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

TEST(Shapes, RejectsInvalidSizes) {
  expectError(ErrorCode::kBadScene, {"a box of 1 x -1 x 1 m", "above 0"}, [] { boxShape({1, -1, 1}); });
  expectError(ErrorCode::kBadScene, {"a sphere of 0 m"}, [] { sphereShape(0); });
  expectError(ErrorCode::kBadScene, {"a cylinder", "nan"}, [] { cylinderShape(1, std::nan("")); });
  expectError(ErrorCode::kBadScene, {"a cone", "inf"}, [] { coneShape(std::numeric_limits<double>::infinity(), 1); });
  expectError(ErrorCode::kBadScene, {"of 1 x 1e+300 x 1 m", "1e6"}, [] { boxShape({1, 1e300, 1}); });
  expectError(ErrorCode::kBadScene, {"1e6"}, [] { boxShape({1, 2e6, 1}); });
  expectError(ErrorCode::kBadScene, {"a plane", "normal"}, [] { planeShape({0, 0, 0}, 1); });
}

TEST(SetShape, TakesAsManySizesAsTheKindHas) {
  SceneBody body;
  for (const std::string kind : {"box", "sphere", "cylinder", "cone", "plane"}) {
    for (const std::size_t count : {std::size_t{0}, sizesOf(kind) - 1, sizesOf(kind) + 1})
      expectError(ErrorCode::kBadScene, {"a " + kind + " of " + std::to_string(count) + " size", "takes " + std::to_string(sizesOf(kind))},
                  [&] { setShape(body, kind, std::vector<double>(count, 1)); });
    EXPECT_NO_THROW(setShape(body, kind, std::vector<double>(sizesOf(kind), 1)));
  }
  expectError(ErrorCode::kBadScene, {"'egg' is not a shape"}, [&] { setShape(body, "egg", {1}); });
}

TEST(Shapes, Box) {
  const ConvexHull box = boxShape({1, 2, 4});
  EXPECT_EQ(box.vertices.size(), 8u);
  EXPECT_NEAR(volume(box), 8, 1e-12);
  EXPECT_TRUE(boundingBox(box).max().isApprox(Eigen::Vector3d(0.5, 1, 2)));
}

TEST(Shapes, RoundShapesCircumscribeWithinTheirRoundness) {
  const double radius = 0.3, most = radius * (1 + SceneBody::kRoundness);
  const ConvexHull sphere = sphereShape(radius);
  for (const HalfSpace& face : sphere.faces) EXPECT_GE(face.offset, radius * (1 - 1e-12));
  for (const Eigen::Vector3d& v : sphere.vertices) EXPECT_LE(v.norm(), most);
  const ConvexHull cylinder = cylinderShape(radius, 2);
  for (const HalfSpace& face : cylinder.faces) EXPECT_GE(face.offset, std::abs(face.normal.z()) > 0.5 ? 1 : radius * (1 - 1e-12));
  for (const Eigen::Vector3d& v : cylinder.vertices) {
    EXPECT_LE(v.head<2>().norm(), most);
    EXPECT_EQ(std::abs(v.z()), 1);
  }
}

TEST(Shapes, ConePointsUp) {
  const ConvexHull cone = coneShape(0.5, 2);
  EXPECT_LE(planeDistance(cone, {0, 0, 1}), 1e-12);
  EXPECT_GT(planeDistance(cone, {0.1, 0, 1}), 0);
  EXPECT_LE(planeDistance(cone, {0, 0.5, -1}), 1e-12);
  EXPECT_LE(planeDistance(cone, {0.25 / std::sqrt(2), 0.25 / std::sqrt(2), 0}), 1e-12) << "halfway up";
  EXPECT_GT(planeDistance(cone, {0.26, 0, 0}), 0);
}

TEST(Shapes, PlanesBecomeSlabsBeneathThem) {
  for (const Eigen::Vector3d& normal : {Eigen::Vector3d(0, 0, 2), Eigen::Vector3d(1, -2, 3), Eigen::Vector3d(0, 0, -1)}) {
    const PlacedShape slab = planeShape(normal, 0.5);
    const Eigen::Vector3d up = normal.normalized(), foot = -0.5 / normal.squaredNorm() * normal;
    const auto distanceAt = [&](double height) { return planeDistance(slab.shape, slab.pose.inverse() * (foot + height * up)); };
    EXPECT_NEAR(distanceAt(0.01), 0.01, 1e-9);
    EXPECT_NEAR(distanceAt(0), 0, 1e-9);
    EXPECT_NEAR(distanceAt(-0.02), -0.02, 1e-9);
    EXPECT_NEAR(distanceAt(-kPlaneDepth), 0, 1e-9);
  }
}

TEST(AddBody, RejectsInvalidBodies) {
  Scene scene;
  addBody(scene, {"a", boxShape({1, 1, 1})});
  const TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const auto adding = [&](const std::string& name, const TriangleMesh& mesh, const Eigen::Isometry3d& pose) {
    return [&scene, name, mesh, pose] { addBody(scene, {name, mesh, pose}); };
  };
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
  TriangleMesh broken = triangle;
  broken.triangles[0][1] = 3;
  TriangleMesh endless = triangle;
  endless.vertices[1].x() = std::numeric_limits<double>::infinity();
  Eigen::Isometry3d nowhere = here, far = here;
  nowhere.translation().y() = std::nan("");
  far.translation().y() = 2e6;
  expectError(ErrorCode::kBadScene, {"no name"}, adding("", triangle, here));
  expectError(ErrorCode::kBadScene, {"'a'", "twice"}, adding("a", triangle, here));
  expectError(ErrorCode::kBadScene, {"longer than 1000 bytes"}, adding(std::string(1001, 'a'), triangle, here));
  expectError(ErrorCode::kBadScene, {"'b'", "without triangles"}, adding("b", {}, here));
  expectError(ErrorCode::kBadScene, {"'b'", "vertex 3 of 3"}, adding("b", broken, here));
  expectError(ErrorCode::kBadScene, {"'b'", "not finite"}, adding("b", endless, here));
  expectError(ErrorCode::kBadScene, {"'b'", "not finite"}, adding("b", triangle, nowhere));
  expectError(ErrorCode::kBadScene, {"'b'", "1e6"}, adding("b", triangle, far));
  ConvexHull endless_hull = boxShape({1, 1, 1});
  endless_hull.vertices[0].z() = 1e300;
  expectError(ErrorCode::kBadScene, {"'b'", "2e6 m from its middle"}, [&] { addBody(scene, {"b", endless_hull, here}); });
  expectError(ErrorCode::kBadScene, {"'b'", "hull without vertices"}, [&] { addBody(scene, {"b", ConvexHull(), here}); });
  EXPECT_EQ(scene.bodies.size(), 1u);
}

// With a look at every other body for each, this would take 5e9 comparisons: half a minute.
TEST(SceneBuilder, AddsManyBodies) {
  Scene scene;
  addBody(scene, {"first", boxShape({1, 1, 1})});
  SceneBuilder builder(scene);
  const TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  for (int i = 0; i < 99'999; ++i) builder.add({"body " + std::to_string(i), triangle});
  EXPECT_EQ(scene.bodies.size(), 100'000u);
  for (const char* name : {"first", "body 7"}) expectError(ErrorCode::kBadScene, {name, "twice"}, [&] { builder.add({name, triangle}); });
  EXPECT_EQ(scene.bodies.size(), 100'000u);
}

}  // namespace
}  // namespace collision_hulls
