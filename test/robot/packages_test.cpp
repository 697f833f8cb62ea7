// Also tests src/robot/descriptions_in_package.cpp.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <thread>

#include "collision_hulls/robot/robot_description.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

std::string manifest(const std::string& name) {
  return "<?xml version='1.0'?>\n<package>\n  <name> " + name + "\n</name>\n</package>\n";
}

class Packages : public testing::Test {
 protected:
  std::optional<std::string> find(const std::string& package, const std::string& near = "") const {
    const ScopedVariable path("ROS_PACKAGE_PATH", ros_path_), prefix("CMAKE_PREFIX_PATH", prefix_path_);
    return defaultPackageFinder(near)(package);
  }

  TemporaryFolder folder_;
  std::string ros_path_ = folder_.path("nowhere") + "::" + folder_.path("src") + "/", prefix_path_;
};

TEST_F(Packages, UnknownOnes) {
  folder_.write("src/a/package.xml", manifest("a"));
  for (const char* name : {"", ".", "..", "b", "a/b", "../a"}) EXPECT_EQ(find(name), std::nullopt) << name;
}

TEST_F(Packages, ThePathItselfMayBeOne) {
  folder_.write("src/package.xml", manifest("whole"));
  EXPECT_EQ(find("whole"), folder_.path("src"));
}

TEST_F(Packages, CrawlGoesDownAndTakesTheManifestsName) {
  folder_.write("src/group/deep/folder/package.xml", manifest("arm"));
  EXPECT_EQ(find("arm"), folder_.path("src/group/deep/folder"));
  EXPECT_EQ(find("folder"), std::nullopt);
}

TEST_F(Packages, OldManifestsAreNamedByTheirFolder) {
  folder_.write("src/old/manifest.xml", "<package/>");
  EXPECT_EQ(find("old"), folder_.path("src/old"));
}

TEST_F(Packages, CrawlStopsWhereRospackDoes) {
  folder_.write("src/a/package.xml", manifest("a"));
  folder_.write("src/a/inner/package.xml", manifest("inner"));
  folder_.write("src/off/CATKIN_IGNORE");
  folder_.write("src/off/b/package.xml", manifest("off"));
  folder_.write("src/flat/rospack_nosubdirs");
  folder_.write("src/flat/c/package.xml", manifest("flat_c"));
  folder_.write("src/.hidden/d/package.xml", manifest("hidden"));
  for (const char* name : {"inner", "off", "flat_c", "hidden"}) EXPECT_EQ(find(name), std::nullopt) << name;
}

TEST_F(Packages, FirstOfANameCounts) {
  folder_.write("other/z/package.xml", manifest("arm"));
  folder_.write("src/b/package.xml", manifest("arm"));
  folder_.write("src/a/package.xml", manifest("arm"));
  EXPECT_EQ(find("arm"), folder_.path("src/a"));
  ros_path_ = folder_.path("other") + ":" + folder_.path("src");
  EXPECT_EQ(find("arm"), folder_.path("other/z"));
}

TEST_F(Packages, BrokenManifestsAndLinkLoopsAreSurvived) {
  folder_.write("src/broken/package.xml", "<package><name>");
  folder_.write("src/nameless/package.xml", "<package><name/></package>");
  folder_.write("src/z/arm/package.xml", manifest("arm"));
  std::filesystem::create_directory_symlink(folder_.path("src"), folder_.path("src/loop"));
  EXPECT_EQ(find("arm"), folder_.path("src/z/arm"));
  EXPECT_EQ(find("broken"), folder_.path("src/broken"));
  EXPECT_EQ(find("nameless"), folder_.path("src/nameless"));
}

TEST_F(Packages, EnclosingPackageComesFirst) {
  folder_.write("src/arm/package.xml", manifest("arm"));
  folder_.write("mine/checkout/package.xml", manifest("arm"));
  const std::string urdf = folder_.write("mine/checkout/urdf/arm.urdf");
  EXPECT_EQ(find("arm", urdf), folder_.path("mine/checkout"));
  EXPECT_EQ(find("arm", folder_.path("mine/checkout/urdf")), folder_.path("mine/checkout"));
  EXPECT_EQ(find("arm", folder_.path("mine")), folder_.path("src/arm"));
}

