// The program itself: exit status, what stands on which stream, what is on the disk.
// Also tests src/tools/decompose.cpp.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geometry/bytes.h"
#include "tools/decompose_program_test.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class DecomposeProgram : public DecomposeProgramTest {};

TEST_F(DecomposeProgram, HelpNamesUnitsAndDefaults) {
  const Finished result = run("--help");
  EXPECT_EQ(result.status, 0);
  for (const char* part : {"INPUT", "--tolerance", "5mm", "[1cm,5%]", "--max-vertices", "[64]", "Examples:", "Exit status:"})
    EXPECT_NE(result.out.find(part), std::string::npos) << part;
  EXPECT_EQ(result.err, "");
}

TEST_F(DecomposeProgram, Version) {
  const Finished result = run("--version");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out.rfind("decompose of collision_hulls ", 0), 0u) << result.out;
  EXPECT_NE(result.out.find("\nEach mesh is read in a process of its own, confined by resource limits"), std::string::npos) << result.out;
}

TEST_F(DecomposeProgram, WrongOptionsNameOptionValueAndWhatIsAllowed) {
  expectWrongUse("", {"INPUT", "--help"});
  expectWrongUse("arm/urdf/arm.urdf --fine", {"--fine"});
  expectWrongUse("arm/urdf/arm.urdf another", {"another"});
  for (const std::string name : {"hulls.obj", "new.urdf"})
    expectWrongUse("arm/urdf/arm.urdf -o made/" + name,
                   {"--output 'made/" + name + "'", "a folder", "such as 'made/" + name.substr(0, name.find('.'))});
  expectWrongUse("arm/urdf/arm.urdf -t 5furlongs", {"tolerance", "'5furlongs'", "5mm"});
  expectWrongUse("arm/urdf/arm.urdf -t 0", {"tolerance", "'0'"});
  expectWrongUse("arm/urdf/arm.urdf --close-openings 20", {"--close-openings '20' is", "did you mean 2cm?\n"});
  expectWrongUse("arm/urdf/arm.urdf --padding 2", {"--padding '2' is", "did you mean 2mm?\n"});
  expectWrongUse("arm/urdf/arm.urdf -t 101%", {"tolerance", "'101%'", "100%"});
  expectWrongUse("arm/urdf/arm.urdf -m vhacd", {"--method", "'vhacd'", "hacd", "bounding_box"});
  expectWrongUse("arm/urdf/arm.urdf -t 1% --tree 2%", {"tree", "'2%'", "1%"});
  expectWrongUse("arm/urdf/arm.urdf -t 1% --tree 10%", {"tree", "'10%'"});
  expectWrongUse("arm/urdf/arm.urdf --tree coarse", {"--tree", "'coarse'", "5mm"});
  expectWrongUse("arm/urdf/arm.urdf --tree 0.5% -m hacd", {"tree", "'hacd'", "certified"});
  expectWrongUse("arm/urdf/arm.urdf --effort best -m acd", {"effort", "'best'", "'acd'", "certified"});
  expectWrongUse("arm/urdf/arm.urdf -o ''", {"--output", "folder"});
  expectWrongUse("arm/meshes/bracket.obj --links base", {"links", "'base'", "mesh"});
  expectWrongUse("arm/urdf/arm.urdf --fill -m hacd", {"fill", "'hacd'", "certified"});
  expectWrongUse("arm/urdf/arm.urdf --segments", {"segments", "'hacd'", "'certified'", "--method hacd"});
  expectWrongUse("arm/urdf/arm.urdf --max-hulls few", {"--max-hulls", "'few'", "whole number"});
  expectWrongUse("arm/urdf/arm.urdf --max-vertices 7", {"max-vertices", "'7'", "from 8"});
  expectWrongUse("arm/urdf/arm.urdf --max-hulls=-1", {"--max-hulls", "'-1'"});
  expectWrongUse("arm/urdf/arm.urdf --jobs -1", {"--jobs '-1' is invalid: use a whole number, 0 or more"});
  expectWrongUse("arm/urdf/arm.urdf --jobs 99999", {"jobs", "'99999'", "1024"});
  expectWrongUse("arm/urdf/arm.urdf --seed 99999999999999999999", {"--seed", "18446744073709551615"});
  expectWrongUse("arm/urdf/arm.urdf --format dxf", {"--format", "'dxf'", "stl"});
  expectWrongUse("arm/urdf/arm.urdf --source both", {"--source", "'both'", "visual"});
  expectWrongUse("arm/urdf/arm.urdf --uri http", {"--uri", "'http'", "relative"});
  expectWrongUse("arm/urdf/arm.urdf --profile havok", {"profile", "'havok'", "physx"});
  expectWrongUse("arm/urdf/arm.urdf --links '('", {"links", "'('"});
  expectWrongUse("arm/urdf/arm.urdf -t 5", {"--tolerance '5' is", "5mm"});
  expectWrongUse("arm/urdf/arm.urdf -t 1cm,2cm", {"tolerance '1cm,2cm'", "1cm,5%"});
  for (const char* scale : {"0", "-1", "0.001mm", "1,1,1", "nan", "inf", "''"})
    expectWrongUse("arm/meshes/bracket.obj --scale " + std::string(scale), {"--scale", "0.001"});
  expectWrongUse("arm/urdf/arm.urdf --scale 0.001", {"scale '0.001'", "scale=\"0.001 0.001 0.001\""});
  expectWrongUse("arm/urdf/arm.urdf --links elbow", {"links", "'elbow'", "base"});
  expectWrongUse("arm/urdf/arm.urdf --links bass", {"did you mean 'base'?"});
  expectWrongUse("arm/urdf/arm.urdf --package-name 'My Arm'", {"package-name 'My Arm'", "such as 'my_arm'"});
  expectWrongUse("arm/meshes/bracket.obj --package-name arm", {"package-name 'arm'", "mesh"});
  for (const std::string option : {"--uri package", "--source visual", "--rebase"})
    expectWrongUse("arm/meshes/bracket.obj " + option, {option.substr(0, option.find(' ')), "'arm/meshes/bracket.obj' is a mesh"});
  expectWrongUse("arm/urdf/arm.urdf --package-path nowhere", {"package path 'nowhere'", "NAME=DIR"});
}

