// Runs in which links differ: rules of Options::rules, and several models.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "collision_hulls/config/config.h"
#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/pipeline/output.h"
#include "pipeline/fixtures.h"
#include "pipeline/mesh_uses.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using fixtures::TempFolder;
using nlohmann::json;

class LinkSettingsTest : public ::testing::Test {
 protected:
  LinkSettingsTest() {
    fixtures::write(folder_ / "bracket.obj", fixtures::obj(test_shapes::lBracket(0.2, 0.03, 0.1)));
    fixtures::write(folder_ / "channel.obj", fixtures::obj(test_shapes::uChannel(0.2, 0.2, 0.02, 0.4)));
    const auto collision = [](const std::string& mesh) { return "    <collision>" + fixtures::meshTag(mesh) + "</collision>\n"; };
    const std::string primitive = "    <collision><geometry><box size=\"1 2 3\"/></geometry></collision>\n";
    fixtures::write(folder_ / "arm.urdf",
                    fixtures::robot("arm", fixtures::link("base", collision("channel.obj") + collision("bracket.obj")) +
                                               fixtures::link("hand", collision("channel.obj"), "base") +
                                               fixtures::link("finger", collision("bracket.obj"), "hand") +
                                               fixtures::link("camera", collision("bracket.obj") + primitive, "hand") +
                                               fixtures::link("frame", "", "hand")));
  }

  RobotResult run(const std::string& config, const std::string& output = "out") {
    Options options;
    apply(parseConfig(config, "f.yaml"), options);
    RobotResult result = decompose(openInput(folder_ / "arm.urdf"), options, folder_ / output);
    writeOutput(result, folder_ / output);
    return result;
  }

  /// "base ok, base ok, hand kept".
  static std::string statuses(const ModelReport& report) {
    std::string text;
    for (const ElementReport& row : report.links) text += (text.empty() ? "" : ", ") + row.link + " " + name(row.status);
    return text;
  }

  /// The links whose row is not from the cache.
  static std::string computed(const RobotResult& result) {
    std::string text;
    for (const ElementReport& row : result.report.links)
      if (!row.cached) text += row.link + " ";
    return text;
  }

  std::map<std::string, std::string> files(const std::string& output = "out") const {
    std::map<std::string, std::string> all = fixtures::contents(folder_ / output);
    for (const char* name : {"report.json", "report.html"}) all.erase(name);
    return all;
  }

  /// Its report names every file, so that another run may replace them.
  bool earlierRunIsReplaced() {
    run("", "out");
    return files().count("meshes/hand/0_0.stl") > 0;
  }

  TempFolder folder_;
};

/// The notes that hold a text.
std::size_t notesWith(const RobotResult& result, const std::string& text) {
  const std::vector<std::string>& notes = result.report.notes;
  return static_cast<std::size_t>(
      std::count_if(notes.begin(), notes.end(), [&](const std::string& note) { return note.find(text) != std::string::npos; }));
}

TEST_F(LinkSettingsTest, WhatChangesNothingIsNoted) {
  const RobotResult result =
      run("default: {method: bounding_box}\nlinks:\n  frame: {max_hulls: 1}\n  (frame|hand): {max_hulls: 2}\n  camera: keep\n");
  EXPECT_EQ(notesWith(result, "changes nothing"), 1u);
  EXPECT_EQ(notesWith(result, "'f.yaml', line 3: links 'frame' changes nothing"), 1u);
  EXPECT_EQ(notesWith(run("regions: [{link: frame, half_space: {normal: [0, 0, 1], offset: 0}, tolerance: 1mm}]", "regions"),
                      "region '1' of link 'frame' changes nothing"),
            1u);
  EXPECT_EQ(notesWith(run("links: {\".*\": keep}", "kept"), "all links are kept or removed"), 1u);
}

