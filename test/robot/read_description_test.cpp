#include <gtest/gtest.h>

#include "base/run_program.h"
#include "collision_hulls/robot/robot_description.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

TEST(ReadDescription, MissingFileAndFolder) {
  const TemporaryFolder folder;
  expectError(ErrorCode::kFileNotFound, {folder.path("no.urdf"), "does not exist"}, [&] { readRobotDescription(folder.path("no.urdf")); });
  expectError(ErrorCode::kFileNotFound, {"is a folder"}, [&] { readRobotDescription(folder.path()); });
}

TEST(ReadDescription, EndlessFile) {
  expectError(ErrorCode::kFileNotFound, {"/dev/zero", "not a regular file"}, [] { readRobotDescription("/dev/zero"); });
}

TEST(ReadDescription, KeepsEveryByte) {
  const TemporaryFolder folder;
  const RobotDescription robot = readRobotDescription(folder.write("a.urdf", kUrdf));
  EXPECT_EQ(robot.text, kUrdf);
  EXPECT_EQ(robot.path, folder.path("a.urdf"));
}

TEST(ReadDescription, NamesTheFileThatIsNotXml) {
  const TemporaryFolder folder;
  expectError(ErrorCode::kNotXml, {folder.path("a.urdf"), "line 2"},
              [&] { readRobotDescription(folder.write("a.urdf", "<robot>\n<a</robot>")); });
}

TEST(ReadDescription, XacroOfMacrosAloneNamesTheFilesThatCallThem) {
  const TemporaryFolder folder;
  writeProgram(folder, "xacro", "echo '<robot/>'");
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  const std::string macros = "<robot xmlns:xacro='x'><xacro:macro name='m'><link name='l'/></xacro:macro></robot>";
  const std::string outside = folder.write("arm_macro.xacro", macros);
  expectError(ErrorCode::kNoLinks,
              {"'" + outside +
               "' expands to a <robot> without a <link>: it defines macros for other files; give one that calls them, often "
               "urdf/ROBOT.urdf.xacro"},
              [&] { readRobotDescription(outside); });
  folder.write("arm/package.xml", "<package><name>arm</name></package>");
  const std::string file = folder.write("arm/urdf/arm_macro.xacro", macros);
  expectError(ErrorCode::kNoLinks, {"often urdf/ROBOT.urdf.xacro"}, [&] { readRobotDescription(file); });
  const auto robot = [&](const std::string& name, const std::string& content) {
    return folder.write("arm/urdf/" + name, "<robot name='r' xmlns:xacro='x'>" + content + "</robot>");
  };
  const std::string a = robot("a.xacro", "<link name='l'/>"), b = robot("b.xacro", "<link name='l'/>");
  const std::string user = robot("user.xacro", "<xacro:include filename='arm_macro.xacro'/><xacro:m/>");
  robot("z.xacro", "<link name='l'/>");
  expectError(ErrorCode::kNoLinks, {"calls them, such as '" + user + "', '" + a + "', '" + b + "' or one of 1 more"},
              [&] { readRobotDescription(file); });
  expectError(ErrorCode::kNoLinks,
              {"colours.xacro' expands to a <robot> without a <link>; give a file that describes a robot, such as '" + a},
              [&] { readRobotDescription(robot("colours.xacro", "<material name='grey'/>")); });
}

TEST(ReadDescription, LinesOfAnExpansionAreNamedAsSuch) {
  const TemporaryFolder folder;
  writeProgram(folder, "xacro", "printf '<robot name=\"r\">\\n<link/></robot>'");
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  const std::string file = folder.write("a.xacro", kUrdf);
  expectError(ErrorCode::kNotARobot, {"'" + file + "' as xacro expands it, line 2: a <link> has no name"},
              [&] { readRobotDescription(file); });
}

TEST(RunProgram, TakesAnyAmountOfOutput) {
  const auto result = runProgram({"sh", "-c", "head -c 3000000 /dev/zero; head -c 2000000 /dev/zero >&2; cat; kill -9 $$"});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->out.size(), 3000000u);
  EXPECT_EQ(result->errors.size(), 2000000u);
  EXPECT_EQ(result->status, 128 + 9);
}

}  // namespace
}  // namespace collision_hulls