TEST_F(DecomposeProgram, ALengthAboveTheLargestIsShownAsItWasGiven) {
  const std::string without_unit =
                        "is more than 1 m, the largest that makes sense for a mesh: a number without a unit is in metres; did you",
                    with_unit = "is more than 1 m, the largest that makes sense for a mesh; did you mean 8mm?\n";
  for (const std::string input : {"arm/urdf/arm.urdf ", "arm/meshes/bracket.obj "}) {
    expectWrongUse(input + "-t 5,5%", {"tolerance '5,5%' is invalid"});
    expectWrongUse(input + "-t 5", {"--tolerance '5' " + without_unit, "For a larger machine give a percentage"});
    expectWrongUse(input + "-t 5000mm,5%", {"--tolerance '5000mm,5%' is more than 1 m", "give a smaller length"});
    expectWrongUse(input + "--tree 5.0", {"--tree '5.0' " + without_unit});
    expectWrongUse(input + "--close-openings 8", {"--close-openings '8' " + without_unit});
    expectWrongUse(input + "--close-openings 8m", {"--close-openings '8m' " + with_unit});
    expectWrongUse(input + "--padding 5000", {"--padding '5000' is more than 1 m", "give a smaller length, as in 5mm.\n"});
  }
  expectWrongUse("arm/urdf/arm.urdf --model fine=8m", {"--model fine '8m' is more than 1 m"});
}