TEST_F(LinkSettingsTest, AKeptLinkThatCollidesWithNothingIsNoted) {
  const auto bare = [](const std::string& links) {
    const RobotDescription robot = parseRobotDescription(fixtures::robot("r", links));
    Options options;
    apply(parseConfig("links: {.*: keep}", "f"), options);
    return notesOnBare(robot, firstModelDecisions(options, robot));
  };
  const std::string ball = "<geometry><sphere radius='1'/></geometry>", visual = "<visual>" + ball + "</visual>",
                    collision = "<collision>" + ball + "</collision>";
  EXPECT_TRUE(bare(fixtures::link("a", visual + collision) + fixtures::link("b", "", "a")).empty());
  EXPECT_EQ(
      bare(fixtures::link("a", visual)),
      std::vector<std::string>{"link 'a' is kept, but without <collision> elements: nothing collides there. Decompose it, or add some"});
  EXPECT_EQ(bare(fixtures::link("a", visual) + fixtures::link("b", visual, "a"))[0].find("link 'a' and 1 more link are kept, but"), 0u);
}

TEST_F(LinkSettingsTest, AnOutputThatIsDecomposedAgainIsNoted) {
  EXPECT_EQ(notesWith(run("default: {method: bounding_box}"), "output of an earlier run"), 0u);
  Options options;
  options.method = Method::kBoundingBox;
  EXPECT_EQ(notesWith(decompose(openInput(folder_ / "out"), options, folder_ / "again"), "output of an earlier run"), 1u);
}

TEST_F(LinkSettingsTest, ContactSensorsThatLoseTheirCollisionAreNoted) {
  const std::string arm = fixtures::read(folder_ / "arm.urdf"), end = "</robot>";
  const auto with = [&](const std::string& collision) {
    fixtures::write(folder_ / "arm.urdf", arm.substr(0, arm.rfind(end)) + "<gazebo reference=\"hand\"><sensor><contact><collision> " +
                                              collision + " </collision></contact></sensor></gazebo>" + end);
    return run("default: {method: bounding_box}\nlinks: {camera: keep}");
  };
  EXPECT_EQ(notesWith(with("hand_collision"), "names the collision 'hand_collision'"), 1u);
  EXPECT_EQ(notesWith(with("camera_collision"), "names the collision"), 0u) << "it is kept";
  EXPECT_EQ(notesWith(with("other"), "names the collision"), 0u);
}

TEST_F(LinkSettingsTest, SettingsForMuJoCoAreNoted) {
  const std::string arm = fixtures::read(folder_ / "arm.urdf"), end = "</robot>";
  const auto notesWithCompiler = [&](const std::string& attributes) {
    fixtures::write(folder_ / "arm.urdf", arm.substr(0, arm.rfind(end)) + "<mujoco><compiler " + attributes + "/></mujoco>" + end);
    return notesWith(run("default: {method: bounding_box}"), "MuJoCo does not find the hulls of a URDF: --for mujoco");
  };
  EXPECT_EQ(notesWith(run("default: {method: bounding_box}"), "MuJoCo"), 0u);
  EXPECT_EQ(notesWithCompiler("meshdir=\"meshes\" balanceinertia=\"true\""), 1u);
  EXPECT_EQ(notesWithCompiler("strippath=\"false\""), 0u) << "it finds relative URIs";
}

TEST_F(LinkSettingsTest, EachLinkHasItsOwn) {
  const RobotResult result = run("default: {tolerance: 1cm}\nlinks: {hand: {method: bounding_box}, base: {tolerance: 5cm, max_hulls: 1}}");
  const std::vector<ElementReport>& rows = result.report.links;
  EXPECT_EQ(statuses(result.report), "base degraded, base degraded, hand degraded, finger ok, camera ok");
  EXPECT_EQ(rows[0].hulls, 1u) << "max_hulls holds for all elements of the link";
  EXPECT_EQ(rows[1].hulls, 1u);
  EXPECT_EQ(rows[1].tolerance, 0.05);
  EXPECT_EQ(rows[2].method, Method::kBoundingBox);
  EXPECT_EQ(rows[2].hull_vertices, 8u);
  EXPECT_EQ(rows[3].method, Method::kCertified);
  EXPECT_EQ(rows[3].hulls, 2u) << "the bracket of the base is the same mesh with other options";
}

