// What a fit to a scene notes. Tests src/pipeline/scene/fit_notes.cpp.
#include "pipeline/scene/fit_notes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision_hulls/error.h"
#include "pipeline/fixtures.h"
#include "pipeline/scene_run.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using fixtures::FitRobotToScene;

TEST_F(FitRobotToScene, SaysThatLinksTouchInTheGivenConfigurations) {
  fixtures::write(folder_ / "meshes/box.obj", fixtures::obj(test_shapes::box(0.03, 0.03, 0.03)));
  const std::string robot = fixtures::link("base", bracket()) + fixtures::link("rail", "") +
                            fixtures::link("box", collision(fixtures::meshTag("../meshes/box.obj"))) +
                            "<joint name='a' type='prismatic'><parent link='base'/><child link='rail'/><axis xyz='0 0 1'/>"
                            "<limit lower='-0.1' upper='0.1' effort='1' velocity='1'/></joint>"
                            "<joint name='b' type='prismatic'><parent link='rail'/><child link='box'/><origin xyz='0.3 0 0'/>"
                            "<axis xyz='1 0 0'/><limit lower='-0.4' upper='0.1' effort='1' velocity='1'/></joint>";
  const std::string note = "1 pair of links is left out (base and box): the original meshes touch there in the given configurations";
  request_.configurations = {{0, -0.15}};
  EXPECT_TRUE(isNoted(run(robot), note));
  request_.configurations = {{0, -0.15}, {0, 0}};
  EXPECT_FALSE(isNoted(run(robot), note)) << "of two, one is free";
}

TEST_F(FitRobotToScene, SaysThatNoConfigurationKeepsTheClearance) {
  fixtures::write(folder_ / "meshes/box.obj", fixtures::obj(test_shapes::box(0.02, 0.02, 0.02)));
  const std::string robot = fixtures::link("base", "") + fixtures::link("box", collision(fixtures::meshTag("../meshes/box.obj"))) +
                            "<joint name='a' type='prismatic'><parent link='base'/><child link='box'/><axis xyz='1 0 0'/>"
                            "<limit lower='-0.4' upper='0.4' effort='1' velocity='1'/></joint>";
  request_.scene.bodies = {{"left", boxShape({0.1, 1, 1}), at(-0.6, 0, 0)}, {"right", boxShape({0.1, 1, 1}), at(0.6, 0, 0)}};
  request_.clearance = 0.6;  // at most 0.5 m from the farther of the two walls, and from the nearer one less
  const RobotResult none = run(robot);
  EXPECT_EQ(none.report.scene->clear, 0u);
  EXPECT_EQ(none.report.scene->clear_of, 100u);
  EXPECT_EQ(
      none.report.notes.front().find("the original meshes keep 600 mm from the scene and from one another in none of 100 configurations"),
      0u)
      << fixtures::joined(none.report.notes);
  request_.clearance = 0.01;
  const RobotResult all = run(robot);
  EXPECT_EQ(all.report.scene->clear, 100u);
  EXPECT_FALSE(isNoted(all, "the original meshes keep"));
}

TEST_F(FitRobotToScene, NamesTheFirstGivenConfigurationThatTouchesTheScene) {
  fixtures::write(folder_ / "meshes/box.obj", fixtures::obj(test_shapes::box(0.02, 0.02, 0.02)));
  const std::string robot = fixtures::link("base", "") + fixtures::link("box", collision(fixtures::meshTag("../meshes/box.obj"))) +
                            "<joint name='a' type='prismatic'><parent link='base'/><child link='box'/><axis xyz='1 0 0'/>"
                            "<limit lower='-0.4' upper='0.4' effort='1' velocity='1'/></joint>";
  request_.scene.bodies = {{"wall", boxShape({0.1, 1, 1}), at(0.4, 0, 0)}};
  request_.configurations = {{0}, {0.1}, {0.4}, {0.38}, {-0.1}};
  EXPECT_TRUE(isNoted(run(robot), "touch the scene in 2 of 5 given configurations, the first of them number 3, box against wall; check"));
}

