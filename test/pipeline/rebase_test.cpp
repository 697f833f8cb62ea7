// A description in a package, and one beside it: their relative file names from a new place.
#include "pipeline/package/rebase.h"

#include <gtest/gtest.h>

#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using fixtures::link;
using fixtures::meshTag;

constexpr const char* kManifest = "<package><name>my_arm</name></package>";

class Rebase : public ::testing::Test {
 protected:
  Rebase() {
    options_.rebase = true;
    fixtures::write(folder_ / "arm/package.xml", kManifest);
    for (const char* file : {"arm/meshes/a & b.obj", "arm/meshes/it's 100%20.obj", "arm/urdf/skin.png", "loose/c.obj"})
      fixtures::write(folder_ / file, "");
  }

  RobotDescription described(const std::string& content) const {
    return readRobotDescription(fixtures::write(folder_ / "arm/urdf/arm.urdf", fixtures::robot("arm", content)));
  }
  RebasedDescription rebase(const std::string& content, const std::map<std::string, std::string>& moved = {}) const {
    return rebased(described(content), defaultPackageFinder(folder_ / "arm/urdf/arm.urdf", path_), options_, new_file_, moved, {});
  }
  /// Of a visual with this URI.
  std::string newUri(const std::string& uri) const {
    return rebase(link("a", "<visual>" + meshTag(uri) + "</visual>")).robot.links[0].visuals[0].uri;
  }
  std::string fileUriOf(const std::string& file) const { return fileUri(folder_ / file); }

  fixtures::TempFolder folder_;
  const std::string new_file_ = folder_ / "deep/out/urdf/arm.urdf";
  Options options_;
  std::vector<std::string> path_;
};

TEST_F(Rebase, NothingUnlessAsked) {
  options_.rebase = false;
  const RobotDescription robot = described(link("a", "<visual>" + meshTag("skin.png") + "</visual>"));
  const RebasedDescription same = rebased(robot, defaultPackageFinder(), options_, new_file_, {}, {});
  EXPECT_EQ(same.robot.text, robot.text);
  EXPECT_EQ(same.base, robot.path);
  EXPECT_TRUE(same.uris.empty());
}

TEST_F(Rebase, EachStyleLeadsToTheSameFile) {
  const std::vector<std::pair<std::string, std::string>> files{{"../meshes/a &amp; b.obj", "arm/meshes/a & b.obj"},
                                                               {"../meshes/a%20&#38; b.obj", "arm/meshes/a & b.obj"},
                                                               {"../meshes/it's 100%20.obj", "arm/meshes/it's 100%20.obj"},
                                                               {"file://skin.png", "arm/urdf/skin.png"},
                                                               {"./../../loose/c.obj", "loose/c.obj"}};
  const PackageFinder finder = defaultPackageFinder(folder_ / "arm/urdf/arm.urdf");
  for (const auto& [uri, file] : files) {
    for (const UriStyle style : {UriStyle::kPackage, UriStyle::kFile, UriStyle::kRelative}) {
      options_.uri = style;
      const std::string now = newUri(uri);
      EXPECT_EQ(resolveUri(now, new_file_, finder), folder_ / file) << now;
      EXPECT_EQ(isRelativeUri(now), style == UriStyle::kRelative) << now;
    }
  }
}

TEST_F(Rebase, APackageThatAFolderStandsInFor) {
  EXPECT_EQ(newUri("package://meshes/it's 100%2520.obj"), "package://my_arm/meshes/it's%20100%2520.obj");
  EXPECT_EQ(newUri("package://nowhere/x.obj"), "package://nowhere/x.obj") << "nothing stands in";
  path_ = {folder_ / "arm"};
  EXPECT_EQ(newUri("package://my_arm/urdf/skin.png"), "package://my_arm/urdf/skin.png") << "it is known";
}

TEST_F(Rebase, TheStyles) {
  EXPECT_EQ(newUri("../meshes/a &amp; b.obj"), "package://my_arm/meshes/a%20&%20b.obj");
  EXPECT_EQ(newUri("../../loose/c.obj"), fileUriOf("loose/c.obj")) << "in no package";
  options_.uri = UriStyle::kFile;
  EXPECT_EQ(newUri("skin.png"), fileUriOf("arm/urdf/skin.png"));
  options_.uri = UriStyle::kRelative;
  EXPECT_EQ(newUri("skin.png"), "../../../arm/urdf/skin.png");
}

TEST_F(Rebase, APackageThatLeadsElsewhereIsNotNamed) {
  fixtures::write(folder_ / "other/package.xml", kManifest);
  path_ = {"my_arm=" + folder_ / "other"};
  EXPECT_EQ(newUri("skin.png"), fileUriOf("arm/urdf/skin.png"));
  fixtures::write(folder_ / "other/urdf/skin.png", "");
  EXPECT_EQ(newUri("skin.png"), fileUriOf("arm/urdf/skin.png")) << "of the same name, but another file";
}

TEST_F(Rebase, WhatIsNotRelativeOrNotFoundStays) {
  for (const std::string& uri : {std::string("gone.obj"), std::string("package://my_arm/urdf/skin.png"), fileUriOf("loose/c.obj"),
                                 folder_ / "loose/c.obj", std::string("http://a/b.obj"), std::string("..")})
    EXPECT_EQ(newUri(uri), uri);
}

// The elements that stay, their textures, and nothing else.
TEST_F(Rebase, TheseAttributesAlone) {
  const auto content = [](const std::string& uri) {
    const std::string texture = "<material name='m'><texture filename='" + uri + "'/></material>";
    return texture + "<link name='a'><!-- filename='skin.png' --><visual  ><geometry><mesh scale='1 1 1'\n filename = \"" + uri +
           "\" ></mesh></geometry>" + texture + "</visual>\r\n<collision><geometry><mesh filename='" + uri +
           "'/></geometry></collision><x><mesh filename='skin.png'/></x></link><gazebo><mesh filename='skin.png'/>" +
           "<plugin filename='skin.png'/></gazebo>";
  };
  const RebasedDescription result = rebase(content("skin.png"));
  const std::string uri = "package://my_arm/urdf/skin.png";
  EXPECT_EQ(result.robot.text, fixtures::robot("arm", content(uri)));
  EXPECT_EQ(result.robot.links[0].collisions[0].uri, uri);
  EXPECT_EQ(result.uris, std::set<std::string>{uri});
  EXPECT_EQ(result.base, new_file_);
}

TEST_F(Rebase, HullsOfEarlierRunsAreMovedByOthers) {
  const std::string both = "<visual>" + meshTag("skin.png") + "</visual><collision>" + meshTag("skin.png") + "</collision>";
  const RobotDescription robot = rebase(link("a", both), {{"skin.png", "package://out/meshes/0.stl"}}).robot;
  EXPECT_EQ(robot.links[0].visuals[0].uri, "package://my_arm/urdf/skin.png");
  EXPECT_EQ(robot.links[0].collisions[0].uri, "skin.png");
  EXPECT_EQ(fixtures::count(robot.text, "filename=\"skin.png\""), 1u);
}

}  // namespace
}  // namespace collision_hulls