TEST_F(DecomposeProgram, OptionsThatDoNotSuitTheInputAreToldBeforeItIsRead) {
  for (const std::string arguments : {"arm/urdf/arm.urdf --scale 0.1", "arm/meshes/bracket.obj --links base",
                                      "arm/meshes/bracket.obj --model a=1mm", "arm/meshes/bracket.obj --shapes box"}) {
    const Finished result = run(arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_EQ(result.err.find("reading"), std::string::npos) << arguments << "\n" << result.err;
  }
}

TEST_F(DecomposeProgram, ArgumentsForXacroFollowTheInput) {
  expectWrongUse("arm/urdf/arm.urdf side:=left", {"'side:=left'", "'arm/urdf/arm.urdf' is not a .xacro file"});
  expectWrongUse("arm/meshes/bracket.obj side:=left", {"'side:=left'", "'arm/meshes/bracket.obj' is not a .xacro file"});
  for (const char* const name : {"arm.xacro", "hand.xacro"})
    fixtures::write(folder_ / ("two/urdf/" + std::string(name)), "<robot name='a'><link name='b'/></robot>");
  fixtures::write(folder_ / "two/package.xml", "<package><name>two</name></package>");
  fixtures::write(folder_ / "one.xacro", fixtures::read(folder_ / "arm/urdf/arm.urdf") + "<!-- $(arg side) -->");
  fixtures::write(folder_ / "bin/xacro", "#!/bin/sh\nexec cat \"$1\"\n");
  const std::string run_xacro = "chmod +x bin/xacro; PATH=$PWD/bin:$PATH; ";
  run("one.xacro side:=left -o made --json r.json -m bounding_box --no-validate --quiet", run_xacro);
  EXPECT_EQ(json::parse(fixtures::read(folder_ / "r.json"))["input"]["xacro_arguments"], json({"side:=left"}));
  expectWrongUse("two 'side:=my left' --quiet", {"decompose two/urdf/hand.xacro 'side:=my left' --quiet\n"});
}

TEST_F(DecomposeProgram, UnreadableInput) {
  fixtures::write(folder_ / "no_xml.urdf", "robot: arm\n");
  fixtures::write(folder_ / "no_links.urdf", "<robot name=\"arm\"/>\n");
  fixtures::write(folder_ / "no_robot.urdf", "<html/>\n");
  fixtures::write(folder_ / "empty.stl", "");
  fixtures::write(folder_ / "no_triangle.obj", "v 0 0 0\n");
  expectWrongUse("missing.urdf", {"'missing.urdf'", folder_ / "missing.urdf"});
  expectWrongUse("missing_package", {"'missing_package'", "ROS_PACKAGE_PATH"});
  expectWrongUse("no_xml.urdf", {"no_xml.urdf"});
  expectWrongUse("no_links.urdf", {"no_links.urdf"});
  expectWrongUse("no_robot.urdf", {"no_robot.urdf"});
  expectWrongUse("arm/meshes/rubbish.stl --quiet", {"rubbish.stl"});
  expectWrongUse("empty.stl --quiet", {"empty.stl"});
  expectWrongUse("no_triangle.obj --quiet", {"no_triangle.obj"});
}

TEST_F(DecomposeProgram, OutputThatCannotBe) {
  fixtures::write(folder_ / "file", "");
  fixtures::write(folder_ / "mine/thesis.tex", "\\documentclass{book}");
  expectWrongUse("arm/urdf/arm.urdf -o file/out", {"file/out"});
  expectWrongUse("arm/urdf/arm.urdf -o file", {"file"});
  expectWrongUse("arm/urdf/arm.urdf -o mine", {"mine", "left alone"});
  fs::create_symlink("nowhere", folder_ / "dangling");
  expectWrongUse("arm/urdf/arm.urdf -o dangling", {"dangling", "link"});
  for (const char* option : {"-o dangling/out", "--json dangling/report.json"})
    expectWrongUse(std::string("arm/urdf/arm.urdf --quiet ") + option,
                   {"/dangling' is a symbolic link that leads nowhere; choose another"});
  expectWrongUse("arm/urdf/arm.urdf --json mine", {"--json", "'mine'", "folder"});
  // Nothing can be created there, not even by root; said before anything is read.
  expectWrongUse("arm/urdf/arm.urdf --quiet -o /proc/out", {"'/proc' is not writable; choose another output"});
  expectWrongUse("arm/urdf/arm.urdf --quiet --json /proc/report.json", {"--json", "/proc", "choose another output"});
}

TEST_F(DecomposeProgram, LinksThatLeadInACircle) {
  fs::create_symlink("b", folder_ / "a");
  fs::create_symlink("a", folder_ / "b");
  EXPECT_NE(run("arm/urdf/arm.urdf --quiet --json a").err.find("--json: cannot write 'a': its symbolic links lead in a circle; choose"),
            std::string::npos);
  EXPECT_NE(run("arm/urdf/arm.urdf --quiet -o a").err.find("cannot write 'a': Too many levels of symbolic links; choose"),
            std::string::npos);
  EXPECT_TRUE(fs::is_symlink(fs::symlink_status(folder_ / "a")));
}

TEST_F(DecomposeProgram, ARobotByItsPackageName) {
  const Finished result = run("arm_description --json here.json");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("base"), std::string::npos);
  EXPECT_EQ(result.err.rfind("opening 'arm_description'\nreading 1 mesh of 1 link\n", 0), 0u) << result.err;
  EXPECT_EQ(result.err.find('\r'), std::string::npos) << "a bar is for terminals";
  EXPECT_NE(result.out.find("textfile=\"$(find arm_collision)/urdf/arm.urdf\"/>"), std::string::npos) << result.out;
  EXPECT_EQ(fixtures::read(folder_ / "here.json"), fixtures::read(folder_ / "arm_collision/report.json"));
  const json report = json::parse(fixtures::read(folder_ / "here.json"));
  EXPECT_EQ(report["links"][0]["uncovered"], 0.0);
  for (const std::string file : report["links"][0]["files"]) EXPECT_TRUE(fs::exists(folder_ / ("arm_collision/" + file))) << file;
}

