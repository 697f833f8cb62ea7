// The program fit_scene: exit status, streams, files.
// Also tests src/tools/fit_scene.cpp.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "shapes.h"
#include "tools/program_test.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class FitSceneProgram : public ProgramTest {
 protected:
  FitSceneProgram() : ProgramTest("fit_scene") {
    fixtures::write(folder_ / "bracket.obj", fixtures::obj(test_shapes::lBracket(0.2, 0.03, 0.1)));
    fixtures::write(folder_ / "arm.urdf",
                    fixtures::robot("arm", fixtures::link("base", "    <visual>" + fixtures::meshTag("bracket.obj") + "</visual>\n")));
    fixtures::write(folder_ / "notch.yaml",
                    "name: notch\nbodies:\n- {name: block, box: [0.03, 0.03, 0.03], pose: {xyz: [0.075, 0.075, 0.05]}}\n");
  }
};

TEST_F(FitSceneProgram, Help) {
  const Finished result = run("--help");
  EXPECT_EQ(result.status, 0);
  for (const char* part :
       {"--scene", "--clearance", "--samples", "[10000]", "--configurations", "--srdf", "--compare", "--hulls-only", "--tolerance"})
    EXPECT_NE(result.out.find(part), std::string::npos) << part;
}

TEST_F(FitSceneProgram, HelpListsNoOptionThatIsRefused) {
  const std::string help = run("--help").out;
  for (const std::string option :
       {"--method hacd", "--padding 1cm", "--scale 0.1", "--segments", "--shapes spheres", "--spheres", "--time-limit 1s", "--tree 1mm"}) {
    const std::string name = option.substr(2, option.find(' ') - 2);
    expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm " + option, {name == "spheres" ? "shapes" : name});
    for (const char* start : {"\n  --", ",--"})
      EXPECT_EQ(help.find(start + name + " "), std::string::npos) << option << " is listed\n" << help;
  }
}

TEST_F(FitSceneProgram, NamesTheProgramForWhatNoFitHas) {
  for (const std::string option : {"--segments", "--segments --method hacd", "--for curobo", "--for curobo --shapes spheres"})
    expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm " + option, {option.substr(0, option.find(' ', 6)), "use decompose"});
}

