#include "scene/reading.h"

#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;

TEST(CheckedQuaternion, IsNormalizedIfItIsARotation) {
  EXPECT_NEAR(checkedQuaternion(0, 0, 0, 1.001).norm(), 1, 1e-12);
  EXPECT_EQ(checkedQuaternion(1, 0, 0, 0).x(), 1);
  expectError(ErrorCode::kBadScene, {"length 2"}, [] { checkedQuaternion(2, 0, 0, 0); });
  expectError(ErrorCode::kBadScene, {"length"}, [] { checkedQuaternion(0, 0, 0, 0); });
}

TEST(MeshLibrary, ReadsAFileOnce) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.scene"), mesh = folder.write("a.obj", kTriangleObj);
  const PackageFinder find_package = noPackages();
  const MeshLimits limits;
  const RunControl control;
  const SceneReading how{find_package, limits, control};
  MeshLibrary library(how);
  EXPECT_EQ(library.read("a.obj", Vector3d::Ones(), scene).vertices.size(), 3u);
  std::filesystem::resize_file(mesh, 0);
  const TriangleMesh again = library.read("a.obj", Vector3d::Constant(2), scene);
  EXPECT_EQ(boundingBox(again).max().x(), 2) << "scaled, from memory";
}

// A short scene may use a large mesh many times, and each body has a copy.
TEST(MeshLibrary, AllMeshesTogetherAreNoLargerThanOneMayBe) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.scene");
  folder.write("a.obj", kTriangleObj);
  const PackageFinder find_package = noPackages();
  MeshLimits limits;
  limits.max_triangles = 3;
  const RunControl control;
  const SceneReading how{find_package, limits, control};
  MeshLibrary library(how);
  for (int i = 0; i < 3; ++i) library.read("a.obj", Vector3d::Ones(), scene);
  expectError(ErrorCode::kTooLarge, {"more than 3 triangles in all", "a.obj"}, [&] { library.read("a.obj", Vector3d::Ones(), scene); });
}

}  // namespace
}  // namespace collision_hulls
