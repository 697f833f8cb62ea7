// The program verify: exit status, gates, and that it agrees with the report of decompose.
// Also tests src/tools/verify.cpp and src/verify/made_from.cpp.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "shapes.h"
#include "tools/program_test.h"

namespace collision_hulls {
namespace {

using nlohmann::json;

class VerifyProgram : public ProgramTest {
 protected:
  VerifyProgram() : ProgramTest("verify") {
    bracket_ = fixtures::write(folder_ / "bracket.obj", fixtures::obj(test_shapes::lBracket(0.2, 0.03, 0.1)));
    fixtures::write(folder_ / "hulls.obj",
                    fixtures::obj(test_shapes::merged({test_shapes::box(0.2, 0.03, 0.1), test_shapes::box(0.03, 0.2, 0.1)})));
  }
  json measured(const std::string& arguments, int status = 0) {
    const Finished result = run(arguments + " --json -");
    EXPECT_EQ(result.status, status) << result.err;
    return json::parse(result.out);
  }
  std::string bracket_;
};

TEST_F(VerifyProgram, HelpNamesGatesAndStatuses) {
  const Finished result = run("--help");
  EXPECT_EQ(result.status, 0);
  for (const char* part : {"ORIGINAL RESULT", "--max-uncovered", "--max-protrusion", "Exit status: 0", "[1000]"})
    EXPECT_NE(result.out.find(part), std::string::npos) << part;
}

TEST_F(VerifyProgram, WrongUse) {
  expectWrongUse("", {"ORIGINAL is required"});
  expectWrongUse("bracket.obj", {"RESULT is required"});
  expectWrongUse("bracket.obj hulls.obj another", {"unexpected argument 'another'"});
  expectWrongUse("bracket.obj nowhere.obj", {"nowhere.obj", "does not exist"});
  expectWrongUse("bracket.obj hulls.obj --max-uncovered 5furlongs", {"--max-uncovered", "5furlongs", "2cm"});
  expectWrongUse("bracket.obj hulls.obj --max-protrusion 1%", {"--max-protrusion"});
  expectWrongUse("bracket.obj hulls.obj --max-protrusion 5", {"--max-protrusion '5' is", "did you mean 5mm?"});
  expectWrongUse("bracket.obj hulls.obj --close-openings 50", {"--close-openings '50' is"});
  expectWrongUse("bracket.obj hulls.obj --source colision", {"--source", "colision", "visual"});
  expectWrongUse("bracket.obj hulls.obj --links '['", {"--links"});
  expectWrongUse("bracket.obj hulls.obj --json nowhere/r.json",
                 {"--json: cannot write 'nowhere/r.json': there is no folder 'nowhere'; create it, or give another file"});
  std::filesystem::create_symlink("nowhere/r.json", folder_ / "link.json");
  expectWrongUse("bracket.obj hulls.obj --json link.json", {"--json: cannot write 'link.json': there is no folder 'nowhere'"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "nowhere"));
  fixtures::write(folder_ / "r.urdf", fixtures::robot("r", fixtures::link("a", "")));
  expectWrongUse("bracket.obj r.urdf", {"bracket.obj", "is a mesh", "two robots or two meshes"});
  expectWrongUse("r.urdf r.urdf", {"nothing to compare"});
  expectWrongUse("r.urdf r.urdf --links b", {"nothing to compare", "match --links 'b'; ORIGINAL's links are a"});
}

// They go to both, and those that are not .xacro files do without.
TEST_F(VerifyProgram, ArgumentsOfXacroFiles) {
  const std::string arm = fixtures::robot(
      "arm", fixtures::link("base", "    <collision>" + fixtures::meshTag("bracket.obj") + "</collision>\n<!-- $(arg side) -->"));
  for (const char* const file : {"arm.xacro", "arm.urdf", "package/urdf/arm.xacro"}) fixtures::write(folder_ / file, arm);
  fixtures::write(folder_ / "package/package.xml", "<package><name>package</name></package>");
  fixtures::write(folder_ / "package/urdf/bracket.obj", fixtures::read(bracket_));
  fixtures::write(folder_ / "bin/xacro", "#!/bin/sh\ncase $2 in side:=left) exec cat \"$1\" ;; esac\nexit 2\n");
  const std::string before = "chmod +x bin/xacro; PATH=$PWD/bin:$PATH; ";
  for (const char* const both :
       {"arm.xacro arm.xacro", "arm.xacro arm.urdf", "arm.urdf arm.xacro", "package package/", "arm.urdf package"}) {
    EXPECT_EQ(run(std::string(both) + " side:=left", before).status, 0) << both;
    EXPECT_EQ(run(both, before).status, 2) << both;
  }
  expectWrongUse("arm.urdf arm.urdf side:=left", {"'side:=left'", "neither 'arm.urdf' nor 'arm.urdf' is a .xacro file"});
  expectWrongUse("bracket.obj hulls.obj side:=left", {"neither 'bracket.obj' nor 'hulls.obj' is a .xacro file"});
}

TEST_F(VerifyProgram, NobodyHasToReadTheTable) {
  run("bracket.obj hulls.obj 2>&1; echo $? > status) | true", "(");
  EXPECT_EQ(fixtures::read(folder_ / "status"), "0\n");
}

TEST_F(VerifyProgram, TwoMeshesAndTheGates) {
  const Finished table = run("bracket.obj hulls.obj --max-uncovered 0 --max-protrusion 1mm");
  EXPECT_EQ(table.status, 0) << table.err;
  EXPECT_NE(table.out.find("2 hulls"), std::string::npos) << table.out;
  EXPECT_EQ(table.err, "comparing 'bracket.obj' with 'hulls.obj'\n");
  const Finished beyond = run("hulls.obj bracket.obj --max-uncovered 0 --quiet");
  EXPECT_EQ(beyond.out, "");
  fixtures::write(folder_ / "half.obj", fixtures::obj(test_shapes::box(0.2, 0.03, 0.1)));
  const Finished half = run("bracket.obj half.obj --max-uncovered 16cm");
  EXPECT_EQ(half.status, 1);
  EXPECT_NE(half.err.find("verify: mesh: uncovered by up to 170 mm"), std::string::npos) << half.err;
  EXPECT_EQ(run("bracket.obj half.obj --max-uncovered 17.1cm").status, 0);
  EXPECT_EQ(run("bracket.obj half.obj").status, 0);
}

TEST_F(VerifyProgram, OneFileIsBothSides) {
  fixtures::write(folder_ / "r.urdf",
                  fixtures::robot("r", fixtures::link("a", "<visual>" + fixtures::meshTag(bracket_) + "</visual><collision>" +
                                                               fixtures::meshTag(folder_ / "hulls.obj") + "</collision>")));
  const json seen = measured("r.urdf r.urdf --max-uncovered 0 --configurations 10");
  EXPECT_EQ(seen["links"][0]["hulls"], 2);
  EXPECT_EQ(seen["links"][0]["uncovered"]["bound"], 0);
  EXPECT_EQ(seen["queries"]["configurations"], 10);
  EXPECT_EQ(seen["options"]["max-uncovered"], 0);
  EXPECT_TRUE(seen["options"]["max-protrusion"].is_null());
  EXPECT_EQ(seen["passed"], true);
}

TEST_F(VerifyProgram, AMeshThatCannotBeReadIsStatusOne) {
  fixtures::write(folder_ / "r.urdf",
                  fixtures::robot("r", fixtures::link("a", "<collision>" + fixtures::meshTag("lost.stl") + "</collision>")));
  const Finished result = run("r.urdf r.urdf");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("lost.stl"), std::string::npos) << result.err;
  EXPECT_EQ(result.out.find("lost.stl"), std::string::npos) << "said twice\n" << result.out;
}

TEST_F(VerifyProgram, LinksThatAGateRefusesAreSaidQuietly) {
  const std::string mesh = fixtures::write(folder_ / "box.obj", fixtures::obj(test_shapes::box(1, 1, 1)));
  const std::string collision = "<collision>" + fixtures::meshTag(mesh) + "</collision>";
  fixtures::write(folder_ / "all.urdf", fixtures::robot("r", fixtures::link("a", collision) + fixtures::link("b", collision, "a")));
  fixtures::write(folder_ / "less.urdf", fixtures::robot("r", fixtures::link("a", collision) + fixtures::link("b", "", "a")));
  const auto said = [&](const std::string& arguments, int status) {
    const Finished result = run(arguments + " --quiet --configurations 0");
    EXPECT_EQ(result.status, status) << arguments << result.err;
    return result.err;
  };
  EXPECT_EQ(said("all.urdf less.urdf --max-uncovered 1mm", 1), "verify: b: RESULT has no collision geometry here\n");
  EXPECT_EQ(said("less.urdf all.urdf --max-protrusion 1mm", 1), "verify: b: ORIGINAL has no geometry here to compare with\n");
  EXPECT_EQ(said("all.urdf less.urdf --max-protrusion 1mm", 0), "");
  const std::string line = "Not queried: 1 link with geometry on one side alone.\n";
  EXPECT_NE(run("all.urdf less.urdf --configurations 3").out.find(line), std::string::npos);
  EXPECT_EQ(run("all.urdf all.urdf --configurations 3").out.find("Not queried"), std::string::npos);
}

TEST_F(VerifyProgram, AMissingPackageIsSaidOnce) {
  const auto link = [](const std::string& name, const std::string& parent) {
    return fixtures::link(name, "<collision>" + fixtures::meshTag("package://lost/" + name + ".stl") + "</collision>", parent);
  };
  fixtures::write(folder_ / "r.urdf", fixtures::robot("r", link("a", "") + link("b", "a") + link("c", "a")));
  const Finished result = run("r.urdf r.urdf --quiet");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err,
            "verify: a and 2 more links: ORIGINAL: package 'lost' was not found: install it and source its workspace, or say where it is "
            "with --package-path lost=DIR\n");
}

