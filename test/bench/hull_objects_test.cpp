#include "bench/hull_objects.h"

#include <gtest/gtest.h>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "pipeline/fixtures.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Points = std::vector<Eigen::Vector3d>;

class HullObjects : public ::testing::Test {
 protected:
  std::vector<Points> read(const std::string& text) { return readHullObjects(fixtures::write(folder_ / "hulls.obj", text)); }
  void expectError(const std::string& text, const std::string& part) {
    try {
      read(text);
      ADD_FAILURE() << "no error for " << text;
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
    }
  }
  fixtures::TempFolder folder_;
};

TEST_F(HullObjects, MissingEmptyAndInvalidFiles) {
  EXPECT_TRUE(read("").empty());
  EXPECT_TRUE(read("# no object\no empty\n").empty());
  EXPECT_THROW(readHullObjects(folder_ / "missing.obj"), Error);
  expectError("v 1 2\n", "line 1");
  expectError("v 1 2 x\n", "'x'");
  expectError("v 1 2 nan\n", "finite");
  expectError("v 1 2 3\nf 1 2 1\n", "line 2");
  expectError("v 1 2 3\nf 0 1 1\n", "'0'");
}

TEST_F(HullObjects, SharedVerticesBelongToTheFacesThatUseThem) {
  const auto objects = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no a\nf 1 2 3\no b\nf 2//1 3//1 4/2/3\no none\n");
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0], (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(objects[1], (Points{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
}

TEST_F(HullObjects, NegativeIndicesCountBack) {
  const auto objects = read("o a\nv 5 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf -3 -2 -1\n");
  ASSERT_EQ(objects.size(), 1u);
  EXPECT_EQ(objects[0], (Points{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
}

TEST_F(HullObjects, PointsWithoutFaces) {
  const auto objects = read("o a\nv 0 0 0\nv 1 0 0\no b\nv 2 0 0\n");
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].size(), 2u);
  EXPECT_EQ(objects[1], (Points{{2, 0, 0}}));
}

TEST_F(HullObjects, ReadsBackWhatIsWritten) {
  const std::vector<ConvexHull> hulls{test_shapes::boxHull({0, 0, 0}, {1, 2, 3}), test_shapes::hullOf(test_shapes::sphere(0.25f, 2))};
  const auto objects = read(encodeHullsObj(hulls, "part"));
  ASSERT_EQ(objects.size(), 2u);
  for (std::size_t h = 0; h < 2; ++h) {
    ASSERT_EQ(objects[h].size(), hulls[h].vertices.size());
    for (std::size_t i = 0; i < objects[h].size(); ++i) EXPECT_EQ(objects[h][i].cast<float>(), hulls[h].vertices[i].cast<float>());
  }
}

TEST_F(HullObjects, HashDependsOnWhichPointsAreInWhichObject) {
  const auto one = read("o a\nv 0 0 0\nv 1 0 0\n"), two = read("o a\nv 0 0 0\no b\nv 1 0 0\n");
  EXPECT_EQ(hashOf(one), hashOf(read("o other\nv 0 0 0.0\nv 1e0 0 0\n")));
  EXPECT_NE(hashOf(one), hashOf(two));
  EXPECT_NE(hashOf(one), hashOf(read("o a\nv 0 0 0\nv 1.0000001 0 0\n")));
  EXPECT_EQ(hashOf(one).size(), 64u);
}

}  // namespace
}  // namespace collision_hulls