TEST_F(LinkSettingsTest, KeptAndRemovedLinks) {
  const RobotResult result = run("links: {hand: keep, camera|frame: remove}");
  EXPECT_EQ(statuses(result.report), "base ok, base ok, hand kept, finger ok, camera removed, frame removed");
  const RobotDescription before = readRobotDescription(folder_ / "arm.urdf"), after = parseRobotDescription(result.urdf);
  ASSERT_EQ(after.links[1].collisions.size(), 1u);
  EXPECT_EQ(after.links[1].collisions[0].uri, "channel.obj") << "kept as it was";
  EXPECT_TRUE(after.links[3].collisions.empty()) << "its box goes, too";
  EXPECT_EQ(before.links[3].collisions.size(), 2u);
  const json report = json::parse(toJson(result.report));
  EXPECT_EQ(report["links"][2]["status"], "kept");
  EXPECT_EQ(report["links"][2]["uri"], "channel.obj");
  EXPECT_EQ(report["links"][2]["method"], "");
  EXPECT_EQ(report["links"][5]["reason"], "the link has no collision mesh");
  EXPECT_EQ(report["totals"]["meshes"], 3);
  EXPECT_EQ(report["totals"]["kept"], 1);
  EXPECT_EQ(report["totals"]["removed"], 2);
  const std::string table = toTable(result.report);
  EXPECT_NE(table.find("3 ok, 1 kept, 2 removed"), std::string::npos) << table;
  EXPECT_TRUE(earlierRunIsReplaced());
}

TEST_F(LinkSettingsTest, WhereNothingIsDecomposed) {
  const RobotResult result = run("links: {.*: keep}");
  EXPECT_FALSE(anyFailed(result.report) || allFailed(result.report));
  EXPECT_EQ(result.urdf, readRobotDescription(folder_ / "arm.urdf").text);
  EXPECT_EQ(run("links: {.*: remove}").report.links.size(), 6u);
}

TEST_F(LinkSettingsTest, ChangingOneLinkCostsOneLink) {
  run("default: {tolerance: 1cm}");
  const RobotResult changed = run("default: {tolerance: 1cm}\nlinks: {hand: {tolerance: 2mm}}");
  EXPECT_EQ(computed(changed), "hand ");
  EXPECT_EQ(computed(run("default: {tolerance: 1cm}\nlinks: {hand: {tolerance: 2mm}, camera: keep, finger: {source: visual}}")), "camera ")
      << "what is kept is never read, and the source is no part of the work";
  EXPECT_EQ(computed(run("default: {tolerance: 1cm, max_hulls: 50}\nlinks: {hand: {method: bounding_box}}")).find("hand"), 10u);
}

TEST_F(LinkSettingsTest, TheFileItWritesRepeatsTheRun) {
  for (const char* config :
       {"", "default: {tolerance: 2cm, max_vertices: 16}\nlinks: {hand: keep, \".*ger\": {tolerance: 3mm}, camera: remove}\nseed: 5",
        "only: hand|base\noutput: {format: obj, uri: relative, package_name: arm_hulls}",
        "default: {method: hacd}\noutput: {segments: true}\nlinks: {finger: {method: single_hull}}",
        "models: {planning: 5cm, contact: 2mm}\nlinks: {base: {method: bounding_box}}\ndefault: {tree: 1mm}"}) {
    std::filesystem::remove_all(folder_ / "out");
    run(config);
    const auto first = files();
    const std::string written = first.at("config/arm_hulls.yaml");
    run(written);
    EXPECT_EQ(files(), first) << config;
    EXPECT_TRUE(first.count("CMakeLists.txt") && first.at("CMakeLists.txt").find("config") != std::string::npos) << "it is installed";
  }
}

TEST_F(LinkSettingsTest, RulesThatDoNotSuitTheRobot) {
  for (const char* config : {"links: {hnad: keep}", "links: {hand: keep, .*: {tolerance: 1mm}}", "only: nothing"})
    EXPECT_THROW(run(config), Error) << config;
}