TEST_F(DecomposeProgram, SpheresAreNoOtherShape) {
  for (const std::string options : {"--spheres --shapes box", "--shapes spheres --spheres"})
    expectWrongUse("bracket.obj " + options, {"--spheres is --shapes spheres", "leave one of them out"});
}

TEST_F(DecomposeProgram, ARobotWithoutMeshesHasANoteAndNoProgress) {
  const std::string box = "<geometry><box size=\"1 1 1\"/></geometry>";
  fixtures::write(folder_ / "boxes.urdf", fixtures::robot("boxes", fixtures::link("base", "<collision>" + box + "</collision>")));
  const Finished result = run("boxes.urdf");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out.rfind("note: the robot has no meshes; boxes, spheres and cylinders stay as they are, and the output's", 0), 0u)
      << result.out;
}

TEST_F(DecomposeProgram, AFolderThatIsNoPackageNameHasANote) {
  const std::string note = "note: the package is called 'go2_def', as ROS takes no 'go2.def'; Bullet and Gazebo look for a folder";
  EXPECT_NE(run("arm_description -o go2.def").out.find(note), std::string::npos);
  for (const char* fine : {" -o go2_def/", " -o go2.def --uri relative", " -o go2.def --package-name go2"}) {
    const Finished result = run(std::string("arm_description") + fine);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out.find("note: the package"), std::string::npos) << fine << "\n" << result.out;
  }
}

TEST_F(DecomposeProgram, ProposedCommandsKeepTheOptions) {
  fs::copy_file(folder_ / "arm/urdf/arm.urdf", folder_ / "arm/urdf/twin.urdf");
  expectWrongUse("-t 5mm arm_description -o 'my arm'", {"/arm/urdf/twin.urdf", "--tolerance 5mm", "--output 'my arm'"});
}