TEST_F(Packages, APathThatIsTooLongIsRefused) {
  const auto expectRefused = [](const std::function<void()>& action) {
    expectError(ErrorCode::kBadOption, {"packages near '/a/a/a/", "4098 bytes", "4096 at most", "give a shorter one"}, action);
  };
  std::string near;
  while (near.size() <= 4096) near += "/a";
  expectRefused([&] { defaultPackageFinder(near); });
  expectRefused([&] { defaultPackageFinder().fileNearby("arm", "meshes/a.stl", near); });
}

TEST_F(Packages, OfADeepPathTheInnermostFoldersAreSearched) {
  std::string below = "mine";
  for (int i = 0; i < 99; ++i) below += "/a";
  folder_.write("mine/package.xml", manifest("arm"));
  EXPECT_EQ(find("arm", folder_.path(below + "/arm.urdf")), folder_.path("mine"));
  EXPECT_EQ(find("arm", folder_.path(below + "/a/arm.urdf")), std::nullopt);
}

TEST_F(Packages, AFinderReadsEachManifestOnce) {
  folder_.write("mine/package.xml", manifest("arm"));
  const ScopedVariable path("ROS_PACKAGE_PATH", ""), prefix("CMAKE_PREFIX_PATH", "");
  const PackageFinder finder = defaultPackageFinder(folder_.path("mine/arm.urdf"));
  EXPECT_EQ(finder("hand"), std::nullopt);
  folder_.write("mine/package.xml", manifest("hand"));
  EXPECT_EQ(finder("hand"), std::nullopt);
  EXPECT_EQ(finder("arm"), folder_.path("mine"));
}

TEST_F(Packages, InstalledOnesComeAfterTheCrawl) {
  prefix_path_ = folder_.path("p") + ":" + folder_.path("q");
  folder_.write("q/share/arm/package.xml", manifest("arm"));
  EXPECT_EQ(find("arm"), folder_.path("q/share/arm"));
  folder_.write("src/arm/package.xml", manifest("arm"));
  EXPECT_EQ(find("arm"), folder_.path("src/arm"));
}

TEST_F(Packages, ABrokenManifestCostsANote) {
  folder_.write("src/empty/package.xml");
  folder_.write("src/z/package.xml", manifest("arm"));
  const ScopedVariable path("ROS_PACKAGE_PATH", ros_path_);
  const PackageFinder finder = defaultPackageFinder();
  EXPECT_EQ(finder("arm"), folder_.path("src/z"));
  ASSERT_EQ(finder.notes().size(), 1u);
  EXPECT_NE(finder.notes()[0].find("'" + folder_.path("src/empty/package.xml") + "' is empty or broken"), std::string::npos);
}

TEST_F(Packages, AFolderOfTheNameIsTheLastResort) {
  const std::string urdf = folder_.write("robots/arm_description/urdf/arm.urdf");
  folder_.write("robots/gripper_description/meshes/finger.stl");
  EXPECT_EQ(find("arm_description", urdf), folder_.path("robots/arm_description"));
  EXPECT_EQ(find("gripper_description", urdf), folder_.path("robots/gripper_description"));
  folder_.write("src/x/package.xml", manifest("arm_description"));
  EXPECT_EQ(find("arm_description", urdf), folder_.path("src/x"));
}

TEST_F(Packages, PackagePath) {
  folder_.write("src/arm/package.xml", manifest("arm"));
  folder_.write("more/deep/x/package.xml", manifest("hand"));
  folder_.write("more/tool/tool.stl");
  folder_.write("more/arm/package.xml", manifest("arm"));
  const ScopedVariable path("ROS_PACKAGE_PATH", ros_path_);
  const PackageFinder finder = defaultPackageFinder("", {folder_.path("more"), "leg=" + folder_.path("more/deep")});
  EXPECT_EQ(finder("hand"), folder_.path("more/deep/x")) << "by its manifest";
  EXPECT_EQ(finder("leg"), folder_.path("more/deep")) << "as named";
  EXPECT_EQ(finder("arm"), folder_.path("src/arm")) << "ROS comes first";
  EXPECT_TRUE(finder.notes().empty());
  EXPECT_EQ(finder("tool"), folder_.path("more/tool")) << "by the folder's name";
  EXPECT_EQ(finder.notes().size(), 1u);
  EXPECT_EQ(defaultPackageFinder("", {"arm=" + folder_.path("more")})("arm"), folder_.path("more")) << "a name wins over ROS";
  for (const char* bad : {"", "arm=", "nowhere", "arm=nowhere"})
    expectError(ErrorCode::kBadOption, {"'" + std::string(bad) + "'", "NAME=DIR"}, [&] { defaultPackageFinder("", {bad}); });
}

