// MoveIt's .scene files in both versions of the format.
#include <cmath>

#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

constexpr char kTurn[] = "0 0 0.70710678 0.70710678\n";  // a quarter about z

TEST(MoveItScene, ObjectsWithPoses) {
  const TemporaryFolder folder;
  const Scene scene =
      sceneOf(folder, "a.scene",
              "my scene\n"
              "* big table\n1 0 0\n0 0 0 1\n1\nbox\n1 2 0.5\n0 0 1\n0 0 0 1\n0.5 0.5 0.5 1\n"
              "2\ntop left\n0 0 0\n0 0 0 1\nhandle\n1 2 3\n0 0 0 1\n"
              "* bottle\n0 1 0\n" +
                  std::string(kTurn) + "2\ncylinder\n0.1 1\n0 0 0\n0 0 0 1\n0 0 0 0\nsphere\n0.2\n1 0 0\n0 0 0 1\n0 0 0 0\n0\n.\n");
  EXPECT_EQ(scene.name, "my scene");
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.bodies[0].name, "big table");
  expectBox(scene.bodies[0], {0.5, -1, 0.75}, {1.5, 1, 1.25});
  EXPECT_EQ(scene.bodies[1].name, "bottle/1");
  EXPECT_EQ(scene.bodies[2].name, "bottle/2");
  EXPECT_LT((scene.bodies[2].pose.translation() - Eigen::Vector3d(0, 2, 0)).norm(), 1e-7);
}

TEST(MoveItScene, ObjectsWithoutPoses) {
  const TemporaryFolder folder;
  const Scene scene = sceneOf(folder, "a.scene",
                              "(noname)+\n* box1\n1\nbox\n0.2 0.4 0.6\n0.5 0 0.3\n" + std::string(kTurn) +
                                  "0 0 0 0\n* tip\r\n1\r\ncone\r\n0.1 0.4\r\n0 0 0\r\n0 0 0 1\r\n0 0 0 0\r\n.\r\n");
  ASSERT_EQ(scene.bodies.size(), 2u);
  expectBox(scene.bodies[0], {0.3, -0.1, 0}, {0.7, 0.1, 0.6}, 1e-6);
  EXPECT_EQ(scene.bodies[1].name, "tip");
  EXPECT_NEAR(boxOf(scene.bodies[1]).max().z(), 0.2, 1e-12);
}

TEST(MoveItScene, MeshesAndPlanes) {
  const TemporaryFolder folder;
  const Scene scene = sceneOf(folder, "a.scene",
                              "s\n* m\n0 0 1\n0 0 0 1\n1\nmesh\n3 1\n0 0 0\n1 0 0\n0 1 0\n0 1 2\n0 0 1\n0 0 0 1\n0 0 0 0\n0\n"
                              "* floor\n0 0 0\n0 0 0 1\n1\nplane\n0 0 1 0.5\n0 0 0\n0 0 0 1\n0 0 0 0\n0\n.\n");
  ASSERT_EQ(scene.bodies.size(), 2u);
  ASSERT_TRUE(std::holds_alternative<TriangleMesh>(scene.bodies[0].shape));
  expectBox(scene.bodies[0], {0, 0, 2}, {1, 1, 2});
  const double side = kPlaneSide / 2;
  expectBox(scene.bodies[1], {-side, -side, -0.5 - kPlaneDepth}, {side, side, -0.5});
}

TEST(MoveItScene, ErrorsNameTheFaultAndTheLine) {
  const TemporaryFolder folder;
  const auto expectBad = [&](const std::vector<std::string>& parts, const std::string& text) {
    expectError(ErrorCode::kBadScene, parts, [&] { sceneOf(folder, "a.scene", text); });
  };
  const std::string begin = "s\n* a\n1\n", end = "0 0 0\n0 0 0 1\n0 0 0 0\n.\n";
  expectBad({"a.scene", "ends"}, "");
  expectBad({"line 2", "'x'"}, "s\nx\n");
  expectBad({"line 2", "no name"}, "s\n*\n1\n");
  expectBad({"line 4", "'pyramid'", "box"}, begin + "pyramid\n1\n" + end);
  expectBad({"line 5", "a box of 1 x 0 x 1 m"}, begin + "box\n1 0 1\n" + end);
  expectBad({"line 5", "'nan'"}, begin + "box\n1 nan 1\n" + end);
  expectBad({"line 7", "quaternion of length 0"}, begin + "sphere\n1\n0 0 0\n0 0 0 0\n0 0 0 0\n.\n");
  expectBad({"shapes", "-1"}, "s\n* a\n-1\n.\n");
  expectBad({"shapes"}, "s\n* a\n1.5\n.\n");
  expectBad({"ends"}, begin + "box\n1 1 1\n0 0 0\n");
  expectBad({"ends"}, "s\n* a\n4000000\nbox 1 1 1");
  expectBad({"vertices", "4294967295"}, begin + "mesh\n4294967295 1\n");
  expectBad({"line 9", "vertex 3", "3 vertices"}, begin + "mesh\n3 1\n0 0 0\n1 0 0\n0 1 0\n0 1 3\n" + end);
  expectBad({"'a'", "without triangles"}, begin + "mesh\n0 0\n" + end);
  expectBad({"'a'", "twice"}, begin + "box\n1 1 1\n" + end.substr(0, end.size() - 2) + "* a\n1\nbox\n1 1 1\n" + end);
}

}  // namespace
}  // namespace collision_hulls