TEST_F(FitRobotToScene, SaysThatLinksTouchAtRest) {
  fixtures::write(folder_ / "meshes/box.obj", fixtures::obj(test_shapes::box(0.02, 0.02, 0.02)));
  const std::string box = collision(fixtures::meshTag("../meshes/box.obj"));
  const std::string robot = fixtures::link("base", box) + fixtures::link("rail", "") + fixtures::link("box", box) +
                            "<joint name='a' type='fixed'><parent link='base'/><child link='rail'/></joint>"
                            "<joint name='b' type='prismatic'><parent link='rail'/><child link='box'/><axis xyz='1 0 0'/>"
                            "<limit lower='0' upper='0.4' effort='1' velocity='1'/></joint>";
  EXPECT_FALSE(isNoted(run(robot), "touch there at rest")) << "the rail stands for the base";
  const std::string mast = fixtures::link("mast", box) + "<joint name='c' type='fixed'><parent link='base'/><child link='mast'/></joint>";
  EXPECT_TRUE(isNoted(run(robot + mast), "1 pair of links is left out (box and mast): the original meshes touch there at rest"));
}

TEST_F(FitRobotToScene, NamesDisabledPairsOfLinksThatAreNotThere) {
  const std::string robot = fixtures::link("base", bracket());
  request_.disabled = {{"base", "zz", "", ""}, {"", "base", "", ""}};
  EXPECT_TRUE(
      isNoted(run(robot), "2 pairs of links that are not to be checked name links that the robot does not have (base and zz, for one)"));
  request_.disabled = {{"base", "base", "", ""}};
  EXPECT_FALSE(isNoted(run(robot), "not to be checked"));
}

TEST_F(FitRobotToScene, SaysThatABodyLiesInsideALink) {
  request_.scene.bodies[0] = {"peg", boxShape(Eigen::Vector3d::Constant(0.01)), at(0.1, 0.015, 0.05)};  // in the middle of a leg
  const RobotResult result = run(fixtures::link("base", bracket()));
  EXPECT_EQ(result.report.scene->scene_contact, "peg inside base");
  ASSERT_EQ(result.report.scene->left_out.size(), 1u);
  EXPECT_EQ(result.report.scene->left_out[0].known, "always peg inside base");
  EXPECT_TRUE(isNoted(result, "in contact with the scene at rest: peg inside base"));
  EXPECT_TRUE(isNoted(result, "peg inside base: a check that takes meshes for surfaces, as FCL does, sees no contact there"));
}

TEST_F(FitRobotToScene, SaysWhatMaxHullsKeeps) {
  request_.primitives = false;
  for (const int most : {0, 1, 2}) {
    options_.max_hulls = most;
    const RobotResult result = run(fixtures::link("base", bracket()));
    EXPECT_EQ(result.report.scene->phantom, most == 1 ? 100u : 0u);
    EXPECT_EQ(result.report.scene->leaf_contacts, 0u);
    EXPECT_EQ(isNoted(result, "100 of 100 configurations still have a false collision, since max-hulls keeps link 'base'"), most == 1);
    EXPECT_FALSE(isNoted(result, "of the scene is left out"));
  }
}

TEST_F(FitRobotToScene, SaysThatTheSceneIsFarAway) {
  const std::string note = "no body of scene '";
  request_.scene.bodies = {{"shelf", boxShape({280, 960, 16}), at(580, 0, 40)}, {"floor", boxShape({1, 1, 1}), at(-600, 0, 0)}};
  const RobotResult far = run(fixtures::link("base", bracket()));
  EXPECT_TRUE(isNoted(far, note)) << fixtures::joined(far.report.notes);
  EXPECT_TRUE(isNoted(far, "the nearest, 'shelf', is 441 m from its root link")) << fixtures::joined(far.report.notes);
  request_.scene.bodies.push_back({"table", boxShape({1, 1, 1}), at(3, 0, 0)});
  EXPECT_FALSE(isNoted(run(fixtures::link("base", bracket())), note));
  request_.scene.bodies = {{"room", test_shapes::box(4000, 3000, 2500), at(-2000, -1500, -500)}};
  EXPECT_TRUE(isNoted(run(fixtures::link("base", bracket())), "the nearest, 'room', is 500 m from its root link"));
  request_.scene.bodies = {{"room", test_shapes::box(4, 3, 2.5), at(-2, -1.5, -0.5)}};
  EXPECT_FALSE(isNoted(run(fixtures::link("base", bracket())), note));
}