TEST_F(LinkSettingsTest, ModelsOfOneRun) {
  const RobotResult result = run("models: {planning: 10cm, contact: 2mm}\nlinks: {finger: {method: bounding_box}, camera: keep}");
  ASSERT_EQ(result.report.models.size(), 1u);
  EXPECT_EQ(result.report.model, "planning");
  EXPECT_EQ(result.report.models[0].model, "contact");
  EXPECT_EQ(statuses(result.report.models[0]), "base ok, base ok, hand ok, finger degraded, camera kept");
  EXPECT_LT(result.report.links[0].hulls, result.report.models[0].links[0].hulls);
  for (const ModelReport* model : {static_cast<const ModelReport*>(&result.report), &result.report.models[0]}) {
    EXPECT_GT(model->validation.queries, 0u);
    EXPECT_EQ(model->validation.missed + model->validation.phantom, 0u);
  }
  const auto written = files();
  EXPECT_EQ(written.at("urdf/arm.urdf"), result.urdf);
  EXPECT_EQ(written.at("urdf/arm_contact.urdf"), result.models[0].urdf);
  EXPECT_EQ(result.report.links[3].files, result.report.models[0].links[3].files) << "equal hulls share a file";
  EXPECT_EQ(fixtures::count(result.models[0].urdf, "meshes/hand/"), result.report.models[0].links[2].hulls);
  const json report = json::parse(fixtures::read(folder_ / "out/report.json"));
  EXPECT_EQ(report["models"][0]["urdf"], "urdf/arm_contact.urdf");
  EXPECT_EQ(report["models"][0]["totals"]["meshes"], 4);
  EXPECT_NE(toTable(result.report).find("model 'contact', urdf/arm_contact.urdf"), std::string::npos);
  EXPECT_TRUE(earlierRunIsReplaced());
}

TEST_F(LinkSettingsTest, AModelIsWhatARunWithItsToleranceGives) {
  const RobotResult both = run("models: {planning: 10cm, contact: 2mm}"), fine = run("default: {tolerance: 2mm}", "fine");
  ASSERT_EQ(both.models[0].elements.size(), fine.elements.size());
  for (std::size_t i = 0; i < fine.elements.size(); ++i) {
    ASSERT_EQ(both.models[0].elements[i].hulls.size(), fine.elements[i].hulls.size());
    for (std::size_t h = 0; h < fine.elements[i].hulls.size(); ++h)
      EXPECT_EQ(both.models[0].elements[i].hulls[h].vertices, fine.elements[i].hulls[h].vertices);
  }
}

TEST_F(LinkSettingsTest, AMeshHasNoLinksAndOneModel) {
  for (const char* config : {"links: {hand: keep}", "models: {a: 1cm}", "only: a"}) {
    Options options;
    apply(parseConfig(config, "f.yaml"), options);
    EXPECT_THROW(decomposeMesh(folder_ / "bracket.obj", options), Error) << config;
  }
  Options options;
  apply(parseConfig("default: {method: bounding_box}", "f.yaml"), options);
  EXPECT_EQ(decomposeMesh(folder_ / "bracket.obj", options).report.links[0].hull_vertices, 8u);
}

/// The files of the robots that are shared with other projects; none where they are not there.
std::vector<std::string> sharedRobots() {
  const std::filesystem::path folder = SHARED_DATA "/robots";
  std::vector<std::string> files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".urdf") files.push_back(entry.path().string());
  return files;
}

// Boxes, since hulls would take minutes.
TEST(LinkSettingsOfSharedRobots, ThreeLinksDifferFromTheOthers) {
  if (sharedRobots().empty()) GTEST_SKIP() << "no ../shared/robots";
  for (const std::string& file : sharedRobots()) {
    const Input input = openInput(file);
    Options options;
    options.method = Method::kBoundingBox;
    options.validate = false;
    const RobotResult boxes = decompose(input, options, "out");
    std::vector<std::string> links;
    for (const ElementReport& row : boxes.report.links)
      if (links.empty() || links.back() != row.link) links.push_back(row.link);
    ASSERT_GE(links.size(), 3u) << file;
    apply(parseConfig("links: {" + links[0] + ": {method: single_hull}, " + links[1] + ": keep, " + links[2] + ": remove}", "f"), options);
    for (const ElementReport& row : decompose(input, options, "out").report.links) {
      const std::string context = file + " " + row.link;
      EXPECT_EQ(row.status == Status::kKept, row.link == links[1]) << context;
      EXPECT_EQ(row.status == Status::kRemoved, row.link == links[2]) << context;
      const bool has_hulls = row.link != links[1] && row.link != links[2];
      EXPECT_EQ(row.method == Method::kSingleHull, row.link == links[0] && has_hulls) << context;
    }
  }
}

}  // namespace
}  // namespace collision_hulls
