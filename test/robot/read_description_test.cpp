#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/run_program.h"
#include "collision_hulls/robot/robot_description.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

const char kUrdf[] = "<robot name=\"r\">\r\n<link name=\"a\"/></robot>";

void writeProgram(const TemporaryFolder& folder, const std::string& name, const std::string& script) {
  chmod(folder.write(name, "#!/bin/sh\n" + script).c_str(), 0755);
}

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

TEST(ReadDescription, XacroIsMissing) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.urdf.xacro", kUrdf);
  const ScopedVariable path("PATH", folder.path());
  expectError(ErrorCode::kXacroMissing, {file, "install", "xacro FILE.xacro > FILE.urdf"}, [&] { readRobotDescription(file); });
}

TEST(ReadDescription, XacroExpands) {
  const TemporaryFolder folder;
  writeProgram(folder, "xacro", "echo warning >&2; exec cat \"$1\"");
  const std::string file = folder.write("a '; exit 3; $(b).XACRO", kUrdf);
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  const RobotDescription robot = readRobotDescription(file);
  EXPECT_EQ(robot.text, kUrdf);
  EXPECT_EQ(robot.path, file);
}

TEST(ReadDescription, XacroFails) {
  const TemporaryFolder folder;
  writeProgram(folder, "xacro", "echo '<robot'; echo 'undefined macro: wheel' >&2; exit 2");
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  expectError(ErrorCode::kNotARobot, {"status 2", "undefined macro: wheel"}, [&] { readRobotDescription(folder.write("a.xacro", kUrdf)); });
}

TEST(ReadDescription, XacroLacksAPackage) {
  const TemporaryFolder folder;
  writeProgram(folder, "xacro",
               "printf 'error: resource not found: sick\\nROS path [0]=/opt\\nwhen processing file: /ws/laser.xacro\\nincluded from: "
               "/ws/a' >&2; exit 2");
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  const std::string file = folder.write("a.xacro", kUrdf);
  try {
    readRobotDescription(file);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kPackageNotFound);
    EXPECT_STREQ(
        error.what(),
        "package 'sick', which '/ws/laser.xacro' includes, was not found: install it and source its workspace, or give its folder, "
        "or the one above, with --package-path DIR");
  }
  writeProgram(folder, "xacro", "echo 'resource not found: sick' >&2; exit 2");
  expectError(ErrorCode::kPackageNotFound, {"package 'sick', which '" + file + "' includes"}, [&] { readRobotDescription(file); });
}

TEST(ReadDescription, XacroLacksAnArgument) {
  const TemporaryFolder folder;
  writeProgram(
      folder, "xacro",
      "printf 'error: Undefined substitution argument prefix\\nwhen processing file: /ws/hand.xacro\\nincluded from: a' >&2; exit 2");
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  const std::string file = folder.write("my arm.urdf.xacro", kUrdf), short_name = folder.write("arm.xacro", kUrdf);
  expectError(ErrorCode::kNotARobot,
              {"'" + file + "' needs a value for the argument 'prefix', which '/ws/hand.xacro' uses", "has no default",
               "\n  xacro '" + file + "' prefix:=VALUE > '" + folder.path("my arm.urdf") + "'\nand give the .urdf"},
              [&] { readRobotDescription(file); });
  expectError(ErrorCode::kNotARobot, {"prefix:=VALUE > " + folder.path("arm.urdf") + "\n"}, [&] { readRobotDescription(short_name); });
  folder.write("arm.urdf", kUrdf);
  expectError(ErrorCode::kNotARobot, {"prefix:=VALUE > " + folder.path("arm_2.urdf") + "\n"}, [&] { readRobotDescription(short_name); });
}