TEST_F(FitRobotToScene, SaysThatTheRobotStandsInTheScene) {
  std::string turning = fixtures::link("tip", bracket(), "base");  // about x, with a leg of 0.2 m along y
  turning.replace(turning.find("fixed"), 5, "continuous");
  const auto isSaid = [&](double wall_from_y) {
    request_.scene.bodies[0] = {"wall", boxShape({2, 2, 0.8}), at(0, 1 + wall_from_y, 0.6)};
    const RobotResult result = run(fixtures::link("base", bracket()) + turning);
    return isNoted(result, "of 100 sampled configurations");
  };
  EXPECT_TRUE(isSaid(0.04));   // touched over 234 degrees
  EXPECT_FALSE(isSaid(0.18));  // over 76 degrees
  request_.scene.bodies = {{"post", boxShape({2, 0.02, 0.8}), at(0, 0.19, 0.6)}, {"wall", boxShape({2, 2, 0.8}), at(0, 1.04, 0.6)}};
  const RobotResult result = run(fixtures::link("base", bracket()) + turning);
  EXPECT_TRUE(isNoted(result, " sampled configurations, most often tip against wall, in ")) << fixtures::joined(result.report.notes);
}

// A block that slides out of the bracket's notch, in which it is 3 cm clear of the bracket.
TEST_F(FitRobotToScene, TellsOfLinksThatMeetWithinTheClearance) {
  fixtures::write(folder_ / "meshes/block.obj", fixtures::obj(test_shapes::box(0.03, 0.03, 0.03)));
  const std::string links =
      fixtures::link("base", bracket()) + "  <link name=\"mid\"/>\n  <link name=\"tip\">" +
      collision(fixtures::meshTag("../meshes/block.obj")) + "</link>\n" +
      "<joint name=\"a\" type=\"prismatic\"><parent link=\"base\"/><child link=\"mid\"/><limit upper=\"0.001\" effort=\"1\" "
      "velocity=\"1\"/></joint>"
      "<joint name=\"b\" type=\"prismatic\"><parent link=\"mid\"/><child link=\"tip\"/>"
      "<origin xyz=\"0.06 0.06 0.02\"/><axis xyz=\"0 0 1\"/><limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>\n";
  request_.scene.bodies[0].pose = at(5, 5, 5);
  request_.samples = 1000;
  const std::string told = "hulls of links 'base' and 'tip' collide in ";
  request_.clearance = 0.06;
  const RobotResult result = run(links);
  EXPECT_TRUE(isNoted(result, told));
  EXPECT_TRUE(isNoted(result, "which a fit allows wherever any meshes, theirs or others, are nearer than the clearance; if the robot has"));
  request_.clearance = 0.01;
  EXPECT_FALSE(isNoted(run(links), told));
}

TEST(NoteOnSpeed, SaysWhyTheFittedModelIsSlower) {
  FitReport fit;
  fit.query_us = 7.4;
  fit.distance_us = 37.2;
  fit.original_query_us = 5;
  fit.original_distance_us = 641;
  Scene scene{"kitchen", {{"table", boxShape({1, 1, 1})}, {"cup", test_shapes::box(1, 1, 1)}, {"ball", test_shapes::sphere()}}};
  EXPECT_EQ(noteOnSpeed(fit, scene), "");
  fit.query_us = 7.96;
  EXPECT_EQ(
      noteOnSpeed(fit, scene),
      "the fitted model is slower than the meshes: it takes 7.96 us for a collision query, 5.00 us with the meshes. Body 'ball' of the "
      "scene is a mesh, and hulls take long against a mesh: give it as boxes, cylinders or spheres, which 'decompose --shapes "
      "primitives' makes");
  scene.bodies.resize(1);
  fit.distance_us = 1000;
  EXPECT_EQ(noteOnSpeed(fit, scene),
            "the fitted model is slower than the meshes: it takes 7.96 us for a collision query, 5.00 us with the meshes; 1000 us for a "
            "distance query, 641 us with the meshes. Hulls gain little where meshes have few triangles: keep the meshes, or give a larger "
            "clearance, which takes fewer hulls");
  fit.query_us = 0.9;
  fit.original_query_us = 0.2;
  fit.distance_us = fit.original_distance_us = 641;
  EXPECT_EQ(noteOnSpeed(fit, scene), "") << "too little to measure";
  fit.query_us = 7.96;
  fit.original_query_us = 0;
  EXPECT_EQ(noteOnSpeed(fit, scene), "") << "nothing was measured";
}

}  // namespace
}  // namespace collision_hulls
