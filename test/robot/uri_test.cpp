#include <gtest/gtest.h>

#include <filesystem>

#include "base/roots.h"
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
  for (const char* uri : {"package://leg/x.stl", "package://leg/y.stl"}) {
    try {
      resolve(uri);
      ADD_FAILURE() << uri;
    } catch (const Error& error) {  // the same for both, so that it can be said once
      EXPECT_EQ(error.code(), ErrorCode::kPackageNotFound);
      EXPECT_STREQ(error.what(),
                   "package 'leg' was not found: install it and source its workspace, or say where it is with --package-path leg=DIR");
    }
  }
  expectError(ErrorCode::kFileNotFound, {"''"}, [&] { resolve("package://"); });
  expectError(ErrorCode::kPackageNotFound, {"'arm'"}, [&] { resolveUri("package://arm/meshes/a b.stl", "", nullptr); });
}

// As on a system that does not tell them apart.
TEST_F(ResolveUri, AFileInOtherLettersIsNamed) {
  for (const char* uri : {"package://arm/meshes/A b.STL", "package://arm/Meshes/a b.stl", "../MESHES/a b.stl"})
    expectError(ErrorCode::kFileNotFound, {"'" + std::string(uri) + "'", "but '" + mesh_ + "' does; rename it, or correct the case"},
                [&] { resolve(uri); });
  expectError(ErrorCode::kFileNotFound, {"which does not exist; check the URI"}, [&] { resolve("package://arm/meshes/ab.stl"); });
  const PackageFinder near = defaultPackageFinder(base_);  // a folder stands in for the package
  const std::string other = folder_.write("arm/parts/Leg.stl");
  expectError(ErrorCode::kFileNotFound, {"'package://parts/leg.STL' was not found, but '" + other + "' was; rename it"},
              [&] { resolveUri("package://parts/leg.STL", base_, near); });
  const Confinement confinement({{folder_.path("arm/urdf")}, {}, {}, {}, "", ""});
  expectError(ErrorCode::kFileNotFound, {"which does not exist; check the URI"},
              [&] { resolveUri("../meshes/A b.STL", base_, defaultPackageFinder(base_)); });
}

TEST_F(ResolveUri, AModelIsAPackage) {
  EXPECT_EQ(resolve("model://arm/meshes/a%20b.stl"), mesh_);
  EXPECT_EQ(packageOf("model://arm/meshes/a.stl"), std::optional<std::string>("arm"));
  EXPECT_FALSE(isRelativeUri("model://arm/meshes/a.stl"));
  expectError(ErrorCode::kPackageNotFound, {"'leg'", "--package-path leg=DIR"}, [&] { resolve("model://leg/x.stl"); });
  expectError(ErrorCode::kOutsideRoots, {"leads out of 'arm'"}, [&] { resolve("model://arm/../x.stl"); });
}

TEST_F(ResolveUri, MissingFile) {
  expectError(ErrorCode::kFileNotFound, {"package://arm/no.stl", folder_.path("arm/no.stl")}, [&] { resolve("package://arm/no.stl"); });
}

TEST_F(ResolveUri, AFolderIsNoFile) {
  const std::string folder = folder_.path("arm/meshes");
  expectError(ErrorCode::kFileNotFound, {"resolves to '" + folder + "', which is a folder; give a file in it"},
              [&] { resolve("package://arm/meshes"); });
  expectError(ErrorCode::kFileNotFound, {"'" + folder + "' is a folder; give a file in it"}, [&] { resolve(folder); });
  const Confinement confinement({{folder_.path("arm/urdf")}, {}, {}, {}, "", ""});
  expectError(ErrorCode::kFileNotFound, {"'" + folder + "' does not exist; check the path"}, [&] { resolve(folder); });
}

TEST_F(ResolveUri, TheMessageHasAnAbsolutePath) {
  const std::string here = std::filesystem::current_path().string();
  expectError(ErrorCode::kFileNotFound, {"'meshes/a.stl' resolves to '" + here + "/robots/meshes/a.stl', which does not exist"},
              [&] { resolveUri("meshes/a.stl", "robots/arm.urdf", finder_); });
  expectError(ErrorCode::kFileNotFound, {"'/no/such/a.stl' does not exist, nor does the folder '/no'; check the path"},
              [&] { resolve("/no/such/a.stl"); });
}

