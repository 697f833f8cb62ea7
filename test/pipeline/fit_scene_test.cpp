// Also tests src/pipeline/scene_request.cpp and src/pipeline/scene/kept_bodies.cpp.
#include "collision_hulls/pipeline/fit_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/output.h"
#include "pipeline/fixtures.h"
#include "pipeline/scene_run.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using fixtures::FitRobotToScene;
using nlohmann::json;

TEST_F(FitRobotToScene, BlockInTheNotchNeedsTwoHulls) {
  options_.validate = true;
  request_.primitives = false;
  RobotResult result = run(fixtures::link("base", bracket()));
  ASSERT_EQ(result.elements.size(), 1u);
  EXPECT_EQ(result.elements[0].hulls.size(), 2u);
  EXPECT_TRUE(result.elements[0].unneeded.empty());
  const ElementReport& row = result.report.links[0];
  EXPECT_EQ(row.uncovered, 0);
  EXPECT_EQ(row.files.size(), 2u);
  EXPECT_EQ(result.report.validation.missed + result.report.validation.phantom, 0u);
  EXPECT_GT(result.report.validation.queries, 0u);
  const SceneBody& block = request_.scene.bodies.at(0);
  EXPECT_EQ(result.scene.triangles, std::get<ConvexHull>(block.shape).triangles);
  EXPECT_EQ(result.scene.vertices[3], block.pose * std::get<ConvexHull>(block.shape).vertices[3]);

  writeOutput(result, folder_ / "out");
  const auto files = fixtures::contents(folder_ / "out");
  EXPECT_EQ(files.count("config/arm_disabled.srdf"), 1u);
  EXPECT_EQ(files.count("meshes/base/0_1.stl"), 1u);
  EXPECT_NE(files.at("CMakeLists.txt").find("config meshes urdf"), std::string::npos);
  const json scene = json::parse(files.at("report.json"))["scene"];
  for (const char* field : {"samples", "missed", "phantom", "phantom_rate_bound", "proved_pairs", "query_us", "original_query_us"})
    EXPECT_TRUE(scene[field].is_number()) << field;
  ASSERT_EQ(scene["links"].size(), 1u);
  EXPECT_EQ(scene["links"][0]["link"], "base");
  EXPECT_EQ(scene["links"][0]["hulls"], 2);
  EXPECT_EQ(scene["links"][0]["proved"], false);
  EXPECT_EQ(scene["links"][0]["primitive"], "");
  EXPECT_EQ(scene["links"][0]["reason"], "2 hulls: against block at 30 mm");
}

TEST_F(FitRobotToScene, TellsHowFarItIs) {
  options_.validate = true;
  std::vector<std::string> stages;
  std::vector<double> fractions;
  run(fixtures::link("base", bracket()), [&](const Step& step) {
    if (stages.empty() || stages.back() != step.stage) stages.push_back(step.stage);
    fractions.push_back(step.fraction);
  });
  EXPECT_EQ(stages, (std::vector<std::string>{"read", "decompose", "fit", "certify", "validate"}));
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.front(), 0);
  EXPECT_EQ(fractions.back(), 1);
}

TEST_F(FitRobotToScene, TwoBoxesReplaceTheHulls) {
  options_.validate = true;
  RobotResult result = run(fixtures::link("base", bracket()));
  const ElementResult& element = result.elements[0];
  const ElementReport& row = result.report.links[0];
  ASSERT_EQ(element.primitives.size(), 2u);
  EXPECT_EQ(element.hulls.size(), 2u);
  EXPECT_TRUE(row.files.empty());
  EXPECT_EQ(row.uncovered, 0);
  EXPECT_LT(row.protrusion, 1e-3);
  EXPECT_EQ(result.report.scene->links[0].primitive, "2 boxes");
  EXPECT_EQ(result.report.scene->links[0].reason, "2 boxes: against block at 30 mm");
  EXPECT_EQ(result.report.scene->missed + result.report.scene->phantom, 0u);
  EXPECT_EQ(result.report.validation.missed + result.report.validation.phantom, 0u);

  // As written to the description, the two boxes contain all of the bracket's corners.
  const RobotDescription written = parseRobotDescription(result.urdf);
  const std::vector<GeometryElement>& boxes = written.links[0].collisions;
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_NE(boxes[0].name, boxes[1].name);
  for (const Eigen::Vector3d& corner : element.original.vertices) {
    const auto holds = [&](const GeometryElement& box) {
      return ((box.origin.inverse() * corner).cwiseAbs() - box.size / 2).maxCoeff() <= 0;
    };
    EXPECT_TRUE(holds(boxes[0]) || holds(boxes[1])) << corner.transpose();
  }
}