TEST_F(DecomposeProgram, ThePackageIsCalledAsItsFolder) {
  EXPECT_EQ(run("arm_description --quiet -o cell/my_robot").status, 0);
  EXPECT_NE(fixtures::read(folder_ / "cell/my_robot/package.xml").find("<name>my_robot</name>"), std::string::npos);
  EXPECT_NE(fixtures::read(folder_ / "cell/my_robot/urdf/arm.urdf").find("package://my_robot/meshes/base/"), std::string::npos);
  const Finished named = run("arm_description -o cell/my_robot --package-name arm_hulls");
  EXPECT_NE(fixtures::read(folder_ / "cell/my_robot/package.xml").find("<name>arm_hulls</name>"), std::string::npos);
  EXPECT_NE(fixtures::read(folder_ / "cell/my_robot/urdf/arm.urdf").find("package://arm_hulls/meshes/base/"), std::string::npos);
  EXPECT_NE(named.out.find("$(find arm_hulls)"), std::string::npos) << named.out;
}

TEST_F(DecomposeProgram, StaysWithinItsRoots) {
  fs::create_directories(folder_ / "in");
  fs::create_directories(folder_ / "out");
  fs::copy_file(folder_ / "arm/meshes/bracket.obj", folder_ / "in/bracket.obj");
  fs::copy_file(folder_ / "arm/meshes/bracket.obj", folder_ / "bracket.obj");
  fs::create_symlink(folder_ / "bracket.obj", folder_ / "in/link.obj");
  const std::string roots = " --root in --root out --no-validate";
  EXPECT_EQ(run("in/bracket.obj -o out/a" + roots).status, 0);
  EXPECT_EQ(run("arm_description -o out/b --json out/b.json" + roots).status, 0) << "a package may be read";
  const std::string refusal = "lies outside of the folders that may be ";
  for (const char* mesh : {"bracket.obj", "in/link.obj", "in/../bracket.obj"}) {
    const Finished outside = run(mesh + (" -o out/c" + roots));
    EXPECT_EQ(outside.status, 2) << mesh;
    EXPECT_NE(outside.err.find((folder_ / "bracket.obj") + "', which " + refusal + "read"), std::string::npos) << outside.err;
  }
  for (const char* output : {"c", "in/../c", "out", "."})
    expectWrongUse("in/bracket.obj" + roots + " -o " + output, {refusal + "written", "--root"});
  expectWrongUse("in/bracket.obj -o out/c --json report.json" + roots, {refusal + "written"});
  EXPECT_FALSE(fs::exists(folder_ / "out/c"));
}

TEST_F(DecomposeProgram, PackagesThatNobodyInstalled) {
  const auto robot = [](const std::string& package) {
    const std::string mesh = "    <collision>" + fixtures::meshTag("package://" + package + "/meshes/bracket.obj") + "</collision>\n";
    return fixtures::robot("arm", fixtures::link("base", mesh + mesh) + fixtures::link("tip", mesh, "base"));
  };
  fixtures::write(folder_ / "lost/robot.urdf", robot("lost_description"));
  const Finished lost = run("lost/robot.urdf -o out");
  EXPECT_EQ(lost.status, 1);
  EXPECT_NE(lost.err.find("package 'lost_description' was not found (3 meshes of 2 links)"), std::string::npos) << lost.err;
  EXPECT_EQ(lost.err.find("failed: "), std::string::npos) << lost.err;
  const Finished given = run("lost/robot.urdf -o out --package-path nothing=arm/urdf --package-path lost_description=arm");
  EXPECT_EQ(given.status, 0) << given.err;
  EXPECT_EQ(given.out.find("note:"), std::string::npos) << given.out;
  fixtures::write(folder_ / "arm/urdf/other.urdf", robot("other_description"));
  const Finished nearby = run("arm/urdf/other.urdf -o out");
  EXPECT_EQ(nearby.status, 0) << nearby.err;
  EXPECT_NE(nearby.out.find("note: package 'other_description' was not found: the folder '" + (folder_ / "arm") + "' was used"),
            std::string::npos)
      << nearby.out;
}