TEST_F(Packages, AnotherLookupComesFirst) {
  folder_.write("src/arm/package.xml", manifest("arm"));
  const ScopedVariable path("ROS_PACKAGE_PATH", ros_path_);
  const PackageFinder finder = defaultPackageFinder("", {"leg=" + folder_.path("src")}).askingFirst([](const std::string& package) {
    return package == "hand" ? std::nullopt : std::optional<std::string>("/ros/" + package);
  });
  EXPECT_EQ(finder("arm"), "/ros/arm");
  EXPECT_EQ(finder("hand"), std::nullopt);
  EXPECT_EQ(finder("leg"), folder_.path("src"));
}

TEST_F(Packages, ThePackageAroundTheDescriptionComesBeforeAnyOther) {
  folder_.write("src/arm/package.xml", manifest("arm"));
  folder_.write("other/arm/package.xml", manifest("arm"));
  const ScopedVariable path("ROS_PACKAGE_PATH", ros_path_);
  const PackageFinder finder = defaultPackageFinder(folder_.path("other/arm/urdf/arm.urdf"));
  const auto ros = [](const std::string& package) { return std::optional<std::string>("/ros/" + package); };
  for (const PackageFinder& each : {finder, finder.askingFirst(ros)}) EXPECT_EQ(each("arm"), folder_.path("other/arm"));
  EXPECT_EQ(defaultPackageFinder()("arm"), folder_.path("src/arm"));
}

TEST_F(Packages, CopiesShareOneCrawl) {
  folder_.write("src/arm/package.xml", manifest("arm"));
  const ScopedVariable path("ROS_PACKAGE_PATH", ros_path_);
  const PackageFinder finder = defaultPackageFinder();
  const PackageFinder copy = finder;
  std::thread other([&] { EXPECT_TRUE(copy("arm")); });
  EXPECT_TRUE(finder("arm"));
  other.join();
  folder_.write("src/late/package.xml", manifest("late"));
  EXPECT_EQ(copy("late"), std::nullopt);
  EXPECT_TRUE(defaultPackageFinder()("late"));
}

// The output of --for drake and --for tesseract is one robot.
TEST_F(Packages, ADescriptionForAConsumerIsNoOther) {
  const std::string robot = "<robot name='arm'><link name='a'/></robot>", arm = folder_.write("out/urdf/arm.urdf", robot);
  const std::string drake = folder_.write("out/urdf/arm_drake.urdf", robot),
                    tesseract = folder_.write("out/urdf/arm_tesseract.urdf", robot);
  const std::string alone = folder_.write("out/urdf/hand_drake.urdf", robot);
  EXPECT_EQ(robotDescriptionsIn(folder_.path("out")), (std::vector<std::string>{arm, drake, tesseract, alone})) << "no output of ours";
  folder_.write("out/report.json", "{}");
  EXPECT_EQ(robotDescriptionsIn(folder_.path("out")), (std::vector<std::string>{arm, alone}));
}

TEST_F(Packages, DescriptionsInAPackage) {
  for (const char* name : {"urdf/b.urdf", "urdf/a.urdf.xacro", "urdf/readme.txt", "robots/z.urdf", "robots/c.xacro", "meshes/no.urdf",
                           "urdf/a.srdf.xacro", "robots/world.SDF.xacro"}) {
    folder_.write(std::string("arm/") + name);
  }
  std::filesystem::create_directory(folder_.path("arm/urdf/folder.urdf"));
  const std::vector<std::string> expected{folder_.path("arm/robots/z.urdf"), folder_.path("arm/urdf/b.urdf"),
                                          folder_.path("arm/robots/c.xacro"), folder_.path("arm/urdf/a.urdf.xacro")};
  EXPECT_EQ(robotDescriptionsIn(folder_.path("arm")), expected);
  EXPECT_TRUE(robotDescriptionsIn(folder_.path("nowhere")).empty());
  folder_.write("loud/config/arm.srdf.xacro");
  const std::string loud = folder_.write("loud/urdf/arm.URDF", "<robot name='loud'><link name='a'/></robot>");
  EXPECT_EQ(robotDescriptionsIn(folder_.path("loud")), std::vector<std::string>{loud});
  EXPECT_EQ(robotDescriptionsBelow(folder_.path("loud")).files.size(), 1u);
}