// A few are listed.
TEST_F(VerifyProgram, MissingMeshesOfAFolderAreSaidOnce) {
  const auto said = [&](int links) {
    std::string text;
    for (int i = 0; i < links; ++i)
      text += fixtures::link("l" + std::to_string(i),
                             "<collision>" + fixtures::meshTag("lost/" + std::to_string(i) + ".stl") + "</collision>", i == 0 ? "" : "l0");
    fixtures::write(folder_ / "r.urdf", fixtures::robot("r", text));
    return run("r.urdf r.urdf --quiet").err;
  };
  EXPECT_EQ(fixtures::count(said(3), "\n"), 3u);
  const std::string many = said(9);
  EXPECT_EQ(fixtures::count(many, "\n"), 1u) << many;
  EXPECT_EQ(many.rfind("verify: l0: ORIGINAL: 'lost/0.stl' resolves to ", 0), 0u) << many;
  EXPECT_NE(many.find(" (the same for 8 more, of 9 links in all)\n"), std::string::npos) << many;
}

TEST_F(VerifyProgram, ProposesCommandsWithBothDescriptions) {
  fixtures::write(folder_ / "two/package.xml", "<package><name>two</name></package>");
  for (const char* name : {"a", "b"})
    fixtures::write(folder_ / ("two/urdf/" + std::string(name) + ".urdf"), fixtures::robot(name, fixtures::link("l", "")));
  expectWrongUse("two bracket.obj --max-uncovered 0", {"verify two/urdf/b.urdf bracket.obj --max-uncovered 0"});
  expectWrongUse("two/urdf/a.urdf two --quiet", {"verify two/urdf/a.urdf two/urdf/b.urdf --quiet"});
}