TEST_F(DecomposeProgram, AnInputIsNotReplacedByItsResult) {
  EXPECT_EQ(run("arm_description --quiet -o out").status, 0);
  expectWrongUse("out/meshes/base/0_0.stl --quiet -o out", {"'out'", "an input", "choose another output"});
}

TEST_F(DecomposeProgram, RebasedVisualsAreFoundInThePackage) {
  const std::string visual = "    <visual>" + fixtures::meshTag("../meshes/bracket.obj") + "</visual>\n";
  addRobot("arm/urdf/arm.urdf", fixtures::link("base", visual));
  const Finished plain = run("arm_description -o out");
  EXPECT_NE(plain.out.find("1 mesh URI is relative to the folder of the input"), std::string::npos) << plain.out;
  EXPECT_NE(plain.out.find("add --rebase"), std::string::npos) << plain.out;
  const Finished rebased = run("arm_description -o out --rebase");
  EXPECT_EQ(rebased.status, 0) << rebased.err;
  EXPECT_EQ(rebased.out.find("note:"), std::string::npos) << rebased.out;
  const std::string urdf = fixtures::read(folder_ / "out/urdf/arm.urdf");
  EXPECT_NE(urdf.find("<visual>" + fixtures::meshTag("package://arm_description/meshes/bracket.obj") + "</visual>"), std::string::npos)
      << urdf;
  EXPECT_NE(fixtures::read(folder_ / "out/package.xml").find("<exec_depend>arm_description</exec_depend>"), std::string::npos);
  EXPECT_EQ(json::parse(fixtures::read(folder_ / "out/report.json"))["options"]["rebase"], true);
}

TEST_F(DecomposeProgram, OptionsArriveInTheReport) {
  const Finished result =
      run("arm_description --json - -t 2mm -m single_hull --profile physx --max-hulls 3 --seed 7 --jobs 2 --format obj "
          "--uri relative --no-validate --no-cache -o deep/out");
  EXPECT_EQ(result.status, 0) << result.err;
  const json report = json::parse(result.out);  // nothing but JSON
  EXPECT_EQ(report["options"]["tolerance"], "2mm");
  EXPECT_EQ(report["options"]["method"], "single_hull");
  EXPECT_EQ(report["options"]["max-hulls"], 3) << "a limit given by hand wins over the profile's";
  EXPECT_EQ(report["options"]["max-vertices"], 32);
  EXPECT_EQ(report["options"]["format"], "obj");
  EXPECT_EQ(report["seed"], 7);
  EXPECT_TRUE(report["validation"].is_null());
  EXPECT_TRUE(fs::exists(folder_ / "deep/out/meshes/base/0_0.obj"));
}

TEST_F(DecomposeProgram, EachFormatIsReadAgainAsTheSameHull) {
  std::vector<double> volumes;
  for (const std::string format : {"stl", "obj", "dae"}) {
    EXPECT_EQ(run("arm_description -m single_hull --quiet -o out --format " + format).status, 0);
    EXPECT_EQ(run("out/meshes/base/0_0." + format + " -m single_hull --json again.json --quiet -o again").status, 0) << format;
    const json row = json::parse(fixtures::read(folder_ / "again.json"))["links"][0];
    EXPECT_EQ(json::parse(fixtures::read(folder_ / "out/report.json"))["links"][0]["hull_vertices"], row["hull_vertices"]) << format;
    volumes.push_back(row["volume"]);
    EXPECT_NEAR(volumes.back(), volumes.front(), 1e-12 * volumes.front()) << format;
  }
}

