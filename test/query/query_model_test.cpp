#include "query/query_model.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

TEST(QueryModel, NothingTouchesNothing) {
  QueryModel none, box;
  none.place({});
  box.add(0, boxHull({0, 0, 0}, {1, 1, 1}));
  box.place(posesAt({{0, 0, 0}}));
  EXPECT_FALSE(none.collides(box));
  EXPECT_FALSE(none.collides(IgnoredPairs(0)));
}

TEST(QueryModel, TwoModels) {
  for (const bool as_mesh : {false, true}) {
    QueryModel moving, scene;
    if (as_mesh) moving.add(0, box(0.1, 0.1, 0.1));
    if (!as_mesh) moving.add(0, boxHull({0, 0, 0}, {0.1, 0.1, 0.1}));
    scene.add(0, boxHull({0, 0, 0}, {1, 1, 1}));
    scene.add(1, boxHull({0, 0, 0}, {1, 1, 1}));
    scene.place(posesAt({{0, 0, 0}, {3, 0, 0}}));
    moving.place(posesAt({{1.5, 0.2, 0.2}}));
    EXPECT_FALSE(moving.collides(scene));
    moving.place(posesAt({{2.95, 0.2, 0.2}}));
    EXPECT_TRUE(moving.collides(scene));
  }
}

TEST(QueryModel, ItsOwnLinks) {
  QueryModel chain;
  for (std::size_t link = 0; link < 4; ++link) chain.add(link, boxHull({0, 0, 0}, {1, 1, 1}));
  chain.add(3, boxHull({0.5, 0, 0}, {1.5, 1, 1}));  // overlaps its own link's other body, which does not count
  chain.place(posesAt({{0, 0, 0}, {0.5, 0, 0}, {3, 0, 0}, {4.25, 0, 0}}));
  IgnoredPairs ignored(4);
  EXPECT_TRUE(chain.collides(ignored));
  EXPECT_EQ(chain.touching(ignored), (std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}}));
  ignored.ignore(1, 0);
  EXPECT_FALSE(chain.collides(ignored));
}

TEST(QueryModel, AMeshIsASurfaceAndAHullIsSolid) {
  QueryModel small, shell, body;
  small.add(0, boxHull({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
  shell.add(0, moved(box(1, 1, 1), {-0.5, -0.5, -0.5}));
  body.add(0, boxHull({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
  for (QueryModel* model : {&small, &shell, &body}) model->place(posesAt({{0, 0, 0}}));
  EXPECT_FALSE(small.collides(shell));
  EXPECT_TRUE(small.collides(body));
  const QueryBody cube(boxHull({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1})), around(moved(box(1, 1, 1), {-0.5, -0.5, -0.5}));
  EXPECT_NEAR(distanceBelow(1, cube, around, Eigen::Isometry3d::Identity()), 0.4, 1e-6);
  EXPECT_EQ(distanceBelow(0.3, cube, around, Eigen::Isometry3d::Identity()), 0.3);
}

TEST(QueryModel, ShapesTouchUpToTheirExtent) {
  const Eigen::Isometry3d aside(Eigen::Translation3d(2, 0, 0));
  const QueryBody shapes[] = {{{QueryShape::Kind::kBox, {2, 1, 1}}, aside},
                              {{QueryShape::Kind::kSphere, {1, 0, 0}}, aside},
                              {{QueryShape::Kind::kCylinder, {1, 0.5, 0}}, aside}};
  const QueryBody probe(boxHull({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
  for (const QueryBody& shape : shapes) {
    // Each extends from x = 1 to x = 3 at the height of the probe.
    EXPECT_NEAR(shape.box().min().x(), 1, 1e-12);
    EXPECT_NEAR(shape.box().max().x(), 3, 1e-12);
    EXPECT_FALSE(touch(shape, probe, Eigen::Isometry3d(Eigen::Translation3d(0.899, 0, 0))));
    EXPECT_TRUE(touch(shape, probe, Eigen::Isometry3d(Eigen::Translation3d(0.901, 0, 0))));
    QueryModel model, other;
    model.add(0, shape, Eigen::Isometry3d(Eigen::AngleAxisd(EIGEN_PI, Eigen::Vector3d::UnitZ())));
    other.add(0, probe);
    model.place(posesAt({{0, 0, 0}}));
    other.place(posesAt({{-2, 0, 0}}));
    EXPECT_TRUE(model.collides(other));
  }
}

TEST(QueryModel, TrianglesWithoutAreaAreLeftOut) {
  TriangleMesh line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  QueryModel thin, body;
  thin.add(0, line);
  body.add(0, boxHull({0, -1, -1}, {1, 1, 1}));
  thin.place(posesAt({{0, 0, 0}}));
  body.place(posesAt({{0, 0, 0}}));
  EXPECT_FALSE(thin.collides(body));
}

}  // namespace
}  // namespace collision_hulls
