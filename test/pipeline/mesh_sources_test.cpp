// Which elements of which links are decomposed, and what is said of those that are not.
// Also tests src/pipeline/mesh_uses.cpp.
#include <gtest/gtest.h>

#include <algorithm>

#include "collision_hulls/error.h"
#include "pipeline/robot_run.h"

namespace collision_hulls {
namespace {

using fixtures::count;
using fixtures::link;
using fixtures::meshTag;

class MeshSources : public fixtures::RobotRun {};

TEST_F(MeshSources, NoMeshAtAll) {
  const std::string sphere = "    <collision><geometry><sphere radius=\"0.1\"/></geometry></collision>\n";
  const RobotResult result = run(link("base", "") + link("ball", sphere, "base"));
  EXPECT_TRUE(result.report.links.empty());
  EXPECT_EQ(result.urdf, fixtures::read(folder_ / "urdf/arm.urdf"));
}

TEST_F(MeshSources, VisualWithOnlyAMaterialIsIgnored) {
  const std::string paint = "    <visual><material name=\"red\"><color rgba=\"1 0 0 1\"/></material></visual>\n";
  const RobotResult result = run(link("base", visual("box.obj") + paint) + link("tip", paint, "base"));
  ASSERT_EQ(result.report.links.size(), 1u);
  EXPECT_EQ(count(result.urdf, "<collision"), 1u);
  EXPECT_EQ(count(result.urdf, paint.substr(4, paint.size() - 5)), 2u);
}

TEST_F(MeshSources, PrimitivesThatStayBesideMeshesAreTold) {
  const std::string ball = "    <collision><geometry><sphere radius=\"0.1\"/></geometry></collision>\n";
  const std::string arm = link("base", collision("bracket.obj"));
  const std::string told =
      "1 link keeps the primitives of its <collision> elements, as they are: tip; "
      "'source: visual' in a configuration decomposes its visual meshes";
  LinkRule rule;
  rule.pattern = "tip";
  rule.settings.tolerance = parseLength("2mm");
  options_.rules = {rule};
  const RobotResult seen = run(arm + link("tip", visual("box.obj") + ball, "base")), unseen = run(arm + link("tip", ball, "base"));
  EXPECT_EQ(count(fixtures::joined(seen.report.notes), told), 1u) << fixtures::joined(seen.report.notes);
  EXPECT_EQ(count(fixtures::joined(seen.report.notes), "has a mesh to decompose; 'source: visual' uses their visual meshes"), 1u);
  EXPECT_EQ(count(fixtures::joined(unseen.report.notes), "'source: visual'"), 0u) << fixtures::joined(unseen.report.notes);
}

TEST_F(MeshSources, CollisionMeshesThatAreAllConvexAreToldIfThereIsMoreToSee) {
  const auto told = [&](const std::string& elements) {
    return count(fixtures::joined(run(link("base", elements)).report.notes), "each collision mesh became a single hull");
  };
  EXPECT_EQ(told(collision("box.obj") + visual("bracket.obj")), 1u);
  EXPECT_EQ(told(collision("box.obj") + visual("box.obj")), 0u) << "the same mesh";
  EXPECT_EQ(told(collision("box.obj")), 0u) << "nothing else to see";
  EXPECT_EQ(told(collision("box.obj") + collision("channel.obj") + visual("bracket.obj")), 0u) << "one has several hulls";
  EXPECT_EQ(told(visual("box.obj") + visual("bracket.obj")), 0u);
  options_.tolerance = parseLength("90%");
  EXPECT_EQ(told(collision("channel.obj") + visual("bracket.obj")), 0u) << "far from convex";
}

TEST_F(MeshSources, AToleranceThatNoModelHasIsTold) {
  const auto told = [&] { return fixtures::joined(run(link("base", collision("box.obj"))).report.notes); };
  options_.tolerance = Options().tolerance;
  options_.models = {{"coarse", lengthOf(0.1)}, {"fine", lengthOf(0.02)}};
  EXPECT_EQ(count(told(), "is not used"), 0u) << told();
  options_.tolerance = parseLength("2mm");
  EXPECT_EQ(count(told(), "the tolerance '2mm' is not used: each model has its own; leave it out"), 1u) << told();
}

TEST_F(MeshSources, LinksThatGainHullsBesideOthersThatCollideAreTold) {
  const auto told = [&](const std::string& links) { return fixtures::joined(run(links).report.notes); };
  const std::string base = link("base", collision("bracket.obj")), tip = link("tip", visual("box.obj"), "base");
  const std::string one =
      "1 link has no <collision> elements, and gets hulls of its visual meshes: tip; --source collision leaves it without collision "
      "geometry";
  EXPECT_EQ(count(told(base + tip), one), 1u) << told(base + tip);
  EXPECT_EQ(count(told(link("base", visual("bracket.obj")) + tip), "no <collision>"), 0u) << "none collides: it is what the run is for";
  options_.source = Source::kVisual;
  EXPECT_EQ(count(told(base + tip), "no <collision>"), 0u) << "it was asked for";
}

// Some descriptions mark places with them; a collision element without a size is one that simulators refuse.
TEST_F(MeshSources, VisualPrimitivesWithoutASizeBecomeNoCollisions) {
  options_.source = Source::kVisual;
  const auto shape = [](const std::string& element, const std::string& tag) {
    return "    <" + tag + "><geometry>" + element + "</geometry></" + tag + ">\n";
  };
  std::string flat;
  for (const char* element : {"<box size=\"1 0 1\"/>", "<sphere radius=\"0\"/>", "<cylinder radius=\"0.1\" length=\"0\"/>",
                              "<cylinder radius=\"0\" length=\"1\"/>"})
    flat += shape(element, "visual");
  const RobotResult result = run(link("base", visual("box.obj") + flat + shape("<sphere radius=\"0.5\"/>", "visual")) +
                                 link("tip", flat + shape("<sphere radius=\"0.1\"/>", "collision"), "base"));
  ASSERT_EQ(result.report.links.size(), 1u);
  EXPECT_EQ(count(result.urdf, "<collision"), 3u) << "the box's hull, the sphere, and what the tip had";
  EXPECT_EQ(count(result.urdf, "<sphere radius=\"0\"/>"), 2u) << "as visual elements alone";
  EXPECT_NE(std::find(result.report.notes.begin(), result.report.notes.end(),
                      "visual boxes, spheres and cylinders with a size of 0 become no collision elements, in links: base, tip"),
            result.report.notes.end());
}

TEST_F(MeshSources, NotesCollisionMeshesIgnoredBySourceVisual) {
  options_.source = Source::kVisual;
  const RobotResult result = run(link("base", visual("box.obj")) + link("tip", collision("bracket.obj"), "base"));
  ASSERT_EQ(result.report.links.size(), 1u);
  const auto on_tip = [](const std::string& note) {
    return note.find("keep their collision meshes as they are: tip;") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(result.report.notes.begin(), result.report.notes.end(), on_tip), 1);
  EXPECT_EQ(count(result.urdf, "bracket.obj"), 1u);
}

TEST_F(MeshSources, VisualPrimitivesBecomeCollisionsIfThereAreNone) {
  const std::string cylinder = "    <visual><geometry><cylinder radius=\"0.1\" length=\"1\"/></geometry></visual>\n";
  const RobotResult result = run(link("base", cylinder + visual("box.obj")));
  const RobotDescription again = parseRobotDescription(result.urdf);
  ASSERT_EQ(again.links[0].collisions.size(), 2u);
  EXPECT_EQ(again.links[0].collisions[0].kind, GeometryElement::Kind::kCylinder);
  EXPECT_EQ(again.links[0].collisions[1].kind, GeometryElement::Kind::kMesh);
}

TEST_F(MeshSources, NamesTheSourceWithMeshesIfTheChosenOneHasNone) {
  const std::string sphere = "    <collision><geometry><sphere radius=\"1\"/></geometry></collision>\n";
  const std::string robot = link("base", visual("file:///box.obj") + sphere) + link("tip", sphere, "base");
  const auto notes = [&] { return run(robot).report.notes; };
  ASSERT_EQ(notes().size(), 1u);
  const std::string stay = "; boxes, spheres and cylinders stay as they are", equal = ", and the output's collision model is the input's";
  EXPECT_EQ(notes()[0], "there is no mesh to decompose" + stay + equal +
                            "; the <visual> elements have 1 mesh, which --source visual decomposes; "
                            "'rosrun collision_hulls verify INPUT INPUT' tells how far they are from the primitives");
  options_.links = "tip";
  ASSERT_EQ(notes().size(), 1u);
  EXPECT_EQ(notes()[0], "the chosen links have no meshes" + stay + equal);
  options_.links = "";
  EXPECT_EQ(run(link("tip", sphere)).report.notes[0], "the robot has no meshes" + stay + equal);
  const std::string seen = "    <visual><geometry><sphere radius=\"1\"/></geometry></visual>\n";
  EXPECT_EQ(run(link("tip", seen)).report.notes[0],
            "the robot has no meshes" + stay + ", and those of the <visual> elements become <collision> elements of 1 link without any");
}

TEST_F(MeshSources, AVisualWithoutGeometryBecomesNothing) {
  const std::string empty = "    <visual><origin xyz=\"0 0 0\"/></visual>\n",
                    box = "    <collision><geometry><box size=\"1 1 1\"/></geometry></collision>\n";
  const auto last_note = [&](const std::string& links) { return run(links).report.notes.back(); };  // the first tells of the <visual>
  EXPECT_EQ(last_note(link("a", empty) + link("b", box, "a")),
            "the robot has no meshes; boxes, spheres and cylinders stay as they are, and the output's collision model is the input's");
  EXPECT_EQ(last_note(link("a", empty)), "the robot has no geometry: nothing of it can collide");
}

// Whether the other link has shown by then that a folder stands in for the package or not.
TEST_F(MeshSources, AMeshThatTheFolderInAPackagesPlaceLacksIsNamedAsMissing) {
  const auto of = [](const std::string& mesh) {
    return "    <collision>" + meshTag("package://exported_name/meshes/" + mesh) + "</collision>\n";
  };
  for (const auto& [first, second] : {std::pair("box.obj", "gone.obj"), std::pair("gone.obj", "box.obj")}) {
    const RobotResult result = run(link("a", of(first)) + link("b", of(second), "a"));
    const ElementReport& lost = result.report.links.at(first == std::string("gone.obj") ? 0 : 1);
    EXPECT_EQ(lost.error, "FileNotFound");
    EXPECT_NE(lost.reason.find("'package://exported_name/meshes/gone.obj' does not exist in '" + folder_.path().string() +
                               "', which is used in place of package 'exported_name'"),
              std::string::npos)
        << lost.reason;
  }
}

TEST_F(MeshSources, SelectsLinks) {
  const std::string links = link("left_arm", collision("box.obj")) + link("right_arm", collision("box.obj"), "left_arm");
  options_.links = "right.*";
  const RobotResult result = run(links);
  ASSERT_EQ(result.report.links.size(), 1u);
  EXPECT_EQ(result.report.links[0].link, "right_arm");
  EXPECT_NE(result.urdf.find(link("left_arm", collision("box.obj"))), std::string::npos);
  options_.links = "arm";  // must match the whole name
  try {
    run(links);
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kBadOption);
    EXPECT_EQ(std::string(e.what()).find("links 'arm' matches no link of robot"), 0u) << e.what();
    EXPECT_NE(std::string(e.what()).find("Its links are left_arm, right_arm"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace collision_hulls
