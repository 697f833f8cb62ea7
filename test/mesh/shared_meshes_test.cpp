// Real meshes, if they are available.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;

const fs::path kMeshes = fs::path(SHARED_DATA) / "meshes";

class SharedMeshes : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kMeshes)) GTEST_SKIP() << "no meshes at " << kMeshes;
  }
  static RepairedMesh repaired(const std::string& name) { return repair(readMesh((kMeshes / name).string()).mesh); }
};

/// What must hold for every repaired mesh.
void expectSound(const LoadedMesh& loaded, const RepairedMesh& repaired) {
  const RepairCounts& counts = repaired.counts;
  EXPECT_EQ(loaded.mesh.triangles.size(), repaired.mesh.triangles.size() + counts.degenerate + counts.duplicate);
  EXPECT_EQ(repaired.component.size(), repaired.mesh.triangles.size());
  EXPECT_EQ(repaired.interior.size(), counts.components);
  EXPECT_LE(counts.weld_distance, 20 * 1e-5 * boundingBox(loaded.mesh).sizes().maxCoeff());
  EXPECT_LE(static_cast<double>(counts.degenerate), 0.01 * static_cast<double>(loaded.mesh.triangles.size())) << "fine features are lost";
  const RepairedMesh again = repair(repaired.mesh);
  EXPECT_EQ(repaired.mesh.triangles, again.mesh.triangles) << "a second repair must find nothing to do";
}

TEST_F(SharedMeshes, EveryMeshOfEveryRobotIsReadAndRepaired) {
  std::size_t read = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(SHARED_DATA) / "robots")) {
    std::string extension = entry.path().extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) { return static_cast<char>(std::tolower(c)); });
    const std::vector<std::string>& known = meshExtensions();
    if (std::find(known.begin(), known.end(), extension) == known.end()) continue;
    SCOPED_TRACE(entry.path().string());
    const LoadedMesh loaded = readMesh(entry.path().string());
    expectSound(loaded, repair(loaded.mesh));
    ++read;
  }
  EXPECT_GT(read, 50u);
}

TEST_F(SharedMeshes, JitteredSoupBecomesClosed) {
  const RepairedMesh mesh = repaired("broken/soup_jittered.stl");
  EXPECT_EQ(1u, mesh.counts.components);
  EXPECT_EQ(Interior::kClosed, interiorOf(mesh));
}

TEST_F(SharedMeshes, HalfFlippedTeddyFacesOutward) {
  const RepairedMesh mesh = repaired("broken/flipped_half.obj");
  EXPECT_EQ(Interior::kClosed, interiorOf(mesh));
  EXPECT_NEAR(0.0385, signedVolume(mesh.mesh), 1e-4);
}

TEST_F(SharedMeshes, ChairWithDuplicateFacesHasAnInside) {
  const RepairedMesh mesh = repaired("broken/chair_model.obj");
  EXPECT_GE(mesh.counts.duplicate, 12756u / 2);
  EXPECT_GT(signedVolume(mesh.mesh), 0);
  EXPECT_EQ(0, std::count(mesh.interior.begin(), mesh.interior.end(), Interior::kSurface));
}

TEST_F(SharedMeshes, CracksBetweenPatchesAreWelded) {
  EXPECT_EQ(0u, repaired("broken/featuretype.STL").counts.open_edges);
}

TEST_F(SharedMeshes, RejectsATinyMeshFarAway) {
  try {
    readMesh((kMeshes / "broken/tiny_far.obj").string());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(ErrorCode::kTooFarFromOrigin, error.code());
  }
}

}  // namespace
}  // namespace collision_hulls