TEST_F(FitRobotToScene, HullsWithFilesBesidePrimitives) {
  // A hexagonal bar with a post beside one of its flat sides, which rules out its box and its cylinder; and, far away, a plate.
  std::vector<Eigen::Vector3d> bar, plate;
  for (int i = 0; i < 12; ++i) {
    const double angle = EIGEN_PI / 3 * i;
    bar.emplace_back(0.1 * std::cos(angle), 0.1 * std::sin(angle), i < 6 ? 0 : 0.3);
  }
  for (int i = 0; i < 8; ++i) plate.emplace_back(i & 1 ? 0.7 : 0.5, i & 2 ? 0.1 : -0.1, i & 4 ? 0.3 : 0.28);
  const TriangleMesh mesh = test_shapes::merged({surface(convexHull(bar)), surface(convexHull(plate))});
  fixtures::write(folder_ / "meshes/bracket.obj", fixtures::obj(mesh));
  request_.scene = {"posts", {}};
  for (int i = 0; i < 6; ++i) {
    const double angle = EIGEN_PI / 3 * (i + 0.5), out = 0.1 * std::cos(EIGEN_PI / 6) + 0.011;
    SceneBody post{"post" + std::to_string(i), boxShape({0.01, 0.01, 0.4})};
    post.pose = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * Eigen::Translation3d(out + 0.005, 0, 0.15);
    request_.scene.bodies.push_back(post);
  }
  RobotResult result = run(fixtures::link("base", bracket()));
  const ElementResult& element = result.elements[0];
  const ElementReport& row = result.report.links[0];
  ASSERT_EQ(row.files.size(), 1u);
  ASSERT_EQ(element.primitives.size(), 1u);
  EXPECT_EQ(row.hulls, 1u);
  EXPECT_EQ(result.report.scene->links[0].hulls, 1u);
  EXPECT_EQ(result.report.scene->links[0].primitive, "1 box");
  EXPECT_EQ(result.report.scene->links[0].reason.substr(0, 15), "1 hull, 1 box: ");

  writeOutput(result, folder_ / "out");
  EXPECT_EQ(fixtures::contents(folder_ / "out").count("meshes/base/0_0.stl"), 1u);
  EXPECT_EQ(fixtures::contents(folder_ / "out").count("meshes/base/0_1.stl"), 0u);
  EXPECT_EQ(parseRobotDescription(result.urdf).links[0].collisions.size(), 2u);
}

