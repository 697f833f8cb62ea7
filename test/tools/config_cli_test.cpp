// Configurations on the command lines of decompose and fit_scene.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "shapes.h"
#include "tools/program_test.h"

namespace collision_hulls {
namespace {

using nlohmann::json;

class ConfigOfProgram : public ProgramTest {
 protected:
  explicit ConfigOfProgram(const std::string& name) : ProgramTest(name) {
    fixtures::write(folder_ / "arm_description/package.xml", "<package format=\"2\"><name>arm_description</name></package>");
    fixtures::write(folder_ / "arm_description/bracket.obj", fixtures::obj(test_shapes::lBracket(0.2, 0.03, 0.1)));
    const std::string visual = "    <visual>" + fixtures::meshTag("package://arm_description/bracket.obj") + "</visual>\n";
    fixtures::write(folder_ / "arm.urdf", fixtures::robot("arm", fixtures::link("base", visual) + fixtures::link("hand", visual, "base")));
    fixtures::write(folder_ / "hand.yaml", "default: {tolerance: 5mm}\nlinks:\n  hand: {max_hulls: 1}\n");
  }

  json report(const std::string& output = "out") const { return json::parse(fixtures::read(folder_ / (output + "/report.json"))); }
};

class DecomposeConfig : public ConfigOfProgram {
 protected:
  DecomposeConfig() : ConfigOfProgram("decompose") {}
};

TEST_F(DecomposeConfig, SetsLinks) {
  EXPECT_EQ(run("arm.urdf --config hand.yaml -o out").status, 0);
  EXPECT_EQ(report()["options"]["tolerance"], "5mm");
  EXPECT_EQ(report()["links"][0]["hulls"], 2);
  EXPECT_EQ(report()["links"][1]["hulls"], 1);
  EXPECT_EQ(report()["notes"], json::array());
}

TEST_F(DecomposeConfig, TheCommandLineCountsAndSaysSo) {
  EXPECT_EQ(run("arm.urdf --config hand.yaml -o out -t 2cm --effort best").status, 0);
  EXPECT_EQ(report()["options"]["tolerance"], "2cm");
  EXPECT_EQ(report()["links"][1]["hulls"], 1) << "a rule counts before both";
  EXPECT_EQ(report()["notes"], json({"--tolerance counts in place of 'tolerance' in 'hand.yaml'"}));
  EXPECT_EQ(run("arm.urdf --config hand.yaml -o out -t 1cm,5%").status, 0);
  EXPECT_EQ(report()["options"]["tolerance"], "1cm,5%") << "also where it is the default";
}

TEST_F(DecomposeConfig, WrongUse) {
  expectWrongUse("arm.urdf --config ''", {"--config", "a file"});
  expectWrongUse("arm.urdf --config none.yaml", {"none.yaml", "does not exist"});
  expectWrongUse("arm.urdf --config .", {"configuration", "'.'"});
  expectWrongUse("arm.urdf --config hand.yaml -m hacd --links hand --effort best", {"effort", "'best'", "'hacd'"});
  expectWrongUse("arm_description/bracket.obj --config hand.yaml", {"'hand.yaml', line 3", "links 'hand'", "is a single mesh"});
  fixtures::write(folder_ / "fill.yaml", "links: {hand: {fill: true}}");
  expectWrongUse("arm.urdf --config fill.yaml -m acd", {"'fill.yaml', line 1", "'acd'", "'certified'"});
  fixtures::write(folder_ / "typo.yaml", "links:\n  hnad: keep");
  expectWrongUse("arm.urdf --config typo.yaml", {"'typo.yaml', line 2", "'hnad' matches no link", "did you mean 'hand'?"});
  fixtures::write(folder_ / "outside/a.yaml", "");
  expectWrongUse("arm.urdf --config /etc/hostname --root '" + folder_.path().string() + "'", {"/etc/hostname", "--root"});
}

TEST_F(DecomposeConfig, AFileInTheOutputStaysIfTheRunWritesTheSame) {
  EXPECT_EQ(run("arm.urdf --config hand.yaml -o out").status, 0);
  const std::string written = fixtures::read(folder_ / "out/config/arm_hulls.yaml");
  EXPECT_EQ(run("arm.urdf --config out/config/arm_hulls.yaml -o out").status, 0);
  EXPECT_EQ(fixtures::read(folder_ / "out/config/arm_hulls.yaml"), written);
  fixtures::write(folder_ / "out/config/arm_hulls.yaml", written + "# a comment that would be lost\n");
  expectWrongUse("arm.urdf --config out/config/arm_hulls.yaml -o out", {"lies in the output folder", "copy it"});
}

TEST_F(DecomposeConfig, Models) {
  EXPECT_EQ(run("arm.urdf --model planning=10cm --model contact=2mm -o out").status, 0);
  EXPECT_EQ(report()["model"], "planning");
  EXPECT_EQ(report()["models"][0]["model"], "contact");
  EXPECT_EQ(report()["models"][0]["links"].size(), 2u);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/urdf/arm_contact.urdf"));
  fixtures::write(folder_ / "models.yaml", "models: {a: 1cm, b: 2cm, c: 3cm}");
  EXPECT_EQ(run("arm.urdf --config models.yaml --model only=1cm -o out").status, 0);
  EXPECT_FALSE(report().contains("models"));
  EXPECT_EQ(report()["notes"], json({"--model counts in place of 'models' in 'models.yaml'"}));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/urdf/arm_contact.urdf"));
}

TEST_F(DecomposeConfig, WrongModels) {
  expectWrongUse("arm.urdf --model 1cm", {"--model '1cm'", "contact=2mm"});
  expectWrongUse("arm.urdf --model fine=", {"--model fine ''", "5mm"});
  expectWrongUse("arm.urdf --model =1cm", {"model ''", "letters"});
  expectWrongUse("arm.urdf --model ../x=1cm", {"model '../x'", "letters"});
  expectWrongUse("arm.urdf --model a=1cm --model a=2cm", {"model 'a' is given twice"});
  expectWrongUse("arm.urdf --model a=1cm -t 2cm", {"--tolerance contradicts --model"});
  expectWrongUse("arm_description/bracket.obj --model a=1cm", {"model 'a'", "is a single mesh"});
}

class FitSceneConfig : public ConfigOfProgram {
 protected:
  FitSceneConfig() : ConfigOfProgram("fit_scene") {
    fixtures::write(folder_ / "notch.yaml",
                    "name: notch\nbodies:\n- {name: block, box: [0.03, 0.03, 0.03], pose: {xyz: [0.075, 0.075, 0.05]}}\n");
  }
  const std::string scene_ = "arm.urdf --scene notch.yaml --clearance 1cm --samples 50 --hulls-only -o out ";
};

TEST_F(FitSceneConfig, SetsLinks) {
  EXPECT_EQ(run(scene_ + "--config hand.yaml").status, 0);
  EXPECT_EQ(report()["options"]["tolerance"], "5mm");
  EXPECT_EQ(report()["links"][0]["hulls"], 2) << "the block lies in its notch";
  EXPECT_EQ(report()["scene"]["full_hulls"], 4) << "max_hulls holds for the fit, not for the trees";
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/config/arm_hulls.yaml"));
}

TEST_F(FitSceneConfig, RemovedLinksHaveNoPart) {
  fixtures::write(folder_ / "keep.yaml", "links: {hand: remove}");
  EXPECT_EQ(run(scene_ + "--config keep.yaml").status, 0);
  EXPECT_EQ(report()["links"][1]["status"], "removed");
  EXPECT_EQ(report()["scene"]["links"].size(), 1u);
}

TEST_F(FitSceneConfig, AKeptLinkIsStillNextToOthers) {
  std::string description = fixtures::read(folder_ / "arm.urdf");
  for (std::size_t at = 0; (at = description.find("visual>", at)) != std::string::npos;) description.replace(at, 6, "collision");
  fixtures::write(folder_ / "arm.urdf", description);
  fixtures::write(folder_ / "keep.yaml", "links: {hand: keep}");
  EXPECT_EQ(run(scene_ + "--config keep.yaml").status, 0);
  const std::string disabled = fixtures::read(folder_ / "out/config/arm_disabled.srdf");
  EXPECT_NE(disabled.find("<disable_collisions link1=\"base\" link2=\"hand\" reason=\"Adjacent\""), std::string::npos) << disabled;
}

TEST_F(FitSceneConfig, WrongUse) {
  fixtures::write(folder_ / "box.yaml", "links:\n  hand: {method: bounding_box}");
  expectWrongUse(scene_ + "--config box.yaml", {"'box.yaml', line 2", "method 'bounding_box' of link 'hand'", "or keep the link"});
  fixtures::write(folder_ / "models.yaml", "models: {a: 1cm}");
  expectWrongUse(scene_ + "--config models.yaml", {"model 'a'", "fitting makes one model"});
  fixtures::write(folder_ / "none.yaml", "links: {.*: keep}");
  expectWrongUse(scene_ + "--config none.yaml", {"no mesh"});
}

}  // namespace
}  // namespace collision_hulls