TEST_F(ResolveUri, AMissingFolderIsNamed) {
  const std::string folder = "which does not exist, nor does the folder '" + folder_.path("arm/visual") + "'; check the URI";
  expectError(ErrorCode::kFileNotFound, {folder}, [&] { resolve("package://arm/visual/fine/a.stl"); });
  const Confinement confinement({{folder_.path("arm/urdf")}, {}, {}, {}, "", ""});
  expectError(ErrorCode::kFileNotFound, {"which does not exist; check the URI"},
              [&] { resolveUri("../visual/a.stl", base_, defaultPackageFinder(base_)); });
}

TEST_F(ResolveUri, AFileThatAnotherMachineHasIsNamedWhereItLiesHere) {
  const std::string here = "'../meshes/" + std::filesystem::path(mesh_).filename().string() + "' does, from the description's folder; give";
  const std::string name = std::filesystem::path(mesh_).filename().string();
  expectError(ErrorCode::kFileNotFound, {"nor does the folder '/home/nobody'", here},
              [&] { resolve("file:///home/nobody/ws/src/arm/meshes/" + name); });
  expectError(ErrorCode::kFileNotFound, {"/" + name + "' does not exist", "; check the path"}, [&] { resolve("/home/nobody/" + name); });
  expectError(ErrorCode::kFileNotFound, {"'meshes/" + name + "' resolves to '", here}, [&] { resolve("meshes/" + name); });
  const Confinement confinement({{folder_.path("arm/urdf")}, {}, {}, {}, "", ""});
  expectError(ErrorCode::kFileNotFound, {"; check the"}, [&] { resolve("/home/nobody/arm/meshes/" + name); });
}

TEST_F(ResolveUri, UnknownScheme) {
  expectError(ErrorCode::kFileNotFound, {"http://host/x.stl", "package://"}, [&] { resolve("http://host/x.stl"); });
}

TEST_F(ResolveUri, ControlCharacters) {
  for (const std::string& uri : {std::string("package://arm/meshes/a%00b.stl"), std::string("package://arm/meshes/a b.stl\0x", 29),
                                 mesh_ + "%00", mesh_ + "\n", mesh_ + "%7f", mesh_ + "%0A"})
    expectError(ErrorCode::kFileNotFound, {"control character"}, [&] { resolve(uri); });
}

TEST_F(ResolveUri, LongerThanAnyPath) {
  expectError(ErrorCode::kFileNotFound, {"'/aaa", "aaa' has 5000000 bytes"}, [&] { resolve("/" + std::string(4999999, 'a')); });
}

TEST_F(ResolveUri, NamesThatAreNoPackages) {
  const PackageFinder finder = [](const std::string& package) -> std::optional<std::string> {
    ADD_FAILURE() << "a program would be asked for '" << package << "'";
    return std::nullopt;
  };
  for (const char* uri : {"package://-h/x.stl", "package://--help/x.stl", "package://%2dh/x.stl", "package://a;b/x.stl",
                          "package://a b/x.stl", "package://../x.stl", "package://.hidden/x.stl", "package://$(x)/x.stl"})
    expectError(ErrorCode::kFileNotFound, {"is not a package's name"}, [&] { resolveUri(uri, base_, finder); });
}

TEST_F(ResolveUri, OutOfAPackage) {
  folder_.write("secret.stl");
  for (const char* uri : {"package://arm/../secret.stl", "package://arm/meshes/../../secret.stl", "package://arm/%2e%2e/secret.stl",
                          "package://arm/..%2fsecret.stl", "package://arm/../arm/meshes/a b.stl"})
    expectError(ErrorCode::kOutsideRoots, {"leads out of 'arm'"}, [&] { resolve(uri); });
}

TEST_F(ResolveUri, DecodedOnce) {
  folder_.write("arm/meshes/a%41.stl");
  EXPECT_EQ(resolve("package://arm/meshes/a%2541.stl"), folder_.path("arm/meshes/a%41.stl"));
  EXPECT_EQ(resolve("package://%61rm/meshes/a%20b.stl"), mesh_);
  expectError(ErrorCode::kFileNotFound, {"'%61rm'"}, [&] { resolve("package://%2561rm/meshes/a b.stl"); });
}

