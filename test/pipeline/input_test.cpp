#include "collision_hulls/pipeline/input.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "collision_hulls/error.h"
#include "counted_looks.h"
#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace {

using fixtures::TempFolder;

class OpenInput : public ::testing::Test {
 protected:
  OpenInput() {
    if (const char* old = getenv("ROS_PACKAGE_PATH")) old_path_ = old;
    setenv("ROS_PACKAGE_PATH", folder_.path().c_str(), 1);
  }
  ~OpenInput() override { setenv("ROS_PACKAGE_PATH", old_path_.c_str(), 1); }

  void addPackage(const std::string& name) {
    fixtures::write(folder_ / (name + "/package.xml"), "<package format=\"2\"><name>" + name + "</name></package>");
  }
  void addRobot(const std::string& file) { fixtures::write(folder_ / file, fixtures::robot("arm", fixtures::link("base", ""))); }

  void expectError(const std::string& input, ErrorCode code, const std::vector<std::string>& parts) {
    try {
      openInput(input);
      ADD_FAILURE() << input;
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), code) << e.what();
      for (const std::string& part : parts) EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
    }
  }

  TempFolder folder_;
  std::string old_path_;
};

TEST_F(OpenInput, NothingThere) {
  expectError("", ErrorCode::kFileNotFound, {"'' is neither a file"});
  expectError("no/such.stl", ErrorCode::kFileNotFound, {"'no/such.stl' does not exist (looked for '/", "/no/such.stl')"});
  expectError("missing.urdf", ErrorCode::kFileNotFound, {"'missing.urdf' does not exist (looked for '/", "/missing.urdf')"});
  expectError("no/such", ErrorCode::kFileNotFound, {"neither a file nor the folder of a package ('/"});
  expectError("/no/such", ErrorCode::kFileNotFound, {"'/no/such' is neither a file nor the folder of a package; check the path"});
  expectError("no_such_package", ErrorCode::kPackageNotFound, {"no_such_package", "ROS_PACKAGE_PATH", folder_.path().string()});
  expectError(folder_.path().string(), ErrorCode::kFileNotFound, {"folder '" + folder_.path().string() + "'", "no package.xml"});
  expectError(folder_.path().string(), ErrorCode::kFileNotFound, {"'batch' takes folders of meshes"});
  fixtures::write(folder_ / "link_1.stl", "");
  expectError(folder_ / "linl_1.stl", ErrorCode::kFileNotFound, {"linl_1.stl' does not exist; did you mean 'link_1.stl'?"});
  expectError(folder_ / "wheel.stl", ErrorCode::kFileNotFound, {"wheel.stl' does not exist; check the path"});
  fixtures::write(folder_ / "part/hull_0.stl", "");
  const std::string hulls = fixtures::write(folder_ / "part/part_hulls.obj", "");
  expectError(folder_ / "part", ErrorCode::kFileNotFound, {"no package.xml"});
  fixtures::write(folder_ / "part/report.json", "{}");
  expectError(folder_ / "part", ErrorCode::kFileNotFound, {"is the output for a single mesh; give '" + hulls + "'"});
}

TEST_F(OpenInput, AFileOfAPackageByItsUri) {
  addPackage("arm");
  addRobot("arm/urdf/arm.urdf");
  EXPECT_EQ(openInput("package://arm/urdf/arm.urdf").robot.path, folder_ / "arm/urdf/arm.urdf");
  expectError("package://leg/urdf/leg.urdf", ErrorCode::kPackageNotFound, {"package 'leg'"});
}

TEST_F(OpenInput, NothingThereAndNoWorkingFolderEither) {
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::create_directory(folder_ / "gone");
  std::filesystem::current_path(folder_ / "gone");
  std::filesystem::remove(folder_ / "gone");
  expectError("/no/such.stl", ErrorCode::kFileNotFound, {"'/no/such.stl' does not exist; check the path"});
  expectError("such.stl", ErrorCode::kFileNotFound, {"'such.stl' does not exist; check the path"});
  std::filesystem::current_path(here);
}