TEST_F(Packages, MacrosAreNoDescriptionOfTheirOwn) {
  const auto xacro = [](const std::string& content) {
    return "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'>" + content + "</robot>";
  };
  const std::string macro = folder_.write(
      "hand/urdf/hand_macro.xacro", xacro("<xacro:property name='a' value='1'/><xacro:macro name='hand'><link name='l'/></xacro:macro>"));
  folder_.write("hand/urdf/materials.xacro", xacro("<material name='grey'/>"));
  EXPECT_EQ(robotDescriptionsIn(folder_.path("hand")), std::vector<std::string>{macro}) << "there is nothing else";
  const std::string left = folder_.write("hand/left/hand.urdf", "<robot name='left'><link name='l'/></robot>");
  EXPECT_EQ(robotDescriptionsIn(folder_.path("hand")), std::vector<std::string>{left}) << "elsewhere there is";
  const std::string hand = folder_.write("hand/urdf/hand.xacro", xacro("<xacro:include filename='hand_macro.xacro'/><xacro:hand/>"));
  const std::string plain = folder_.write("hand/urdf/plain.xacro", xacro("<xacro:if value='1'><link name='l'/></xacro:if>"));
  const std::string broken = folder_.write("hand/urdf/broken.xacro", "<robot");
  EXPECT_EQ(robotDescriptionsIn(folder_.path("hand")), (std::vector<std::string>{broken, hand, plain}));
}

TEST_F(Packages, ACallOfAMacroWithoutLinksMakesNoRobot) {
  const auto xacro = [](const std::string& content) {
    return "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'>" + content + "</robot>";
  };
  const std::string drive = "<xacro:macro name='drive'><transmission name='t'><linkage/></transmission></xacro:macro><xacro:drive/>";
  folder_.write("arm/urdf/drives.xacro", xacro(drive));
  folder_.write("arm/urdf/more_drives.xacro", xacro("<xacro:include filename='drives.xacro'/><xacro:drive/>"));
  folder_.write("arm/urdf/macro.xacro", xacro("<xacro:macro name='arm'><link name='a'/></xacro:macro>"));
  const std::string arm = folder_.write("arm/urdf/robot.xacro", xacro("<xacro:include filename='macro.xacro'/><xacro:arm/>"));
  EXPECT_EQ(robotDescriptionsIn(folder_.path("arm")), std::vector<std::string>{arm});
}

TEST_F(Packages, FilesNamedAsPartsAreNotProposed) {
  const std::string macro = "<robot xmlns:xacro='x'><xacro:macro name='m'><link name='a'/></xacro:macro></robot>";
  for (const char* const name : {"arm.gazebo.xacro", "arm.transmission.xacro", "common.xacro", "Materials.urdf.xacro", "const.xacro"})
    folder_.write(std::string("arm/urdf/") + name, macro);
  EXPECT_EQ(robotDescriptionsBelow(folder_.path("arm")).files.size(), 5u) << "there are no others";
  const std::string arm = folder_.write("arm/urdf/arm.urdf.xacro", macro);
  const FoundDescriptions found = robotDescriptionsBelow(folder_.path("arm"));
  EXPECT_EQ(found.files, std::vector<std::string>{arm});
  EXPECT_TRUE(found.are_parts);
}

TEST_F(Packages, WithoutLinksThereIsNoDescription) {
  folder_.write("arm/urdf/colours.urdf", "<robot name='properties'><material name='grey'/></robot>");
  folder_.write("arm/urdf/empty.urdf", "<robot/>");
  EXPECT_EQ(robotDescriptionsIn(folder_.path("arm")).size(), 2u) << "there is nothing else";
  const std::string arm = folder_.write("arm/urdf/arm.urdf", "<robot name='arm'><link name='base'/></robot>");
  EXPECT_EQ(robotDescriptionsIn(folder_.path("arm")), std::vector<std::string>{arm});
}