TEST_F(DecomposeProgram, AMesh) {
  const Finished result = run("arm/meshes/bracket.obj --quiet");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "");
  const Finished loud = run("arm/meshes/bracket.obj");
  EXPECT_EQ(loud.err.rfind("reading 'arm/meshes/bracket.obj'\n", 0), 0u) << loud.err;
  EXPECT_NE(loud.out.find("Written to " + (folder_ / "bracket_collision") + "\n"), std::string::npos) << loud.out;
  for (const char* file : {"hull_0.stl", "bracket_hulls.obj", "report.json"})
    EXPECT_TRUE(fs::exists(folder_.path() / "bracket_collision" / file)) << file;
}

/// part.gltf in a folder, with its points in a file beside it and its corners in one below.
void writeGltf(const TriangleMesh& mesh, const std::string& folder) {
  std::string points, corners;
  for (const Eigen::Vector3d& v : mesh.vertices)
    for (const double x : v) points += toBytes(static_cast<float>(x));
  for (const Triangle& t : mesh.triangles)
    for (const int corner : t) corners += toBytes(corner);
  const std::string of_points = R"("byteLength": )" + std::to_string(points.size()),
                    of_corners = R"("byteLength": )" + std::to_string(corners.size());
  fixtures::write(
      folder + "/part.gltf",
      R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": )" +
          std::to_string(mesh.vertices.size()) + R"(}, {"bufferView": 1, "componentType": 5125, "type": "SCALAR", "count": )" +
          std::to_string(3 * mesh.triangles.size()) + R"(}], "bufferViews": [{"buffer": 0, )" + of_points + R"(}, {"buffer": 1, )" +
          of_corners + R"(}], "buffers": [{"uri": "points.bin", )" + of_points + R"(}, {"uri": "sub/corners.bin", )" + of_corners + "}]}");
  fixtures::write(folder + "/points.bin", points);
  fixtures::write(folder + "/sub/corners.bin", corners);
}

TEST_F(DecomposeProgram, AMeshWithItsBuffersInFiles) {
  writeGltf(test_shapes::lBracket(0.2, 0.03, 0.1), folder_ / "mesh");
  const auto row = [&] { return json::parse(fixtures::read(folder_ / "part_collision/report.json"))["links"][0]; };
  EXPECT_EQ(run("mesh/part.gltf --quiet").status, 0);
  const json first = row();
  EXPECT_EQ(first["hulls"], 2);
  EXPECT_EQ(run("mesh/part.gltf --quiet").status, 0);
  EXPECT_TRUE(row()["cached"]);
  writeGltf(test_shapes::lBracket(0.2, 0.04, 0.1), folder_ / "mesh");
  EXPECT_EQ(run("mesh/part.gltf --quiet").status, 0);
  EXPECT_FALSE(row()["cached"]) << "other buffers are another mesh";
  EXPECT_NE(row()["sha256"], first["sha256"]);
  fs::remove(folder_ / "mesh/sub/corners.bin");
  const Finished missing = run("mesh/part.gltf --quiet");
  EXPECT_NE(missing.status, 0);
  EXPECT_NE((missing.out + missing.err).find("part.gltf: buffers[1]: '"), std::string::npos) << missing.out << missing.err;
}

TEST_F(DecomposeProgram, AMeshInMillimetres) {
  fixtures::write(folder_ / "bracket.obj", fixtures::obj(test_shapes::lBracket(200, 30, 100)));
  expectWrongUse("bracket.obj --quiet", {"'bracket.obj' is 300 m across", "--scale 0.001"});
  EXPECT_EQ(run("bracket.obj --quiet --scale 0.001").status, 0);
  const json report = json::parse(fixtures::read(folder_ / "bracket_collision/report.json"));
  EXPECT_EQ(report["options"]["scale"], 0.001);
  EXPECT_EQ(report["links"][0]["scale"], json({0.001, 0.001, 0.001}));
  EXPECT_EQ(report["links"][0]["tolerance"], 0.01);
  EXPECT_NEAR(report["links"][0]["diagonal"].get<double>(), 0.3, 1e-9);
}