TEST_F(FitSceneProgram, WrongUse) {
  expectWrongUse("arm.urdf", {"--scene"});
  expectWrongUse("arm.urdf --scene notch.yaml", {"--clearance"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 0", {"--clearance '0'", "2cm"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 2%", {"--clearance '2%'"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --samples 0", {"--samples '0'"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --samples 10000001", {"samples is 10000001", "10000000"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm,5%", {"--clearance '1cm,5%'"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 20", {"clearance '20m'", "2cm"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm -t 5", {"--tolerance '5' is", "5mm"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --scale 0.1", {"scale '0.1'"});
  expectWrongUse("arm.urdf --scene nowhere.yaml --clearance 1cm", {"nowhere.yaml"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --srdf none.srdf", {"none.srdf"});
  fixtures::write(folder_ / "rubbish.srdf", "disabled: none");
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --srdf rubbish.srdf", {"'rubbish.srdf', line 1"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --compare .", {"--compare", "folder"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm -o new --compare new/c.csv", {"--compare", "output folder"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm -o new --json " + (folder_ / "new/r.json"), {"--json", "output folder"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --compare -", {"--compare '-'", "give a file"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --compare c --json " + (folder_ / "c"), {"--compare: 'c'", "--json"});
  expectWrongUse("arm.urdf --scene \"\" --clearance 1cm", {"--scene", "takes a file"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --max-step 0.1", {"max-step", "given configurations"});
  fixtures::write(folder_ / "empty.srdf", "");
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --srdf empty.srdf", {"empty.srdf"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --configurations none.csv", {"none.csv"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm -m hacd", {"hacd", "certified"});
  expectWrongUse("bracket.obj --scene notch.yaml --clearance 1cm", {"bracket.obj", "mesh"});
}

TEST_F(FitSceneProgram, WrongValuesAreToldBeforeAnythingIsRead) {
  for (const char* option :
       {"--clearance 2%", "--clearance 1cm --samples 0", "--clearance 1cm --compare -", "--clearance 1cm --compare nowhere/c.csv",
        "--clearance 1cm --compare arm.urdf", "--clearance 1cm --srdf none.srdf", "--clearance 1cm --at elbow=1",
        "--clearance 1cm --joints '['", "--clearance 1cm --scale 0.1", "--clearance 1cm --padding 1cm", "--clearance 20"}) {
    const Finished result = run(std::string("arm.urdf --scene notch.yaml ") + option);
    EXPECT_EQ(result.status, 2) << option;
    EXPECT_EQ(result.err.find("reading"), std::string::npos) << result.err;
  }
}

TEST_F(FitSceneProgram, AComparisonMakesNoFolder) {
  for (const char* file : {"nowhere/c.csv", "c.csv/"})
    expectWrongUse(std::string("arm.urdf --scene notch.yaml --clearance 1cm --compare ") + file,
                   {"--compare: cannot write '" + std::string(file) + "': there is no folder '", "create it, or give another file"});
}

TEST_F(FitSceneProgram, AComparisonReplacesNothingButAComparison) {
  for (const std::string file : {"arm.urdf", "bracket.obj", "notch.yaml"})
    expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --compare " + file, {"--compare: '" + file + "'", "is no comparison"});
}

// An earlier output may hold what a scene is read from.
TEST_F(FitSceneProgram, AnInputIsNotReplacedByItsResult) {
  ASSERT_EQ(run("arm.urdf --scene notch.yaml --clearance 1cm -o out --samples 10 --hulls-only").status, 0);
  const std::string mesh = "out/meshes/base/0_0.stl", srdf = "out/config/arm_disabled.srdf";
  for (const std::string& file : {mesh, srdf}) ASSERT_TRUE(fs::exists(folder_ / file));
  expectWrongUse("arm.urdf --scene " + mesh + " --clearance 1cm -o out", {mesh, "which is an input", "choose another output"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm -o out --srdf " + srdf, {srdf, "which is an input"});
  EXPECT_EQ(run("arm.urdf --scene notch.yaml --clearance 1cm -o other --samples 10 --srdf " + srdf).status, 0);
}

// A shell makes a pipe of <(xacro arm.srdf.xacro).
TEST_F(FitSceneProgram, AnSrdfFromAPipe) {
  fixtures::write(folder_ / "arm.srdf", "<robot name='arm'/>");
  const std::string pipe = "rm -f pipe; mkfifo pipe; (cat arm.srdf > pipe &) ; ";
  EXPECT_EQ(run("arm.urdf --scene notch.yaml --clearance 1cm --samples 10 --srdf pipe", pipe).status, 0);
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --srdf /dev/zero", {"/dev/zero", "not a regular file"});
}

TEST_F(FitSceneProgram, XacroOfTheSceneFindsThePackagesGiven) {
  const std::string cell =
      fixtures::robot("cell", fixtures::link("wall", "    <visual>" + fixtures::meshTag("bracket.obj") + "</visual>\n"));
  fixtures::write(folder_ / "cell.urdf.xacro", cell);
  fixtures::write(folder_ / "elsewhere/package.xml", "<package><name>elsewhere</name></package>");
  fixtures::write(folder_ / "bin/xacro", "#!/bin/sh\ncase \"$ROS_PACKAGE_PATH\" in *elsewhere*) exec cat \"$1\" ;; esac\nexit 2\n");
  const std::string before = "chmod +x bin/xacro; PATH=$PWD/bin:$PATH; ",
                    command = "arm.urdf --scene cell.urdf.xacro --clearance 1cm --samples 10 ";
  EXPECT_EQ(run(command, before).status, 2);
  EXPECT_EQ(run(command + "--package-path elsewhere", before).status, 0);
}

TEST_F(FitSceneProgram, ArgumentsOfTheRobot) {
  fs::copy_file(folder_ / "arm.urdf", folder_ / "arm.xacro");
  fixtures::write(folder_ / "bin/xacro", "#!/bin/sh\ncase $2 in side:=left) exec cat \"$1\" ;; --deps) exit 1 ;; esac\nexit 2\n");
  const std::string before = "chmod +x bin/xacro; PATH=$PWD/bin:$PATH; ",
                    command = "arm.xacro --scene notch.yaml --clearance 1cm --samples 10 ";
  EXPECT_EQ(run(command, before).status, 2);
  EXPECT_EQ(run(command + "side:=left", before).status, 0);
}

TEST_F(FitSceneProgram, WritesNoComparisonIfNothingCouldBeFitted) {
  fixtures::write(folder_ / "torn.urdf",
                  fixtures::robot("torn", fixtures::link("base", "    <visual>" + fixtures::meshTag("nowhere.obj") + "</visual>\n")));
  const Finished result = run("torn.urdf --scene notch.yaml --clearance 1cm --compare c.csv");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("nowhere.obj"), std::string::npos) << result.err;
  EXPECT_FALSE(fs::exists(folder_ / "c.csv"));
}

TEST_F(FitSceneProgram, FitsAndReports) {
  const Finished result = run("arm.urdf --scene notch.yaml --clearance 1cm --samples 50 --json r.json --compare c.csv --no-validate");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("base: 2 boxes: against block at 30 mm"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("scene 'notch': 2 primitives in place of 2 hulls for a clearance of 10.0 mm"), std::string::npos) << result.out;
  EXPECT_EQ(json::parse(fixtures::read(folder_ / "r.json"))["scene"]["missed"], 0);
  const std::string csv = fixtures::read(folder_ / "c.csv");
  EXPECT_EQ(csv.rfind("robot,scene,clearance,model,", 0), 0u);
  EXPECT_NE(csv.find("\narm,notch,0.01,fitted,"), std::string::npos) << csv;
  EXPECT_TRUE(fs::exists(folder_ / "arm_collision/config/arm_disabled.srdf"));
  EXPECT_EQ(run("arm.urdf --scene notch.yaml --clearance 1cm --samples 10 --json r.json --compare c.csv --no-validate").status, 0)
      << "both files may be written again";
}

}  // namespace
}  // namespace collision_hulls