/// As sawyer_description has it: the robot is made of includes, and each of these adds links.
TEST_F(Packages, ARobotMayBeIncludesAlone) {
  const auto including = [](const std::string& attributes, const std::string& file, const std::string& more = "") {
    return "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'" + attributes + "><xacro:if value='1'><xacro:include filename='" + file +
           "'/></xacro:if>" + more + "</robot>";
  };
  folder_.write("saw/package.xml", manifest("saw_description"));
  const std::string base = folder_.write("saw/urdf/base.urdf.xacro", "<robot><link name='base'/></robot>");
  const std::string saw = folder_.write("saw/urdf/saw.urdf.xacro", including("", "$(find saw_description)/urdf/base.urdf.xacro"));
  const std::string twin = folder_.write("saw/urdf/twin.urdf.xacro", including("", "saw.urdf.xacro"));
  folder_.write("saw/urdf/colours.xacro", "<robot><material name='grey'/></robot>");
  folder_.write("saw/urdf/only_colours.xacro", including(" name='colours'", "colours.xacro"));
  folder_.write("saw/urdf/ring_1.xacro", including("", "ring_2.xacro"));
  folder_.write("saw/urdf/ring_2.xacro", including("", "ring_1.xacro"));
  const std::string other = folder_.write("saw/urdf/other.xacro", including(" name='other'", "$(find other)/urdf/base.urdf.xacro"));
  folder_.write("saw/urdf/nameless.xacro", including("", "$(find other)/urdf/base.urdf.xacro"));
  folder_.write("saw/urdf/macros.xacro",
                including(" name='macros'", "$(find other)/urdf/base.urdf.xacro", "<xacro:macro name='m'><link name='l'/></xacro:macro>"));
  EXPECT_EQ(robotDescriptionsIn(folder_.path("saw")), (std::vector<std::string>{other, twin, base, saw})) << "included ones come last";
}

TEST_F(Packages, IncludesAreNotFollowedForEver) {
  folder_.write("chain/package.xml", manifest("chain"));
  const std::string base = folder_.write("chain/robots/base.xacro", "<robot><link name='base'/></robot>");
  constexpr int kFiles = 60;
  const auto name = [](int i) { return std::to_string(100 + i) + ".xacro"; };
  for (int i = 0; i < kFiles; ++i)
    folder_.write("chain/urdf/" + name(i), "<robot><xacro:include xmlns:xacro='x' filename='" + name(i + 1) + "'/></robot>");
  folder_.write("chain/urdf/" + name(kFiles), "<robot/>");
  EXPECT_EQ(robotDescriptionsIn(folder_.path("chain")).size(), 52u) << "the base, 50 files that lead too far, and the one where they do";
}

TEST_F(Packages, DescriptionsInOtherFolders) {
  const std::string robot = "<robot name='r'><link name='l'/></robot>";
  const std::string top = folder_.write("hands/left.urdf", robot), deep = folder_.write("hands/robots/v2/model.urdf", robot),
                    xacro = folder_.write("hands/a.xacro", robot);
  folder_.write("hands/.git/old.urdf", robot);
  folder_.write("hands/world.sdf", robot);
  folder_.write("hands/1/2/3/4/5/6/7/far.urdf", robot);
  EXPECT_TRUE(robotDescriptionsIn(folder_.path("hands")).empty());
  EXPECT_EQ(robotDescriptionsBelow(folder_.path("hands")).files, (std::vector<std::string>{top, deep, xacro}));
  EXPECT_TRUE(robotDescriptionsBelow(folder_.path("nowhere")).files.empty());
}

TEST_F(Packages, ASearchThatIsCutShortSaysSo) {
  constexpr int kMost = 20'000;
  folder_.write("full/meshes/0");
  for (int i = 2; i < kMost; ++i) std::ofstream(folder_.path("full/meshes/" + std::to_string(i)));
  EXPECT_EQ(robotDescriptionsBelow(folder_.path("full")).cut_after, 0u) << "the folder meshes, and one entry less than the most in it";
  folder_.write("full/meshes/1");
  EXPECT_EQ(robotDescriptionsBelow(folder_.path("full")).cut_after, static_cast<std::size_t>(kMost));
}

}  // namespace
}  // namespace collision_hulls
