#include "scene/model_uri.h"

#include "scene/scene_tests.h"

namespace collision_hulls {
namespace {

TEST(ModelUri, FoldersOfVariablesComeFirst) {
  const TemporaryFolder folder;
  folder.write("set/cup/mesh.stl");
  folder.write("world/models/cup/mesh.stl");
  const std::string world = folder.write("world/cell.sdf");
  EXPECT_EQ(resolveModelUri("model://cup/mesh.stl", world, noPackages()), folder.path("world/models/cup/mesh.stl"));
  const ScopedVariable variable("SDF_PATH", "/nowhere:" + folder.path("set"));
  EXPECT_EQ(resolveModelUri("model://cup/mesh.stl", world, noPackages()), folder.path("set/cup/mesh.stl"));
}

TEST(ModelUri, APackageComesLast) {
  const TemporaryFolder folder;
  folder.write("share/cups/small/mesh.stl");
  const PackageFinder packages = [&](const std::string& name) {
    return name == "cups" ? std::optional<std::string>(folder.path("share/cups")) : std::nullopt;
  };
  EXPECT_EQ(resolveModelUri("model://cups/small/mesh.stl", folder.path("w.sdf"), packages), folder.path("share/cups/small/mesh.stl"));
}

TEST(ModelUri, SaysWhereToPutWhatIsMissing) {
  const TemporaryFolder folder;
  expectError(ErrorCode::kPackageNotFound, {"model://none/a.stl", "GAZEBO_MODEL_PATH"},
              [&] { resolveModelUri("model://none/a.stl", folder.path("w.sdf"), noPackages()); });
  expectError(ErrorCode::kUnsupportedFormat, {"download"},
              [&] { resolveModelUri("https://example.com/a.stl", folder.path("w.sdf"), noPackages()); });
}

}  // namespace
}  // namespace collision_hulls