TEST_F(DecomposeProgram, OneBadLinkAmongGoodOnes) {
  addRobot("bad.urdf", fixtures::link("base", collision("bracket.obj")) + fixtures::link("bad", collision("rubbish.stl"), "base"));
  const Finished result = run("bad.urdf --quiet -o out");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("decompose: link bad: "), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find("rubbish.stl"), result.err.rfind("rubbish.stl")) << "named once: " << result.err;
  EXPECT_EQ(result.err.find("base"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder_ / "out/meshes/base/0_0.stl"));
}

TEST_F(DecomposeProgram, AMissingMeshAmongPrimitives) {
  const std::string box = "    <collision><geometry><box size=\"1 1 1\"/></geometry></collision>\n";
  addRobot("boxes.urdf", fixtures::link("base", box) + fixtures::link("bad", collision("gone.stl"), "base"));
  const Finished result = run("boxes.urdf -o out");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("decompose: link bad: 'package://arm_description/meshes/gone.stl' resolves to "), std::string::npos)
      << result.err;
  EXPECT_EQ(result.err.find("nothing was written"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("note: no mesh could be decomposed: 1 link with primitives"), std::string::npos) << result.out;
  EXPECT_TRUE(fs::exists(folder_ / "out/urdf/arm.urdf"));
}

TEST_F(DecomposeProgram, MissingMeshesOfAFolderAreToldOnce) {
  std::string links = fixtures::link("base", collision("bracket.obj"));
  for (int i = 0; i < 9; ++i) links += fixtures::link("l" + std::to_string(i), collision("fine/" + std::to_string(i) + ".stl"), "base");
  addRobot("bad.urdf", links);
  const Finished result = run("bad.urdf --quiet -o out");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(fixtures::count(result.err, "\n"), 1u) << result.err;
  EXPECT_NE(result.err.find("nor does the folder '" + (folder_ / "arm/meshes/fine") + "'"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("the same for 8 more, of"), std::string::npos) << result.err;
}

TEST_F(DecomposeProgram, NothingDoneLeavesTheOutputAsItWas) {
  addRobot("good.urdf", fixtures::link("base", collision("bracket.obj")));
  addRobot("bad.urdf", fixtures::link("base", collision("rubbish.stl")));
  EXPECT_EQ(run("good.urdf --quiet -o out").status, 0);
  const auto before = fixtures::contents(folder_ / "out");
  const Finished result = run("bad.urdf --quiet -o out --json report.json");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("nothing was written"), std::string::npos) << result.err;
  EXPECT_EQ(fixtures::contents(folder_ / "out"), before);
  EXPECT_TRUE(fs::exists(folder_ / "report.json"));
}

TEST_F(DecomposeProgram, ACacheInTheOutput) {
  const std::string cache = "export COLLISION_HULLS_CACHE=out/cache; ";
  const Finished result = run("arm_description --quiet -o out", cache);
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("/out/cache' lies in output 'out', which is replaced as a whole; set COLLISION_HULLS_CACHE"), std::string::npos)
      << result.err;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  EXPECT_EQ(run("arm_description --quiet --no-cache -o out", cache).status, 0);
}

// A file URI leads to where the folder really is.
TEST_F(DecomposeProgram, FileUrisBehindALink) {
  fs::create_directories(folder_ / "real/deep");
  fs::create_directory_symlink("real/deep", folder_ / "link");
  const Finished result = run("arm_description --uri file -o link/../out");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("Written to " + (folder_ / "real/out") + "\n"), std::string::npos) << result.out;
  const std::string urdf = fixtures::read(folder_ / "real/out/urdf/arm.urdf");
  EXPECT_NE(urdf.find("\"file://" + (folder_ / "real/out/meshes/base/0_0.stl") + "\""), std::string::npos) << urdf;
  EXPECT_TRUE(fs::exists(folder_ / "real/out/meshes/base/0_0.stl"));
}

}  // namespace
}  // namespace collision_hulls
