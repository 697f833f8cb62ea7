// The bodies of links: each is a look at the control, and what both sides hold is left out in time proportional to their number.
#include "verify/link_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "counted_looks.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using test_shapes::box;
using test_shapes::moved;

TEST(MeshFiles, EachElementIsALookAtTheControl) {
  const fixtures::TempFolder folder;
  GeometryElement element;
  element.kind = GeometryElement::Kind::kMesh;
  element.uri = fixtures::write(folder / "cube.obj", fixtures::obj(box(1, 1, 1)));
  const std::vector<GeometryElement> elements(1000, element);
  const Description description{parseRobotDescription(fixtures::robot("r", fixtures::link("a", ""))), PackageFinder()};
  const auto read = [&](std::size_t count, const RunControl& control) {
    MeshFiles(description, {}, true, control).bodiesOf({elements.begin(), elements.begin() + static_cast<std::ptrdiff_t>(count)});
  };
  const std::size_t of_one = looksOf([&](const RunControl& control) { read(1, control); });
  const auto all = [&](const RunControl& control) { read(elements.size(), control); };
  EXPECT_GE(looksOf(all), elements.size());
  EXPECT_EQ(looksAfterCancel(elements.size() / 2, all), 1u);
  EXPECT_GT(elements.size() / 2, of_one) << "the file has been read by then";
}

TEST(MeshFiles, AFaultNamesTheMeshToBlame) {
  GeometryElement sphere, lost;
  sphere.kind = GeometryElement::Kind::kSphere;
  sphere.fault = "it has no radius";
  lost.kind = GeometryElement::Kind::kMesh;
  lost.uri = "/nowhere/lost.stl";
  const Description description{parseRobotDescription(fixtures::robot("r", fixtures::link("a", ""))), PackageFinder()};
  const RunControl control;
  MeshFiles files(description, {}, true, control);
  EXPECT_EQ(files.bodiesOf({lost}).fault_uri, lost.uri);
  EXPECT_EQ(files.bodiesOf({sphere}).fault, sphere.fault);
  EXPECT_EQ(files.bodiesOf({sphere}).fault_uri, "");
}

TEST(Without, OnlyAnEqualMeshAtTheSamePlaceIsLeftOut) {
  const TriangleMesh cube = box(1, 1, 1);
  TriangleMesh turned = cube, opened = cube, endless = cube, signed_zero = cube;
  std::swap(turned.triangles[0][1], turned.triangles[0][2]);
  opened.triangles.pop_back();
  endless.vertices[0].x() = std::numeric_limits<double>::quiet_NaN();
  for (Eigen::Vector3d& v : signed_zero.vertices)
    if (v.x() == 0) v.x() = -0.0;
  LinkBodies bodies, others;
  for (const TriangleMesh& mesh : {cube, moved(cube, {1, 0, 0}), turned, opened, endless, signed_zero}) bodies.meshes.push_back({mesh, {}});
  for (const TriangleMesh& mesh : {moved(cube, {2, 0, 0}), cube, endless, cube}) others.meshes.push_back({mesh, {}});
  const LinkBodies left = without(bodies, others, 0).bodies;
  ASSERT_EQ(left.meshes.size(), 4u);
  EXPECT_EQ(left.meshes[0].mesh.vertices, moved(cube, {1, 0, 0}).vertices);
  EXPECT_EQ(left.meshes[1].mesh.triangles, turned.triangles);
  EXPECT_EQ(left.meshes[2].mesh.triangles, opened.triangles);
  EXPECT_TRUE(std::isnan(left.meshes[3].mesh.vertices[0].x()));
  EXPECT_EQ(without(others, bodies, 0).bodies.meshes.size(), 2u) << "the moved one and the one that equals nothing, not even itself";
}

TEST(Without, EachElementIsALookAtTheControl) {
  LinkBodies bodies;
  bodies.meshes.assign(500, {box(1, 1, 1), {}});
  GeometryElement cube;
  cube.kind = GeometryElement::Kind::kBox;
  bodies.primitives.assign(500, cube);
  const auto work = [&](const RunControl& control) { without(bodies, bodies, 0, control); };
  EXPECT_GE(looksOf(work), 1500u) << "of the boxes, of one side's meshes, and of the other's";
  for (const std::size_t at : {1, 600, 1400}) EXPECT_EQ(looksAfterCancel(at, work), 1u);
}

TEST(Without, APrimitiveIsComparedWithFewOthers) {
  constexpr std::size_t kSide = 20;
  LinkBodies balls;
  for (std::size_t i = 0; i < kSide * kSide; ++i) {
    GeometryElement ball;
    ball.kind = GeometryElement::Kind::kSphere;
    ball.size = {0.1, 0, 0};
    ball.origin.translation() = Eigen::Vector3d(static_cast<double>(i % kSide), static_cast<double>(i / kSide), 0);
    balls.primitives.push_back(ball);
  }
  LinkBodies others = balls;
  std::reverse(others.primitives.begin(), others.primitives.end());
  others.primitives.front().origin.translation().z() = 1e-3;
  std::size_t left = 0;
  const std::size_t looks = looksOf([&](const RunControl& control) { left = without(balls, others, 0, control).bodies.primitives.size(); });
  EXPECT_EQ(left, 1u);
  EXPECT_GE(looks, 2 * balls.primitives.size() - 1) << "each, and each with its like";
  EXPECT_LE(looks, 3 * balls.primitives.size());
  for (GeometryElement& ball : others.primitives) ball.origin.translation() *= 1 + 1e-12;
  EXPECT_EQ(without(balls, others, 0).bodies.primitives.size(), 1u) << "rounding makes no difference";
}

TEST(Without, APrimitiveThatIsNearlyAlikeIsLeftOutAndItsDifferenceKept) {
  GeometryElement cube;
  cube.kind = GeometryElement::Kind::kBox;
  cube.size = {1, 2, 3};
  LinkBodies bodies, others;
  for (const double shift : {5e-5, 2e-5, 1.0}) {
    bodies.primitives.push_back(cube);
    others.primitives.push_back(cube);
    others.primitives.back().origin.translation().y() = shift;
  }
  EXPECT_EQ(without(bodies, others, 1e-5).bodies.primitives.size(), 3u);
  const Remainder rest = without(bodies, others, 1e-4);
  EXPECT_TRUE(rest.bodies.empty());
  EXPECT_NEAR(rest.apart, 2e-5, 1e-10) << "of the nearest";
}

}  // namespace
}  // namespace collision_hulls
