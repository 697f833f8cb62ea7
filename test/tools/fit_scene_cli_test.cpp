// The program fit_scene: exit status, streams, files.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <nlohmann/json.hpp>

#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using fixtures::TempFolder;
using nlohmann::json;

struct Finished {
  int status = -1;
  std::string out, err;
};

class FitSceneProgram : public ::testing::Test {
 protected:
  FitSceneProgram() {
    fixtures::write(folder_ / "bracket.obj", fixtures::obj(test_shapes::lBracket(0.2, 0.03, 0.1)));
    fixtures::write(folder_ / "arm.urdf",
                    fixtures::robot("arm", fixtures::link("base", "    <visual>" + fixtures::meshTag("bracket.obj") + "</visual>\n")));
    fixtures::write(folder_ / "notch.yaml",
                    "name: notch\nbodies:\n- {name: block, box: [0.03, 0.03, 0.03], pose: {xyz: [0.075, 0.075, 0.05]}}\n");
  }

  Finished run(const std::string& arguments) {
    const std::string command = "cd '" + folder_.path().string() + "' && '" PROGRAMS "/fit_scene' " + arguments + " >'" +
                                (folder_ / ".out") + "' 2>'" + (folder_ / ".err") + "'";
    const int status = std::system(command.c_str());
    Finished result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, fixtures::read(folder_ / ".out"), fixtures::read(folder_ / ".err")};
    fs::remove(folder_ / ".out");
    fs::remove(folder_ / ".err");
    return result;
  }

  void expectWrongUse(const std::string& arguments, const std::vector<std::string>& parts) {
    const auto before = fixtures::contents(folder_.path());
    const Finished result = run(arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_EQ(result.out, "") << arguments;
    for (const std::string& part : parts) EXPECT_NE(result.err.find(part), std::string::npos) << arguments << "\n" << result.err;
    EXPECT_EQ(fixtures::contents(folder_.path()), before) << arguments;
  }

  TempFolder folder_;
};

TEST_F(FitSceneProgram, Help) {
  const Finished result = run("--help");
  EXPECT_EQ(result.status, 0);
  for (const char* part : {"--scene", "--clearance", "--samples", "[10000]", "--configurations", "--srdf", "--compare", "--tolerance"})
    EXPECT_NE(result.out.find(part), std::string::npos) << part;
}

TEST_F(FitSceneProgram, WrongUse) {
  expectWrongUse("arm.urdf", {"--scene"});
  expectWrongUse("arm.urdf --scene notch.yaml", {"--clearance"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 0", {"--clearance '0'", "2cm"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 2%", {"--clearance '2%'"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --samples 0", {"--samples '0'"});
  expectWrongUse("arm.urdf --scene nowhere.yaml --clearance 1cm", {"nowhere.yaml"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --srdf none.srdf", {"none.srdf"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm --configurations none.csv", {"none.csv"});
  expectWrongUse("arm.urdf --scene notch.yaml --clearance 1cm -m hacd", {"hacd", "certified"});
  expectWrongUse("bracket.obj --scene notch.yaml --clearance 1cm", {"bracket.obj", "mesh"});
}

TEST_F(FitSceneProgram, FitsAndTells) {
  const Finished result = run("arm.urdf --scene notch.yaml --clearance 1cm --samples 50 --json r.json --compare c.csv --no-validate");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("base: 2 hulls: against block at 30 mm"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("scene 'notch': 2 of 2 hulls for a clearance of 10 mm"), std::string::npos) << result.out;
  EXPECT_EQ(json::parse(fixtures::read(folder_ / "r.json"))["scene"]["missed"], 0);
  const std::string csv = fixtures::read(folder_ / "c.csv");
  EXPECT_EQ(csv.rfind("robot,scene,clearance,model,", 0), 0u);
  EXPECT_NE(csv.find("\narm,notch,0.01,fitted,"), std::string::npos) << csv;
  EXPECT_TRUE(fs::exists(folder_ / "arm_collision/config/arm_disabled.srdf"));
}

}  // namespace
}  // namespace collision_hulls