TEST_F(VerifyProgram, RESULTsPackagesAreFoundWhereORIGINALIs) {
  fixtures::write(folder_ / "ws/arm/package.xml", "<package><name>arm</name></package>");
  fixtures::write(folder_ / "ws/arm/meshes/cube.obj", fixtures::obj(test_shapes::box(0.1, 0.1, 0.1)));
  const std::string robot =
      fixtures::robot("r", fixtures::link("a", "<collision>" + fixtures::meshTag("package://arm/meshes/cube.obj") + "</collision>"));
  fixtures::write(folder_ / "ws/arm/urdf/r.urdf", robot);
  fixtures::write(folder_ / "other.urdf", robot);
  EXPECT_EQ(measured("ws/arm other.urdf --max-uncovered 0 --max-protrusion 0.1mm")["links"][0]["status"], "ok");
}

/// Its collision box is larger than its visual one, and decompose prefers the former.
TEST_F(VerifyProgram, OutputOfDecomposeIsComparedWithWhatItWasMadeFrom) {
  const auto cube = [&](const std::string& name, double side) {
    return fixtures::meshTag(fixtures::write(folder_ / name, fixtures::obj(test_shapes::box(side, side, side))));
  };
  const std::string visual = "<visual>" + cube("small.obj", 0.1) + "</visual>",
                    collision = "<collision>" + cube("large.obj", 0.2) + "</collision>";
  fixtures::write(folder_ / "r.urdf", fixtures::robot("r", fixtures::link("a", visual + collision)));
  const std::string decompose = "cd '" + folder_.path().string() + "' && '" PROGRAMS "/decompose' r.urdf -o out --quiet";
  ASSERT_EQ(std::system(decompose.c_str()), 0);
  const auto protrusion = [&](const json& seen) { return seen["links"][0]["protrusion"]["found"].get<double>(); };

  const json by_report = measured("r.urdf out/urdf/r.urdf");
  EXPECT_LT(protrusion(by_report), 1e-6);
  EXPECT_EQ(by_report["options"]["made-from"], folder_ / "out/report.json");
  ASSERT_FALSE(by_report["notes"].empty());
  EXPECT_NE(by_report["notes"][0].get<std::string>().find("--source auto of decompose"), std::string::npos) << by_report["notes"];

  json fit = json::parse(fixtures::read(folder_ / "out/report.json"));
  fit["scene"] = {{"name", "table"}};
  fixtures::write(folder_ / "out/report.json", fit.dump());
  EXPECT_NE(measured("r.urdf out/urdf/r.urdf")["notes"][0].get<std::string>().find("--source auto of fit_scene"), std::string::npos);

  for (const std::string source : {"visual", "auto"}) {
    const json chosen = measured("r.urdf out/urdf/r.urdf --source " + source);
    EXPECT_GT(protrusion(chosen), 0.1) << source;
    EXPECT_TRUE(chosen["options"]["made-from"].is_null());
  }
  // Another robot's report says nothing of this one, nor does the output's of itself.
  fixtures::write(folder_ / "other.urdf", fixtures::robot("other", fixtures::link("a", visual + collision)));
  EXPECT_GT(protrusion(measured("other.urdf out/urdf/r.urdf")), 0.1);
  EXPECT_GT(protrusion(measured("out/urdf/r.urdf out/urdf/r.urdf")), 0.1);
}