TEST_F(ResolveUri, AHost) {
  expectError(ErrorCode::kFileNotFound, {"names the host 'server'", "file:///PATH"}, [&] { resolve("file://server/share/a.stl"); });
  EXPECT_EQ(resolve("file://" + folder_.write("arm/urdf/meshes/c.stl").substr(folder_.path("arm/urdf/").size())),
            folder_.path("arm/urdf/meshes/c.stl"));
}

TEST_F(ResolveUri, FormsThatMeanNothingHere) {
  const std::pair<std::string, std::string> forms[] = {{"C:\\arm\\a.stl", "separated by '/'"},
                                                       {"~/arm/a.stl", "give the whole path"},
                                                       {"package:/arm/a.stl", "package://NAME/PATH"},
                                                       {"b.stl", "check the URI"}};
  for (const auto& [uri, remedy] : forms) expectError(ErrorCode::kFileNotFound, {"'" + uri + "'", remedy}, [&] { resolve(uri); });
}

TEST_F(ResolveUri, OutsideOfTheRoots) {
  const std::string outside = folder_.write("outside/a.stl");
  std::filesystem::create_directories(folder_.path("arm/urdf"));
  std::filesystem::create_symlink(outside, folder_.path("arm/urdf/link.stl"));
  const Confinement confinement({{folder_.path("arm/urdf")}, {}, {}, {}, "set ~read_roots", ""});
  EXPECT_EQ(resolve("package://arm/meshes/a b.stl"), mesh_) << "a package may be read";
  for (const std::string& uri : {outside, "file://" + outside, std::string("link.stl"), std::string("../../outside/a.stl")})
    expectError(ErrorCode::kOutsideRoots, {outside, "set ~read_roots"}, [&] { resolve(uri); });
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
  EXPECT_EQ(resolve("file:" + mesh_), mesh_);
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
  folder_.write("elsewhere/meshes/a b.stl");  // what the name without ".." would be
  EXPECT_TRUE(std::filesystem::equivalent(resolveUri("../meshes/a b.stl", folder_.path("elsewhere/urdf/arm.urdf"), finder_), mesh_));
}

TEST(IsRelativeUri, EachKind) {
  for (const char* uri : {"a.stl", "../meshes/a.stl", "file://a.stl", ""}) EXPECT_TRUE(isRelativeUri(uri)) << uri;
  for (const char* uri : {"/a.stl", "file:///a.stl", "file://localhost/a.stl", "file:/a.stl", "package://arm/a.stl", "http://host/a.stl"})
    EXPECT_FALSE(isRelativeUri(uri)) << uri;
}

TEST_F(ResolveUri, ALiteralPercentSignComesFirst) {
  const std::string literal = folder_.write("arm/meshes/a%20b.stl");
  EXPECT_EQ(resolve("package://arm/meshes/a%20b.stl"), literal);
  EXPECT_EQ(resolve("package://arm/meshes/a%2520b.stl"), literal);
  expectError(ErrorCode::kFileNotFound, {"100%"}, [&] { resolve("package://arm/100%"); });
}

/// A description without its packages; what is nearby?
class Nearby : public testing::Test {
 protected:
  std::string resolve(const std::string& uri) const { return resolveUri(uri, base_, finder_); }
  void expectMissing(const std::string& uri) const {
    expectError(ErrorCode::kPackageNotFound, {"'" + packageOf(uri).value() + "'"}, [&] { resolve(uri); });
  }

  TemporaryFolder folder_;
  std::string base_ = folder_.write("lab/robots/arm/urdf/arm.urdf");
  PackageFinder finder_;
};

TEST_F(Nearby, AFolderOfThePackagesName) {
  const std::string far = folder_.write("lab/arm_meshes/visual/base.stl");
  EXPECT_EQ(resolve("package://arm_meshes/visual/base.stl"), far);
  EXPECT_EQ(finder_.notes(), (std::vector<std::string>{"package 'arm_meshes' was not found: the folder '" + folder_.path("lab/arm_meshes") +
                                                       "' was used in its place"}));
  const std::string near = folder_.write("lab/robots/arm_meshes/visual/base.stl");
  EXPECT_EQ(resolve("package://arm_meshes/visual/base.stl"), near) << "the nearest folder first";
  EXPECT_EQ(finder_.notes().size(), 2u);
}