TEST_F(OpenInput, RejectsUnknownAndInvalidInputs) {
  expectError(fixtures::write(folder_ / "arm.srdf", "<robot/>"), ErrorCode::kUnsupportedFormat, {"'.srdf'", "as --srdf"});
  expectError(fixtures::write(folder_ / "arm.srdf.xacro", "<robot/>"), ErrorCode::kUnsupportedFormat,
              {"'.srdf.xacro'", "once xacro has expanded them, as --srdf"});
  expectError(fixtures::write(folder_ / "cell.world", "<sdf/>"), ErrorCode::kUnsupportedFormat, {"'.world'", "as --scene"});
  expectError(fixtures::write(folder_ / "part.step", "ISO-10303-21;"), ErrorCode::kUnsupportedFormat, {"'.step'", ".urdf", ".stl"});
  expectError(fixtures::write(folder_ / "broken.urdf", "no xml"), ErrorCode::kNotXml, {"broken.urdf"});
  expectError(fixtures::write(folder_ / "empty.urdf", fixtures::robot("empty", "")), ErrorCode::kNoLinks, {"empty"});
}

TEST_F(OpenInput, DoesNotReadTheMeshYet) {
  const Input input = openInput(fixtures::write(folder_ / "Part.STL", "anything"));
  EXPECT_EQ(input.kind, Input::Kind::kMesh);
  EXPECT_EQ(input.path, folder_ / "Part.STL");
  EXPECT_EQ(defaultOutput(input), "./Part_collision");
}

TEST_F(OpenInput, ARobotByFilePackageOrFolder) {
  addPackage("arm_description");
  addRobot("arm_description/urdf/arm.urdf");
  for (const std::string& text : {folder_ / "arm_description/urdf/arm.urdf", std::string("arm_description"), folder_ / "arm_description"}) {
    const Input input = openInput(text);
    EXPECT_EQ(input.kind, Input::Kind::kRobot);
    EXPECT_EQ(input.robot.name, "arm");
    EXPECT_EQ(input.find_package("arm_description"), folder_ / "arm_description");
    EXPECT_EQ(defaultOutput(input), "./arm_collision");
  }
}

TEST_F(OpenInput, APackageOfThePackagePath) {
  addRobot("elsewhere/deep/urdf/arm.urdf");
  fixtures::write(folder_ / "elsewhere/CATKIN_IGNORE", "");
  const Input input = openInput("lost_description", {{"lost_description=" + (folder_ / "elsewhere/deep")}});
  EXPECT_EQ(input.robot.name, "arm");
  EXPECT_EQ(input.find_package("lost_description"), folder_ / "elsewhere/deep");
}

TEST_F(OpenInput, SaysWhatWorkThereIs) {
  const std::string mesh = "<visual>" + fixtures::meshTag("a.stl") + "</visual>";
  fixtures::write(folder_ / "arm.urdf", fixtures::robot("arm", fixtures::link("base", mesh + mesh) + fixtures::link("tip", mesh, "base")));
  const Input robot = openInput(folder_ / "arm.urdf");
  Options options;
  EXPECT_EQ(workOn(robot, options), "3 meshes of 2 links");
  options.links = "tip";
  EXPECT_EQ(workOn(robot, options), "1 mesh of 1 link");
  options.source = Source::kCollision;
  EXPECT_EQ(workOn(robot, options), "");
  EXPECT_EQ(workOn(openInput(fixtures::write(folder_ / "a.stl", "")), options), "'" + (folder_ / "a.stl") + "'");
}

TEST_F(OpenInput, WhatWorkThereIsCanBeCancelled) {
  addRobot("arm.urdf");
  const Input robot = openInput(folder_ / "arm.urdf");
  EXPECT_EQ(looksAfterCancel(1, [&](const RunControl& control) { workOn(robot, Options(), control); }), 1u);
}

TEST_F(OpenInput, APackageWithNoneOrSeveralRobots) {
  addPackage("two_description");
  expectError("two_description", ErrorCode::kFileNotFound, {"two_description", ".urdf", "or the file"});
  addRobot("two_description/urdf/left.urdf");
  addRobot("two_description/urdf/right.urdf");
  expectError("two_description", ErrorCode::kNotARobot,
              {"2 robot descriptions; run one of", "\n  decompose ", "urdf/left.urdf", "urdf/right.urdf"});
}