TEST_F(FitRobotToScene, WhatIsKeptTakesPartAsItIs) {
  fixtures::write(folder_ / "meshes/peg.obj", fixtures::obj(surface(boxShape(Eigen::Vector3d::Constant(0.03)))));
  request_.scene.bodies[0].pose = at(9, 9, 9);
  request_.primitives = false;
  RobotResult result;
  const auto hullsOfBase = [&](const std::string& peg) {
    result = run(pegInNotch(bracket(), peg));
    return result.elements.at(0).hulls.size();
  };
  const std::string mesh = collision(fixtures::meshTag("../meshes/peg.obj"));
  LinkRule rule;
  rule.pattern = "peg";
  rule.settings.action = Action::kRemove;
  options_.rules = {rule};
  EXPECT_EQ(hullsOfBase(mesh), 1u) << "nothing is in the notch";
  options_.rules[0].settings.action = Action::kKeep;
  EXPECT_EQ(hullsOfBase(mesh), 2u) << "the peg turns in the notch";
  const std::size_t pairs = result.report.scene->pairs;
  EXPECT_EQ(result.report.scene->phantom, 0u);
  EXPECT_EQ(hullsOfBase(collision("<geometry><box size=\"0.03 0.03 0.03\"/></geometry>")), 2u);
  const auto peg = [](const std::string& more) { return fixtures::meshTag("../meshes/peg.obj", more); };
  for (const std::string& bad : {fixtures::meshTag("../meshes/rubbish.stl"), peg(" scale=\"0.001 0.001\""), peg(" scale=\"1e300 1 1\""),
                                 std::string("<geometry><box size=\"1e7 1 1\"/></geometry>")}) {
    EXPECT_EQ(hullsOfBase(collision(bad) + mesh), 1u);
    EXPECT_TRUE(isNoted(result, ": the fit ignores the elements that link 'peg' keeps, so collisions with them were not checked")) << bad;
    EXPECT_LT(result.report.scene->pairs, pairs) << "what is known of a part is not said of the whole";
  }
  options_.rules.clear();
  options_.links = "base";
  EXPECT_EQ(hullsOfBase(mesh), 2u) << "a link that is not chosen is there all the same";
  EXPECT_TRUE(isNoted(result, "links that 'base' does not match stay as they are, also in the fit"));
}

TEST_F(FitRobotToScene, WhatStaysForOtherReasonsTakesPartToo) {
  fixtures::write(folder_ / "meshes/peg.obj", fixtures::obj(surface(boxShape(Eigen::Vector3d::Constant(0.03)))));
  request_.scene.bodies[0].pose = at(9, 9, 9);
  request_.primitives = false;
  std::string visual = bracket();
  for (std::size_t i = 0; (i = visual.find("collision>", i)) != std::string::npos;) visual.replace(i, 9, "visual");
  options_.source = Source::kVisual;  // the peg has none, and keeps its mesh
  EXPECT_EQ(run(pegInNotch(visual, collision(fixtures::meshTag("../meshes/peg.obj")))).elements.at(0).hulls.size(), 2u);
}

TEST_F(FitRobotToScene, AKeptMeshIsNotItsHull) {
  fixtures::write(folder_ / "meshes/peg.obj", fixtures::obj(surface(boxShape(Eigen::Vector3d::Constant(0.03)))));
  request_.scene.bodies[0].pose = at(9, 9, 9);
  LinkRule rule;
  rule.pattern = "base";
  rule.settings.action = Action::kKeep;
  options_.rules = {rule};
  const RobotResult result = run(pegInNotch(bracket(), collision(fixtures::meshTag("../meshes/peg.obj"))));
  EXPECT_EQ(result.report.scene->clear, result.report.scene->clear_of) << "the peg turns in the notch, and is clear of the bracket";
  EXPECT_EQ(result.report.scene->original_hits + result.report.scene->model_hits, 0u);
}

TEST_F(FitRobotToScene, KeepsAHullThatFillsNoPrimitive) {
  request_.scene.bodies.clear();
  const RobotResult result = run(fixtures::link("base", bracket()));
  EXPECT_TRUE(result.elements[0].primitives.empty());
  EXPECT_EQ(result.elements[0].hulls.size(), 1u);
}