TEST_F(Nearby, TheRestOfTheUri) {
  const std::string mesh = folder_.write("lab/robots/arm/meshes/base.stl");
  EXPECT_EQ(resolve("package://other_description/meshes/base.stl"), mesh);
  EXPECT_EQ(resolve("package://other_description/meshes/../meshes/./base.stl"), mesh);
  EXPECT_EQ(finder_.notes(), (std::vector<std::string>{"package 'other_description' was not found: the folder '" +
                                                       folder_.path("lab/robots/arm") + "' was used in its place"}));
  const std::string named = folder_.write("other_description/meshes/base.stl");
  EXPECT_EQ(resolve("package://other_description/meshes/base.stl"), named) << "a folder of the name is likelier, even if farther";
}

TEST_F(Nearby, AFileThatAStandInLacks) {
  expectMissing("package://other_description/meshes/tip.stl");
  folder_.write("lab/robots/arm/meshes/base.stl");
  resolve("package://other_description/meshes/base.stl");
  expectError(ErrorCode::kFileNotFound,
              {"'package://other_description/meshes/tip.stl' does not exist in '" + folder_.path("lab/robots/arm") +
               "', which is used in place of package 'other_description': correct the URI, or say where the package is with "
               "--package-path other_description=DIR"},
              [&] { resolve("package://other_description/meshes/tip.stl"); });
}

TEST_F(Nearby, APackagesNameBelowMeshes) {
  const std::string mesh = folder_.write("lab/robots/arm/meshes/visual/base%20link.dae");
  EXPECT_EQ(resolve("package://visual/base%20link.dae"), mesh);
  EXPECT_EQ(resolve("package://visual/base%2520link.dae"), mesh);
}

TEST_F(Nearby, ABareFileNameCountsOnlyNextToTheDescription) {
  const std::string mesh = folder_.write("lab/robots/base.stl");
  folder_.write("lab/robots/arm/meshes/base.stl");
  expectMissing("package://arm_description/base.stl");
  EXPECT_EQ(finder_.notes().size(), 0u);
  const std::string beside = folder_.write("lab/robots/arm/base.stl");
  EXPECT_EQ(resolve("package://arm_description/base.stl"), beside);
}

TEST_F(Nearby, NothingOutOfThePackage) {
  folder_.write("lab/secret/base.stl");
  folder_.write("lab/robots/secret/base.stl");
  for (const char* uri : {"package://arm/../../secret/base.stl", "package://../secret/base.stl", "package://arm/", "package:///"})
    EXPECT_THROW(resolve(uri), Error) << uri;
}

TEST_F(Nearby, PackagePathComesFirst) {
  folder_.write("lab/robots/visual/base.stl");
  const std::string given = folder_.write("given/meshes/visual/base.stl"), bare = folder_.write("given/tool.stl");
  finder_ = defaultPackageFinder("", {folder_.path("given")});
  EXPECT_EQ(resolve("package://visual/base.stl"), given);
  EXPECT_EQ(resolve("package://tool_description/tool.stl"), bare);
}

TEST_F(Nearby, APackageThatLacksTheFile) {
  const std::string mesh = folder_.write("lab/robots/arm/meshes/new.stl");
  finder_ = PackageFinder([this](const std::string&) { return std::optional(folder_.path("installed")); });
  EXPECT_EQ(resolve("package://arm/meshes/new.stl"), mesh);
  EXPECT_NE(finder_.notes().at(0).find("package 'arm' in '" + folder_.path("installed") + "' lacks some of its files"), std::string::npos)
      << finder_.notes()[0];
  std::filesystem::create_directories(folder_.path("installed"));
  finder_ = defaultPackageFinder("", {"arm=" + folder_.path("installed")});
  expectError(ErrorCode::kFileNotFound, {folder_.path("installed/meshes/new.stl")}, [&] { resolve("package://arm/meshes/new.stl"); });
}

TEST(PackageOf, Uris) {
  EXPECT_EQ(packageOf("package://arm/meshes/a.stl"), "arm");
  EXPECT_EQ(packageOf("package:///arm"), "arm");
  EXPECT_EQ(packageOf("file:///arm/a.stl"), std::nullopt);
}

}  // namespace
}  // namespace collision_hulls
