#include "mesh/polygons.h"

#include <gtest/gtest.h>

#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

class PolygonsTest : public testing::Test {
 protected:
  static const RunControl& control() {
    static const RunControl control;
    return control;
  }
  static void addSquare(Polygons* polygons) {
    for (const int k : {0, 1, 2, 3}) polygons->addCorner(k);
    polygons->endPolygon();
  }
  static void addPoints(Polygons* polygons) {
    polygons->addPoint(0, 0, 0);
    polygons->addPoint(1, 0, 0);
    polygons->addPoint(1, 1, 0);
    polygons->addPoint(0, 1, 0);
  }
  const std::string path_ = "a.obj";
};

TEST_F(PolygonsTest, SharedOrSeparateVertices) {
  Polygons polygons(path_, 100, control());
  addSquare(&polygons);
  addSquare(&polygons);
  addPoints(&polygons);
  const LoadedMesh shared = polygons.triangles(Polygons::Vertices::kShared), separate = polygons.triangles(Polygons::Vertices::kSeparate);
  EXPECT_EQ(shared.mesh.vertices.size(), 4u);
  EXPECT_EQ(shared.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(separate.mesh.vertices.size(), 8u);
  EXPECT_EQ(separate.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}));
}

TEST_F(PolygonsTest, OtherReadingsAreWalls) {
  LoadedMesh mesh;
  mesh.mesh.vertices = {{4, 0, 1}, {1, 1, 0}, {0, 4, 1}, {0, 0, 0}};
  PolygonSink(&mesh, path_, 6, control()).add({0, 1, 2, 3});
  EXPECT_EQ(mesh.mesh.triangles, (std::vector<Triangle>{{3, 0, 1}, {1, 2, 3}, {0, 1, 2}, {0, 2, 1}, {0, 2, 3}, {0, 3, 2}}));
  mesh.mesh.triangles.clear();
  PolygonSink small(&mesh, path_, 5, control());
  EXPECT_THROW(small.add({0, 1, 2, 3}), Error);
}

TEST_F(PolygonsTest, NeverMoreTrianglesThanTheLimit) {
  Polygons polygons(path_, 3, control());
  addPoints(&polygons);
  addSquare(&polygons);
  try {
    addSquare(&polygons);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kTooLarge);
  }
}

TEST_F(PolygonsTest, NoPolygonTakesForEver) {
  LoadedMesh mesh;
  std::vector<int> polygon;
  for (int i = 0; i < 20'001; ++i) {
    mesh.mesh.vertices.emplace_back(i, i % 2, 0);
    polygon.push_back(i);
  }
  PolygonSink sink(&mesh, path_, 100'000, control());
  EXPECT_THROW(sink.add(polygon), Error);
}

TEST_F(PolygonsTest, NothingButLinesIsAnEmptyMesh) {
  Polygons polygons(path_, 3, control());
  addPoints(&polygons);
  polygons.addCorner(0);
  polygons.addCorner(1);
  polygons.endPolygon();
  polygons.skip(2);
  try {
    polygons.triangles(Polygons::Vertices::kShared);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kEmptyMesh);
    EXPECT_NE(std::string(error.what()).find("3 lines and points"), std::string::npos) << error.what();
  }
}

TEST_F(PolygonsTest, ALargePolygonCanBeCancelled) {
  RunControl cancelled;
  cancelled.cancel();
  LoadedMesh mesh;
  mesh.mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
  PolygonSink sink(&mesh, path_, 100, cancelled);
  EXPECT_THROW(sink.add({0, 1, 2, 3}), Error);
}

}  // namespace
}  // namespace collision_hulls
