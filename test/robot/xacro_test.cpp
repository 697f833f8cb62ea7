// Against programs in xacro's place. Also tests src/robot/xacro.cpp.
#include "robot/xacro.h"

#include <gtest/gtest.h>

#include "collision_hulls/robot/robot_description.h"
#include "robot/robot_tests.h"

namespace collision_hulls {
namespace {

TEST(Xacro, IsMissing) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.urdf.xacro", kUrdf);
  const ScopedVariable path("PATH", folder.path());
  expectError(ErrorCode::kXacroMissing, {file, "install", "xacro FILE.xacro > FILE.urdf"}, [&] { readRobotDescription(file); });
}

TEST(Xacro, Expands) {
  const TemporaryFolder folder;
  writeProgram(folder, "xacro", "echo warning >&2; exec cat \"$1\"");
  const std::string file = folder.write("a '; exit 3; $(b).XACRO", kUrdf);
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  const RobotDescription robot = readRobotDescription(file);
  EXPECT_EQ(robot.text, kUrdf);
  EXPECT_EQ(robot.path, file);
}

TEST(Xacro, Fails) {
  const TemporaryFolder folder;
  writeProgram(folder, "xacro", "echo '<robot'; echo 'undefined macro: wheel' >&2; exit 2");
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  expectError(ErrorCode::kNotARobot, {"status 2", "undefined macro: wheel"}, [&] { readRobotDescription(folder.write("a.xacro", kUrdf)); });
}

TEST(Xacro, LacksAPackage) {
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

TEST(Xacro, LacksAnArgument) {
  const TemporaryFolder folder;
  writeProgram(
      folder, "xacro",
      "printf 'error: Undefined substitution argument prefix\\nwhen processing file: /ws/hand.xacro\\nincluded from: a' >&2; exit 2");
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  const std::string file = folder.write("my arm.urdf.xacro", kUrdf), short_name = folder.write("arm.xacro", kUrdf);
  expectError(ErrorCode::kNotARobot,
              {"'" + file + "' needs a value for the argument 'prefix', which '/ws/hand.xacro' uses", "has no default",
               ": where it is the robot of decompose, fit_scene or verify, add prefix:=VALUE to the command; else run\n",
               "\n  xacro '" + file + "' prefix:=VALUE > '" + folder.path("my arm.urdf") + "'\nand give the .urdf"},
              [&] { readRobotDescription(file); });
  expectError(ErrorCode::kNotARobot, {"prefix:=VALUE > " + folder.path("arm.urdf") + "\n"}, [&] { readRobotDescription(short_name); });
  folder.write("arm.urdf", kUrdf);
  expectError(ErrorCode::kNotARobot, {"prefix:=VALUE > " + folder.path("arm_2.urdf") + "\n"}, [&] { readRobotDescription(short_name); });
}

// xacro names one argument at a time.
TEST(Xacro, LacksSeveralArguments) {
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
TEST(Xacro, LacksAnArgumentOfAnExpression) {
  const TemporaryFolder folder;
  writeProgram(folder, "xacro", "printf \"error: Undefined substitution argument prefix \\nwhen evaluating expression 'p'\" >&2; exit 2");
  const ScopedVariable path("PATH", folder.path() + ":/usr/bin:/bin");
  expectError(ErrorCode::kNotARobot, {"the argument 'prefix',", " prefix:=VALUE > "},
              [&] { readRobotDescription(folder.write("arm.xacro", kUrdf)); });
}

// xacro takes no argument without one, even if it gets a value, and does not say which argument it is.
TEST(Xacro, LacksADefault) {
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
  expectError(
      ErrorCode::kNotARobot,
      {"'" + file + "' cannot be expanded: the argument 'side' in '" + hand + "' has no default", "Add default=\"\"",
       "add side:=VALUE to the command", "run\n  xacro " + file + " side:=VALUE > " + folder.path("arm.urdf") + "\nand give the .urdf"},
      [&] { readRobotDescription(file); });
  fail(folder.path("gone.xacro"));
  expectError(ErrorCode::kNotARobot, {"the argument 'NAME' in '" + folder.path("gone.xacro"), " NAME:=VALUE > "},
              [&] { readRobotDescription(file); });
}

TEST(Xacro, FindsPackagesAroundAndGiven) {
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

TEST(Xacro, CannotBeRun) {
  const TemporaryFolder folder;
  folder.write("xacro", "not executable");
  const ScopedVariable path("PATH", folder.path());
  expectError(ErrorCode::kXacroMissing, {"cannot be run"}, [&] { readRobotDescription(folder.write("a.xacro", kUrdf)); });
}

// The fake prints its arguments as the robot's name, and as files that it includes, what the variable FILES holds.
class XacroArguments : public ::testing::Test {
 protected:
  XacroArguments() {
    writeProgram(folder_, "xacro",
                 "case \"$*\" in *--deps*) echo $FILES; exit 0 ;; esac\nshift; echo \"<robot name='given $*'><link name='a'/></robot>\"");
    arm_ = folder_.write(
        "arm.xacro",
        "<robot xmlns:xacro='x'><xacro:if value='1'><xacro:arg name='prefix' default=''/></xacro:if><a b='$(arg  side )'/></robot>");
    hand_ = folder_.write("hand.xacro", "<robot xmlns:xacro='x'><xacro:arg default='' name='fingers'/></robot>");
  }

  std::string nameWith(const std::vector<std::string>& arguments) { return readRobotDescription(arm_, {}, {}, arguments).name; }

  void expectRefused(const std::vector<std::string>& arguments, const std::vector<std::string>& parts) {
    expectError(ErrorCode::kBadOption, parts, [&] { nameWith(arguments); });
  }

  const TemporaryFolder folder_;
  const ScopedVariable path_{"PATH", folder_.path() + ":/usr/bin:/bin"};
  std::string arm_, hand_;
};

TEST_F(XacroArguments, GoToXacroInTheirOrder) {
  EXPECT_EQ(nameWith({}), "given ");
  EXPECT_EQ(nameWith({"side:=a b", "prefix:=:"}), "given side:=a b prefix:=:");
}

TEST_F(XacroArguments, OfFilesThatAreIncluded) {
  const ScopedVariable files("FILES", hand_);
  EXPECT_EQ(nameWith({"fingers:=3"}), "given fingers:=3");
}

TEST_F(XacroArguments, ThatNoFileHasAreRefused) {
  const ScopedVariable files("FILES", hand_);
  expectRefused({"side:=a", "prefx:=b"}, {"neither '" + arm_ + "' nor a file that it includes has an argument 'prefx'",
                                          "did you mean 'prefix'? They have fingers, prefix, side"});
  expectRefused({"colour:=red"}, {"'colour'; they have fingers, prefix, side"});
}

TEST_F(XacroArguments, AreTakenWhereNotAllFilesCanBeRead) {
  const ScopedVariable files("FILES", hand_ + " " + folder_.path("gone.xacro"));
  EXPECT_EQ(nameWith({"colour:=red"}), "given colour:=red");
}

TEST_F(XacroArguments, AreTakenWhereNamesAreComputed) {
  for (const char* const name : {"$(arg ${side}_hand)", "${xacro.arg('left_hand')}", "$(eval arg('left_hand'))"}) {
    arm_ = folder_.write("computed.xacro", "<robot xmlns:xacro='x'><a b=\"" + std::string(name) + "\"/></robot>");
    EXPECT_EQ(nameWith({"left_hand:=1"}), "given left_hand:=1") << name;
  }
}

TEST_F(XacroArguments, AreLookedForBesideFilesThatAreNoXml) {
  const ScopedVariable files("FILES", hand_ + " " + folder_.write("limits.yaml", "a: 1"));
  expectRefused({"colour:=red"}, {"'colour'; they have fingers, prefix, side"});
}

TEST_F(XacroArguments, AFileOfManyThatDoNotEnd) {
  std::string uses;
  for (int i = 0; i < 50'000; ++i) uses += "$(arg a";
  arm_ = folder_.write("many.xacro", "<robot xmlns:xacro='x'><!-- " + uses + " -->\n</robot>");
  EXPECT_EQ(nameWith({"colour:=red"}), "given colour:=red");
}

TEST_F(XacroArguments, OfAFileThatHasNone) {
  arm_ = folder_.write("bare.xacro", kUrdf);
  expectRefused({"a:=b c"}, {"has an argument 'a'; leave out 'a:=b c'"});
}

TEST_F(XacroArguments, OfAnotherForm) {
  for (const char* const argument : {"prefix", "prefix=a", ":=a", "--inorder:=1", "_p:=1"})
    expectRefused({argument}, {"'" + std::string(argument) + "' is no argument for xacro: give NAME:=VALUE"});
  for (const char* const argument : {"prefix:=", "prefix:= ", "prefix:=a:=b"})
    expectRefused({argument},
                  {"'" + std::string(argument) + "' has a value that xacro does not take", "the default of 'prefix' would count"});
  expectRefused({"prefix:=a", "prefix:=b"}, {"'prefix'", "given twice"});
}

TEST_F(XacroArguments, OfAnotherFile) {
  arm_ = folder_.write("arm.urdf", kUrdf);
  expectRefused({"prefix:=a"}, {"'prefix:=a' is an argument for xacro, but '" + arm_ + "' is not a .xacro file; leave it out"});
}

TEST_F(XacroArguments, AreInTheCommandsThatMessagesPropose) {
  writeProgram(folder_, "xacro", "case \"$*\" in *side:=*) exit 1 ;; esac\necho 'Undefined substitution argument side' >&2; exit 2");
  expectError(ErrorCode::kNotARobot, {"add side:=VALUE to the command; else", "\n  xacro " + arm_ + " 'prefix:=a b' side:=VALUE > "},
              [&] { nameWith({"prefix:=a b"}); });
}

}  // namespace
}  // namespace collision_hulls