TEST_F(FitRobotToScene, WithoutTheBlockABoxAndGreyHulls) {
  options_.validate = true;
  request_.scene.bodies.clear();
  fixtures::write(folder_ / "meshes/bracket.obj",
                  fixtures::obj(test_shapes::lBracket(0.2, 0.15, 0.1)));  // its hull is a box with a corner cut off
  RobotResult result = run(fixtures::link("base", bracket()));
  const ElementResult& element = result.elements[0];
  const ElementReport& row = result.report.links[0];
  ASSERT_EQ(element.primitives.size(), 1u);
  EXPECT_NEAR(element.primitives[0].size.prod(), 0.2 * 0.2 * 0.1, 1e-5);
  ASSERT_EQ(element.hulls.size(), 1u);
  EXPECT_EQ(element.hulls[0].vertices.size(), 8u);
  EXPECT_EQ(row.hulls, 0u);
  EXPECT_TRUE(row.files.empty());
  EXPECT_EQ(element.unneeded.size(), 2u);
  EXPECT_EQ(result.report.validation.missed + result.report.validation.phantom, 0u);
  EXPECT_EQ(result.report.scene->links[0].primitive, "box");
  EXPECT_EQ(result.report.scene->links[0].reason.substr(0, 7), "1 box: ");

  writeOutput(result, folder_ / "out");
  EXPECT_EQ(fixtures::contents(folder_ / "out").count("meshes/base/0_0.stl"), 0u);
  const RobotDescription written = parseRobotDescription(result.urdf);
  ASSERT_EQ(written.links[0].collisions.size(), 1u);
  const GeometryElement& box = written.links[0].collisions[0];
  EXPECT_EQ(box.kind, GeometryElement::Kind::kBox);
  for (const Eigen::Vector3d& corner : element.original.vertices) {
    const Eigen::Vector3d local = box.origin.inverse() * corner;
    EXPECT_LE((local.cwiseAbs() - box.size / 2).maxCoeff(), 0) << corner.transpose();
  }
}

TEST_F(FitRobotToScene, ReportsContactWithTheScene) {
  request_.scene.bodies[0].pose = at(0.1, 0.01, 0.05);
  const RobotResult result = run(fixtures::link("base", bracket()));
  EXPECT_EQ(result.report.scene->scene_contact, "base against block");
  ASSERT_EQ(result.report.scene->left_out.size(), 1u);
  EXPECT_EQ(result.report.scene->left_out[0].reason, "Fixed");
  EXPECT_TRUE(isNoted(result, "the original meshes are in contact with the scene at rest: base against block"));
  EXPECT_TRUE(isNoted(result, "1 pair of a link and a body of the scene is left out (base against block)"));
  EXPECT_NE(toTable(result.report).find("; 1 pair with the scene left out\n"), std::string::npos);
  request_.scene.bodies.push_back({"shelf", request_.scene.bodies[0].shape, request_.scene.bodies[0].pose});
  EXPECT_TRUE(isNoted(run(fixtures::link("base", bracket())), "2 pairs of a link and a body of the scene are left out"));
}

TEST_F(FitRobotToScene, FailedMeshLeavesItsLinkOut) {
  const RobotResult result =
      run(fixtures::link("base", bracket()) + fixtures::link("hand", collision(fixtures::meshTag("../meshes/rubbish.stl")), "base"));
  ASSERT_EQ(result.report.links.size(), 2u);
  EXPECT_EQ(result.report.links[0].status, Status::kOk);
  EXPECT_EQ(result.report.links[1].status, Status::kFailed);
  EXPECT_EQ(result.report.scene->links.size(), 1u);
  EXPECT_NE(result.urdf.find("rubbish.stl"), std::string::npos);
}

TEST_F(FitRobotToScene, NamesEachMeshIfAllFail) {
  const RobotResult result = run(fixtures::link("base", collision(fixtures::meshTag("../meshes/rubbish.stl"))));
  ASSERT_EQ(result.report.links.size(), 1u);
  EXPECT_EQ(result.report.links[0].status, Status::kFailed);
  EXPECT_NE(result.report.links[0].reason.find("rubbish.stl"), std::string::npos);
  EXPECT_FALSE(result.report.scene);
}

TEST_F(FitRobotToScene, FitsALinkAsAWholeOrNotAtAll) {
  const std::string both = bracket() + collision(fixtures::meshTag("../meshes/rubbish.stl"));
  const RobotResult result = run(fixtures::link("base", both) + fixtures::link("tip", bracket(), "base"));
  ASSERT_EQ(result.report.links.size(), 3u);
  for (const int failed : {0, 1}) {
    EXPECT_EQ(result.report.links[failed].status, Status::kFailed);
    EXPECT_NE(result.report.links[failed].reason.find("rubbish.stl"), std::string::npos) << result.report.links[failed].reason;
    EXPECT_TRUE(result.elements[failed].hulls.empty());
    EXPECT_TRUE(result.report.links[failed].files.empty());
  }
  EXPECT_EQ(result.report.links[2].status, Status::kOk);
  EXPECT_NE(result.urdf.find("rubbish.stl"), std::string::npos);
}

