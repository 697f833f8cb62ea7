#include <gtest/gtest.h>

#include <filesystem>

#include "collision_hulls/robot/robot_description.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

class ResolveUri : public testing::Test {
 protected:
  std::string resolve(const std::string& uri) const { return resolveUri(uri, base_, finder_); }

  TemporaryFolder folder_;
  std::string base_ = folder_.path("arm/urdf/arm.urdf");
  std::string mesh_ = folder_.write("arm/meshes/a b.stl");
  PackageFinder finder_ = [this](const std::string& package) {
    return package == "arm" ? std::optional(folder_.path("arm")) : std::nullopt;
  };
};

TEST_F(ResolveUri, Empty) {
  expectError(ErrorCode::kFileNotFound, {"empty"}, [&] { resolve(""); });
}

TEST_F(ResolveUri, UnknownPackage) {
  expectError(ErrorCode::kPackageNotFound, {"'leg'", "package://leg/x.stl", "ROS_PACKAGE_PATH"}, [&] { resolve("package://leg/x.stl"); });
  expectError(ErrorCode::kPackageNotFound, {"''"}, [&] { resolve("package://"); });
  expectError(ErrorCode::kPackageNotFound, {"'arm'"}, [&] { resolveUri("package://arm/meshes/a b.stl", base_, nullptr); });
}

TEST_F(ResolveUri, MissingFile) {
  expectError(ErrorCode::kFileNotFound, {"package://arm/no.stl", folder_.path("arm/no.stl")}, [&] { resolve("package://arm/no.stl"); });
  expectError(ErrorCode::kFileNotFound, {folder_.path("arm/meshes")}, [&] { resolve("package://arm/meshes"); });
}

TEST_F(ResolveUri, UnknownScheme) {
  expectError(ErrorCode::kFileNotFound, {"http://host/x.stl", "package://"}, [&] { resolve("http://host/x.stl"); });
}

TEST_F(ResolveUri, Package) {
  EXPECT_EQ(resolve("package://arm/meshes/a b.stl"), mesh_);
  EXPECT_EQ(resolve("package:////arm//meshes///a%20b.stl"), mesh_);
  EXPECT_EQ(resolve("package://arm/urdf/../meshes/./a b.stl"), mesh_);
}

TEST_F(ResolveUri, File) {
  EXPECT_EQ(resolve("file://" + mesh_), mesh_);
  EXPECT_EQ(resolve("file://localhost" + folder_.path("arm/meshes/a%20b.stl")), mesh_);
  EXPECT_EQ(resolve("file://../meshes/a b.stl"), mesh_);
}

TEST_F(ResolveUri, Path) {
  EXPECT_EQ(resolve(mesh_), mesh_);
  EXPECT_EQ(resolve("../meshes/a b.stl"), mesh_);
}

TEST_F(ResolveUri, AboveAFolderBehindALink) {
  std::filesystem::create_directory(folder_.path("elsewhere"));
  std::filesystem::create_directory_symlink(folder_.path("arm/urdf"), folder_.path("elsewhere/urdf"));
  std::filesystem::create_directories(folder_.path("arm/urdf"));
  EXPECT_TRUE(std::filesystem::equivalent(resolveUri("../meshes/a b.stl", folder_.path("elsewhere/urdf/arm.urdf"), finder_), mesh_));
}

TEST(IsRelativeUri, EachKind) {
  for (const char* uri : {"a.stl", "../meshes/a.stl", "file://a.stl", ""}) EXPECT_TRUE(isRelativeUri(uri)) << uri;
  for (const char* uri : {"/a.stl", "file:///a.stl", "file://localhost/a.stl", "package://arm/a.stl", "http://host/a.stl"})
    EXPECT_FALSE(isRelativeUri(uri)) << uri;
}

TEST_F(ResolveUri, ALiteralPercentSignComesFirst) {
  const std::string literal = folder_.write("arm/meshes/a%20b.stl");
  EXPECT_EQ(resolve("package://arm/meshes/a%20b.stl"), literal);
  EXPECT_EQ(resolve("package://arm/meshes/a%2520b.stl"), literal);
  expectError(ErrorCode::kFileNotFound, {"100%"}, [&] { resolve("package://arm/100%"); });
}

}  // namespace
}  // namespace collision_hulls