TEST_F(VerifyProgram, SaysWhichOpeningsDecomposeClosed) {
  TriangleMesh cup = test_shapes::box(0.1, 0.1, 0.1);
  cup.triangles.resize(10);  // without its lid
  const std::string file = fixtures::write(folder_ / "cup.obj", fixtures::obj(cup));
  fixtures::write(folder_ / "r.urdf", fixtures::robot("r", fixtures::link("a", "<visual>" + fixtures::meshTag(file) + "</visual>")));
  const std::string decompose =
      "cd '" + folder_.path().string() + "' && '" PROGRAMS "/decompose' r.urdf -o out --close-openings 20cm --quiet";
  ASSERT_EQ(std::system(decompose.c_str()), 0);
  const std::string said = "RESULT was made with --close-openings 200mm, as that report says";
  EXPECT_NE(measured("r.urdf out/urdf/r.urdf")["notes"].dump().find(said), std::string::npos);
  EXPECT_EQ(measured("r.urdf out/urdf/r.urdf --close-openings 20cm")["notes"].dump().find(said), std::string::npos);
}

/// What decompose says of its own hulls, and what verify says of the files, made by other code.
TEST_F(VerifyProgram, AgreesWithTheReportOnTheDemoRobot) {
  const std::string urdf = DEMO_ROBOT "/urdf/demo_arm.urdf", in = "'" + urdf + "' ", package_path = " --package-path '" DEMO_ROBOT "'";
  const std::string decompose =
      "cd '" + folder_.path().string() + "' && '" PROGRAMS "/decompose' " + in + package_path + " --source visual -o arm_collision --quiet";
  ASSERT_EQ(std::system(decompose.c_str()), 0);
  const json report = json::parse(fixtures::read(folder_ / "arm_collision/report.json"));
  std::map<std::string, std::pair<double, double>> said;  // by link: bound and found
  for (const json& row : report["links"]) {
    auto& [bound, found] = said[row["link"]];
    bound = std::max(bound, row["protrusion"].get<double>());
    found = std::max(found, row["protrusion_found"].get<double>());
  }
  const json seen =
      measured(in + "arm_collision/urdf/demo_arm.urdf" + package_path + " --source visual --max-uncovered 0 --max-protrusion 1cm");
  EXPECT_EQ(seen["queries"]["missed"], 0);
  EXPECT_EQ(seen["queries"]["contradictions"], 0);
  std::size_t compared = 0;
  for (const json& row : seen["links"]) {
    if (row["status"] != "ok" || !said.count(row["link"])) continue;
    ++compared;
    const auto [bound, found] = said[row["link"]];
    const double mine = row["protrusion"]["bound"], reached = row["protrusion"]["found"], slack = 2e-4 * row["diagonal"].get<double>();
    EXPECT_EQ(row["uncovered"]["bound"], 0) << row["link"];
    EXPECT_GE(mine, reached) << row["link"];
    EXPECT_GE(mine, found - slack) << row["link"];
    EXPECT_LE(reached, bound) << row["link"];
    EXPECT_NEAR(mine, bound, slack) << row["link"];
  }
  EXPECT_EQ(compared, said.size());
}

}  // namespace
}  // namespace collision_hulls