TEST_F(FitRobotToScene, IgnoresPrimitivesWithoutASize) {
  const std::string dummy = "    <collision><geometry><box size=\"0 0 0\"/></geometry></collision>\n";
  const RobotResult result = run(fixtures::link("base", bracket()) + fixtures::link("tip", dummy, "base"));
  EXPECT_TRUE(result.report.scene->left_out.empty());
  const std::vector<std::string>& notes = result.report.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const auto& note) { return note.find("link 'tip'") != std::string::npos; }));
}

TEST_F(FitRobotToScene, PrimitivesOfTheRobotCount) {
  // A ball on a link of its own, in the notch: the fixed joint makes the two one body, so the pair is not checked.
  request_.scene.bodies.clear();
  const std::string ball = "    <collision><geometry><sphere radius=\"0.02\"/></geometry></collision>\n";
  const RobotResult result = run(fixtures::link("base", bracket()) + fixtures::link("ball", ball, "base"));
  ASSERT_EQ(result.report.scene->left_out.size(), 1u);
  EXPECT_EQ(result.report.scene->left_out[0].reason, "Adjacent");
  EXPECT_EQ(result.report.scene->left_out[0].second, "ball");
}

TEST_F(FitRobotToScene, PassesOnNotesAboutTheDescription) {
  const std::vector<std::string> notes = run(fixtures::link("base", bracket()) + "  <xacro:gripper/>\n").report.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const auto& note) { return note.find("<xacro:gripper>") != std::string::npos; }));
}

TEST_F(FitRobotToScene, SameBytesWithAndWithoutCache) {
  const std::string links = fixtures::link("base", bracket());
  const RobotResult first = run(links), second = run(links);
  options_.cache = false;
  options_.jobs = 1;
  const RobotResult third = run(links);
  for (const RobotResult* other : {&second, &third}) {
    EXPECT_EQ(first.urdf, other->urdf);
    ASSERT_EQ(first.elements[0].hulls.size(), other->elements[0].hulls.size());
    for (std::size_t i = 0; i < first.elements[0].hulls.size(); ++i)
      EXPECT_EQ(first.elements[0].hulls[i].vertices, other->elements[0].hulls[i].vertices);
  }
}

TEST_F(FitRobotToScene, ReadsARequestFromFiles) {
  Input input;
  input.robot = parseRobotDescription(
      "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='revolute'><parent link='a'/><child link='b'/>"
      "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>");
  input.find_package = defaultPackageFinder();
  const std::string scene = fixtures::write(folder_ / "scene.yaml", "name: none\nbodies: []\n");
  SceneSources sources;
  sources.scene = scene;
  sources.srdf = "<robot name='r'><disable_collisions link1='a' link2='b' reason='User'/></robot>";
  sources.configurations = fixtures::write(folder_ / "path.csv", "j\n0\n0.5\n");
  const SceneRequest read = readSceneRequest(input, sources);
  EXPECT_EQ(read.scene.name, "none");
  EXPECT_EQ(read.disabled.size(), 1u);
  EXPECT_EQ(read.configurations, (std::vector<Configuration>{{0}, {0.5}}));
  sources.max_step = 0.2;
  EXPECT_EQ(readSceneRequest(input, sources).configurations.size(), 4u);  // steps of 0.5 / 3
  for (const char* text : {"j\n2\n", "elbow\n0\n"}) {
    sources.configurations = fixtures::write(folder_ / "bad.csv", text);
    EXPECT_THROW(readSceneRequest(input, sources), Error) << text;
  }
  sources.configurations.clear();
  EXPECT_THROW(readSceneRequest(input, sources), Error);  // a step without configurations
  sources.max_step = 0;
  sources.srdf.clear();
  sources.srdf_file = "empty.srdf";
  EXPECT_THROW(readSceneRequest(input, sources), Error);
}

}  // namespace
}  // namespace collision_hulls