// xacro names one argument at a time.
TEST(ReadDescription, XacroLacksSeveralArguments) {
  const TemporaryFolder folder;
  writeProgram(
      folder, "xacro",
      "for name in side prefix; do case \"$*\" in *\" $name:=0\"*) ;; *) echo \"Undefined substitution argument $name\" >&2; exit 2 ;; "
      "esac; done; echo 'side is not a number' >&2; exit 2");
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  folder.write("urdf/here", "");
  const std::string file = folder.write("arm.xacro", kUrdf);
  expectError(
      ErrorCode::kNotARobot,
      {"needs values for the arguments 'side', 'prefix', which have no defaults (xacro may ask for more once it has values for these)",
       "\n  xacro " + file + " side:=VALUE prefix:=VALUE > " + folder.path("arm.urdf") + "\n"},
      [&] { readRobotDescription(folder.path("urdf") + "/../arm.xacro"); });
}

// xacro appends a blank where the argument stands in a property.
TEST(ReadDescription, XacroLacksAnArgumentOfAnExpression) {
  const TemporaryFolder folder;
  writeProgram(folder, "xacro", "printf \"error: Undefined substitution argument prefix \\nwhen evaluating expression 'p'\" >&2; exit 2");
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  expectError(ErrorCode::kNotARobot, {"the argument 'prefix',", " prefix:=VALUE > "},
              [&] { readRobotDescription(folder.write("arm.xacro", kUrdf)); });
}

// xacro takes no argument without one, even if it gets a value, and does not say which argument it is.
TEST(ReadDescription, XacroLacksADefault) {
  const TemporaryFolder folder;
  const std::string hand = folder.write("hand.xacro",
                                        "<robot xmlns:xacro='x'><xacro:arg name='a' default=''/><xacro:if value='true'>"
                                        "<xacro:arg name='side'/></xacro:if></robot>");
  const auto fail = [&](const std::string& file) {
    writeProgram(folder, "xacro", "echo \"error: xacro:arg: missing attribute 'default'\nwhen processing file: " + file + "\" >&2; exit 2");
  };
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  const std::string file = folder.write("arm.xacro", kUrdf);
  fail(hand);
  expectError(ErrorCode::kNotARobot,
              {"'" + file + "' cannot be expanded: the argument 'side' in '" + hand + "' has no default", "Add default=\"\"",
               "run\n  xacro " + file + " side:=VALUE > " + folder.path("arm.urdf") + "\nand give the .urdf"},
              [&] { readRobotDescription(file); });
  fail(folder.path("gone.xacro"));
  expectError(ErrorCode::kNotARobot, {"the argument 'NAME' in '" + folder.path("gone.xacro"), " NAME:=VALUE > "},
              [&] { readRobotDescription(file); });
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

TEST(ReadDescription, XacroFindsPackagesAroundAndGiven) {
  const TemporaryFolder folder;
  writeProgram(folder, "xacro", "echo \"path=$ROS_PACKAGE_PATH:\" >&2; exit 2");
  for (const char* package : {"ws/arm", "ws/hand", "elsewhere/base"}) folder.write(std::string(package) + "/package.xml", "<package/>");
  folder.write("ws/notes/readme", "");
  const std::string file = folder.write("ws/arm/urdf/a.xacro", kUrdf);
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin"), ros("ROS_PACKAGE_PATH", "/ours");
  expectError(ErrorCode::kNotARobot,
              {"path=" + folder.path("elsewhere/base") + ":" + folder.path("ws/arm") + ":/ours:" + folder.path("elsewhere") + ":",
               "/ws/hand:", "--package-path"},
              [&] {
                readRobotDescription(file, {}, {"base=" + folder.path("elsewhere/base"), folder.path("elsewhere")});
              });
}

TEST(ReadDescription, XacroCannotBeRun) {
  const TemporaryFolder folder;
  folder.write("xacro", "not executable");
  const ScopedVariable path("PATH", folder.path());
  expectError(ErrorCode::kXacroMissing, {"cannot be run"}, [&] { readRobotDescription(folder.write("a.xacro", kUrdf)); });
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
