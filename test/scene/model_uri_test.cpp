#include "scene/model_uri.h"

#include "base/roots.h"
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

TEST(ModelUri, NothingOutOfAModel) {
  const TemporaryFolder folder;
  folder.write("world/models/cup/mesh.stl");
  folder.write("world/secret.stl");
  for (const char* uri : {"model://cup/../../secret.stl", "model://../secret.stl", "model://cup/../cup/mesh.stl"})
    expectError(ErrorCode::kOutsideRoots, {"leads out of"}, [&] { resolveModelUri(uri, folder.path("world/cell.sdf"), noPackages()); });
  expectError(ErrorCode::kFileNotFound, {"control character"},
              [&] { resolveModelUri("model://cup/mesh%00.stl", folder.path("world/cell.sdf"), noPackages()); });
}

TEST(ModelUri, OutsideOfTheRoots) {
  const TemporaryFolder folder;
  const std::string mesh = folder.write("world/models/cup/mesh.stl");
  const Confinement confinement({{folder.path("other")}, {}, {}, {}, "set ~read_roots", ""});
  expectError(ErrorCode::kOutsideRoots, {mesh},
              [&] { resolveModelUri("model://cup/mesh.stl", folder.path("world/cell.sdf"), noPackages()); });
}

}  // namespace
}  // namespace collision_hulls