TEST_F(OpenInput, RobotsInOtherFolders) {
  addPackage("hands_description");
  addRobot("hands_description/arm.urdf");
  EXPECT_EQ(openInput("hands_description").robot.path, folder_ / "hands_description/arm.urdf");
  addRobot("hands_description/v2/model.urdf");
  expectError("hands_description", ErrorCode::kNotARobot, {"2 robot descriptions", "hands_description/v2/model.urdf"});
  addRobot("loose/model 1.urdf");
  expectError(folder_ / "loose", ErrorCode::kFileNotFound,
              {"no package.xml; it has 1 robot description; run\n  decompose '" + (folder_ / "loose/model 1.urdf") + "'"});
}

TEST_F(OpenInput, SaysThatFilesOnlyDefineMacros) {
  addPackage("parts_description");
  for (const char* const name : {"arm.urdf.xacro", "hand.urdf.xacro"})
    fixtures::write(folder_ / ("parts_description/urdf/" + std::string(name)),
                    "<robot xmlns:xacro='x'><xacro:macro name='m'><link name='a'/></xacro:macro></robot>");
  expectError("parts_description", ErrorCode::kNotARobot,
              {"2 files, none of which seems to make a robot", "define macros for other files", "or try one of\n  decompose "});
}

TEST_F(OpenInput, SaysThatTheSearchWasCutShort) {
  addPackage("full_description");
  std::filesystem::create_directory(folder_ / "full_description/data");
  for (int i = 0; i < 20'000; ++i) std::ofstream(folder_ / ("full_description/data/" + std::to_string(i)));
  const std::string where = " among the first 20000 files and folders, where the search ended; ";
  expectError("full_description", ErrorCode::kFileNotFound, {"has no .urdf or .xacro file" + where + "give"});
  std::filesystem::rename(folder_ / "full_description", folder_ / "full");
  std::filesystem::remove(folder_ / "full/package.xml");
  fixtures::write(folder_ / "full/data/20000", "");
  expectError(folder_ / "full", ErrorCode::kFileNotFound, {"no package.xml; it has no description" + where + "give"});
}

TEST_F(OpenInput, AFolderOfPackages) {
  for (const std::string name : {"arm", "hand"}) {
    const std::string package = "robots/" + name + "_description";
    addPackage(package);
    addRobot(package + "/urdf/base.xacro");
    fixtures::write(folder_ / (package + "/urdf/robot.xacro"),
                    "<robot name='r' xmlns:xacro='x'><xacro:include filename='$(find " + package + ")/urdf/base.xacro'/></robot>");
  }
  const std::string arm = "\n  decompose " + (folder_ / "robots/arm_description/urdf/"),
                    hand = "\n  decompose " + (folder_ / "robots/hand_description/urdf/");
  expectError(folder_ / "robots", ErrorCode::kFileNotFound,
              {"4 robot descriptions; run one of" + arm + "robot.xacro" + arm + "base.xacro" + hand + "robot.xacro" + hand + "base.xacro"});
}

TEST_F(OpenInput, CommandsKeepTheUsersOptionsAndAreADozen) {
  addPackage("many_description");
  for (int i = 10; i < 25; ++i) addRobot("many_description/urdf/r" + std::to_string(i) + ".urdf");
  try {
    openInput("many_description", {{}, {}, false, "verify a.urdf", "--quiet --json -"});
    ADD_FAILURE();
  } catch (const Error& e) {
    const std::string text = e.what(), folder = folder_ / "many_description/urdf/";
    EXPECT_NE(text.find("\n  verify a.urdf " + folder + "r10.urdf --quiet --json -\n"), std::string::npos) << text;
    EXPECT_NE(text.find("r21.urdf"), std::string::npos) << text;
    EXPECT_EQ(text.find("r22.urdf"), std::string::npos) << text;
    EXPECT_NE(text.find("\n  or with one of 3 more"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace collision_hulls
