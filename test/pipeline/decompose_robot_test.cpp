// Also tests src/pipeline/mesh_result.cpp, src/pipeline/mesh_uses.cpp and src/pipeline/stages.cpp.
#include "collision_hulls/pipeline/decompose_robot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/output.h"
#include "pipeline/robot_run.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using fixtures::count;
using fixtures::link;
using fixtures::meshTag;

/// The text without its <collision> elements.
std::string withoutCollisions(const std::string& urdf) {
  return std::regex_replace(urdf, std::regex("\\s*<collision[^]*?</collision>"), "");
}

class DecomposeRobot : public fixtures::RobotRun {};

TEST_F(DecomposeRobot, NoMeshAtAll) {
  const std::string sphere = "    <collision><geometry><sphere radius=\"0.1\"/></geometry></collision>\n";
  const RobotResult result = run(link("base", "") + link("ball", sphere, "base"));
  EXPECT_TRUE(result.report.links.empty());
  EXPECT_EQ(result.urdf, fixtures::read(folder_ / "urdf/arm.urdf"));
}

TEST_F(DecomposeRobot, MoreHullsThanADescriptionMayHoldEndTheRun) {
  std::string visuals;
  for (int i = 0; i < 17'000; ++i) visuals += visual("channel.obj");  // of three hulls
  options_.validate = false;
  try {
    run(link("base", visuals));
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kTooLarge);
    for (const char* part : {"more than 33333 hulls", "link 'base'", "larger tolerance"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST_F(DecomposeRobot, UnreadableElementHasItsOwnRow) {
  const std::string bad = "    <visual>\n      " + meshTag("../meshes/box.obj", " scale=\"0.001\"") + "\n    </visual>\n";
  const RobotResult result = run(link("base", visual("bracket.obj")) + link("tip", bad, "base"));
  ASSERT_EQ(result.report.links.size(), 2u);
  EXPECT_EQ(result.report.links[0].status, Status::kOk);
  EXPECT_EQ(result.report.links[1].status, Status::kFailed);
  EXPECT_EQ(result.report.links[1].error, "BadGeometry");
  for (const char* part : {"arm.urdf', line ", "<visual> of link 'tip'", "0.001"})
    EXPECT_NE(result.report.links[1].reason.find(part), std::string::npos) << result.report.links[1].reason;
}

TEST_F(DecomposeRobot, VisualWithOnlyAMaterialIsIgnored) {
  const std::string paint = "    <visual><material name=\"red\"><color rgba=\"1 0 0 1\"/></material></visual>\n";
  const RobotResult result = run(link("base", visual("box.obj") + paint) + link("tip", paint, "base"));
  ASSERT_EQ(result.report.links.size(), 1u);
  EXPECT_EQ(count(result.urdf, "<collision"), 1u);
  EXPECT_EQ(count(result.urdf, paint.substr(4, paint.size() - 5)), 2u);
}

// Some descriptions mark places with them; a collision element without a size is one that simulators refuse.
TEST_F(DecomposeRobot, VisualPrimitivesWithoutASizeBecomeNoCollisions) {
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

TEST_F(DecomposeRobot, NotesCollisionMeshesIgnoredBySourceVisual) {
  options_.source = Source::kVisual;
  const RobotResult result = run(link("base", visual("box.obj")) + link("tip", collision("bracket.obj"), "base"));
  ASSERT_EQ(result.report.links.size(), 1u);
  const auto on_tip = [](const std::string& note) {
    return note.find("keep their collision meshes as they are: tip;") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(result.report.notes.begin(), result.report.notes.end(), on_tip), 1);
  EXPECT_EQ(count(result.urdf, "bracket.obj"), 1u);
}

TEST_F(DecomposeRobot, ARowForEveryMeshInDocumentOrder) {
  const std::string sphere = "    <collision><geometry><sphere radius=\"0.1\"/></geometry></collision>\n";
  const RobotResult result = run(link("base", visual("box.obj") + sphere + collision("bracket.obj")) + link("frame", "", "base") +
                                 link("tip", visual("channel.obj") + visual("box.obj", "1 -2 1"), "base"));
  ASSERT_EQ(result.report.links.size(), 3u);
  const ElementReport& bracket = result.report.links[0];
  EXPECT_EQ(bracket.link, "base");
  EXPECT_EQ(bracket.element, 1) << "primitives count";
  EXPECT_FALSE(bracket.visual);
  const ElementReport& mirrored = result.report.links[2];
  EXPECT_EQ(mirrored.link, "tip");
  EXPECT_EQ(mirrored.element, 1);
  EXPECT_TRUE(mirrored.visual);
  EXPECT_NEAR(mirrored.volume, 2 * 0.1 * 0.2 * 0.3, 1e-9);
  EXPECT_EQ(mirrored.hulls, 1u);
  for (const ElementReport& row : result.report.links) {
    EXPECT_NE(row.status, Status::kFailed) << row.reason;
    EXPECT_EQ(row.uncovered, 0);
    EXPECT_LE(row.protrusion_found, row.protrusion);
    EXPECT_NEAR(row.tolerance, std::min(0.01, 0.05 * row.diagonal), 1e-15);
    EXPECT_EQ(row.files.size(), row.hulls);
    EXPECT_EQ(row.sha256.size(), 64u);
  }
  EXPECT_GT(result.report.validation.queries, 0u);
  EXPECT_EQ(result.report.validation.missed, 0u);
  EXPECT_EQ(result.report.validation.phantom, 0u);
}

TEST_F(DecomposeRobot, RewritesOnlyCollisions) {
  const std::string sphere = "    <collision name=\"knob\"><geometry><sphere radius=\"0.1\"/></geometry></collision>\n";
  const RobotResult result = run(link("base", visual("box.obj") + sphere + collision("bracket.obj", " name=\"body\"")));
  const std::string before = fixtures::read(folder_ / "urdf/arm.urdf");
  EXPECT_EQ(withoutCollisions(result.urdf), withoutCollisions(before));
  EXPECT_EQ(count(result.urdf, "<collision"), 1 + result.report.links[0].hulls);
  EXPECT_NE(result.urdf.find(sphere), std::string::npos);
  EXPECT_NE(result.urdf.find("name=\"body_0\""), std::string::npos);
  EXPECT_NE(result.urdf.find("package://out/meshes/base/1_0.stl"), std::string::npos);
  const RobotDescription again = parseRobotDescription(result.urdf);
  EXPECT_EQ(again.links[0].collisions[1].origin.translation(), Eigen::Vector3d(0, 0, 0.1));
}

TEST_F(DecomposeRobot, VisualPrimitivesBecomeCollisionsIfThereAreNone) {
  const std::string cylinder = "    <visual><geometry><cylinder radius=\"0.1\" length=\"1\"/></geometry></visual>\n";
  const RobotResult result = run(link("base", cylinder + visual("box.obj")));
  const RobotDescription again = parseRobotDescription(result.urdf);
  ASSERT_EQ(again.links[0].collisions.size(), 2u);
  EXPECT_EQ(again.links[0].collisions[0].kind, GeometryElement::Kind::kCylinder);
  EXPECT_EQ(again.links[0].collisions[1].kind, GeometryElement::Kind::kMesh);
}

TEST_F(DecomposeRobot, NamesTheSourceWithMeshesIfTheChosenOneHasNone) {
  const std::string sphere = "    <collision><geometry><sphere radius=\"1\"/></geometry></collision>\n";
  const std::string robot = link("base", visual("file:///box.obj") + sphere) + link("tip", sphere, "base");
  const auto notes = [&] { return run(robot).report.notes; };
  ASSERT_EQ(notes().size(), 1u);
  const std::string stay = "; boxes, spheres and cylinders stay as they are", equal = ", and the output's collision model is the input's";
  EXPECT_EQ(notes()[0],
            "there is no mesh to decompose" + stay + equal +
                "; the <visual> elements have 1 mesh, which --source visual decomposes; 'verify INPUT INPUT' tells how far they "
                "are from the primitives");
  options_.links = "tip";
  ASSERT_EQ(notes().size(), 1u);
  EXPECT_EQ(notes()[0], "the chosen links have no meshes" + stay + equal);
  options_.links = "";
  EXPECT_EQ(run(link("tip", sphere)).report.notes[0], "the robot has no meshes" + stay + equal);
  const std::string seen = "    <visual><geometry><sphere radius=\"1\"/></geometry></visual>\n";
  EXPECT_EQ(run(link("tip", seen)).report.notes[0],
            "the robot has no meshes" + stay + ", and those of the <visual> elements become <collision> elements of 1 link without any");
}

TEST_F(DecomposeRobot, PassesOnNotesAboutTheDescription) {
  const RobotResult result = run(link("base", collision("box.obj")) + "  <xacro:gripper/>\n");
  ASSERT_EQ(result.report.notes.size(), 1u);
  EXPECT_NE(result.report.notes[0].find("<xacro:gripper>"), std::string::npos) << result.report.notes[0];
}

TEST_F(DecomposeRobot, OneBadLinkLosesNoOther) {
  options_.uri = UriStyle::kRelative;
  const std::string bad = link("bad", collision("box.obj") + collision("rubbish.stl"), "base");
  const RobotResult result = run(link("base", collision("box.obj")) + bad + link("gone", collision("gone.stl"), "base") +
                                 link("lost", "    <collision>" + meshTag("package://no_such_package/a.stl") + "</collision>\n", "base") +
                                 link("last", collision("bracket.obj"), "base"));
  const auto& rows = result.report.links;
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_TRUE(anyFailed(result.report));
  EXPECT_EQ(rows[0].status, Status::kOk) << rows[0].reason;
  EXPECT_EQ(rows[1].status, Status::kOk) << rows[1].reason;
  EXPECT_EQ(rows[2].error, "NotAMesh");
  EXPECT_EQ(rows[3].error, "FileNotFound");
  EXPECT_EQ(rows[4].error, "PackageNotFound");
  for (int i : {2, 3, 4}) EXPECT_EQ(rows[static_cast<std::size_t>(i)].status, Status::kFailed);
  EXPECT_NE(rows[2].reason.find("rubbish.stl"), std::string::npos) << rows[2].reason;
  EXPECT_NE(rows[4].reason.find("no_such_package"), std::string::npos) << rows[4].reason;
  EXPECT_NE(rows[5].status, Status::kFailed) << rows[5].reason;
  EXPECT_NE(result.urdf.find(bad), std::string::npos) << "a link with a failed mesh must stay as it was";
  EXPECT_NE(result.urdf.find("meshes/last/0_0.stl"), std::string::npos);
  EXPECT_EQ(result.report.validation.missed, 0u);
}

// A run in which everything fails is usually at fault itself, so nothing is written. Not so if as many links need no mesh.
TEST_F(DecomposeRobot, OneBadMeshLosesNoLinkOfPrimitives) {
  const std::string box = "    <collision><geometry><box size=\"1 1 1\"/></geometry></collision>\n";
  const std::string links = link("base", box) + link("bad", collision("gone.stl"), "base");
  RobotResult result = run(links);
  EXPECT_EQ(result.report.primitive_links, 1u);
  EXPECT_EQ(result.report.links.at(0).status, Status::kFailed);
  EXPECT_NE(result.report.links[0].reason.find("gone.stl"), std::string::npos);
  EXPECT_TRUE(anyFailed(result.report) && !allFailed(result.report));
  ASSERT_FALSE(result.report.notes.empty());
  EXPECT_EQ(result.report.notes[0],
            "no mesh could be decomposed: 1 link with primitives has its collision model, and the others keep their elements");
  EXPECT_TRUE(writeOutput(result, folder_ / "out"));
  EXPECT_EQ(fixtures::read(folder_ / "out/urdf/arm.urdf"), fixtures::robot("arm", links));
  result = run(links + link("worse", collision("rubbish.stl"), "base"));
  EXPECT_TRUE(allFailed(result.report));
  EXPECT_FALSE(writeOutput(result, folder_ / "none"));
  options_.links = "bad";
  EXPECT_TRUE(allFailed(run(links).report)) << "nobody asked for the box";
}

TEST_F(DecomposeRobot, SelectsLinks) {
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

TEST_F(DecomposeRobot, DecomposesEqualMeshesOnce) {
  fixtures::write(folder_ / "meshes/copy.obj", fixtures::read(folder_ / "meshes/bracket.obj"));
  const RobotResult result =
      run(link("a", visual("bracket.obj")) + link("b", visual("copy.obj"), "a") + link("c", visual("bracket.obj", "2 2 2"), "a"));
  const auto& rows = result.report.links;
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].sha256, rows[1].sha256);
  EXPECT_EQ(rows[1].link, "b");
  EXPECT_EQ(rows[1].hulls, rows[0].hulls);
  EXPECT_EQ(rows[1].seconds.decompose, 0);
  EXPECT_EQ(rows[1].files.front(), "meshes/b/0_0.stl");
  EXPECT_EQ(result.elements[1].hulls.front().vertices, result.elements[0].hulls.front().vertices);
  EXPECT_GT(rows[2].seconds.decompose, 0) << "another scale is another mesh";
  EXPECT_NEAR(rows[2].diagonal, 2 * rows[0].diagonal, 1e-12);
}

TEST_F(DecomposeRobot, ShellsAreClosedAsAskedLinkByLink) {
  fixtures::write(folder_ / "meshes/pipe.obj", fixtures::obj(test_shapes::pipe(0.05, 0.3, 32)));
  options_.close_openings = 0.11;
  LinkRule rule;
  rule.pattern = "open";
  rule.settings.close_openings = 0.09;
  options_.rules.push_back(rule);
  const RobotResult result = run(link("closed", collision("pipe.obj")) + link("open", collision("pipe.obj"), "closed"));
  const ElementReport &closed = result.report.links.at(0), &open = result.report.links.at(1);
  EXPECT_EQ(std::make_tuple(closed.closed_openings, closed.openings, closed.widest_opening), std::make_tuple(2u, 0u, 0.0));
  EXPECT_EQ(closed.interior, "closed");
  EXPECT_EQ(closed.hulls, 1u);
  EXPECT_NEAR(closed.volume, 16 * 0.0025 * std::sin(test_shapes::kPi / 16) * 0.3, 1e-8);
  EXPECT_LT(closed.protrusion, 1e-6) << "the lids are flat";
  EXPECT_EQ(std::make_tuple(open.closed_openings, open.openings), std::make_tuple(0u, 2u));
  EXPECT_NEAR(open.widest_opening, 0.1, 1e-6);
  EXPECT_EQ(open.interior, "surface");
  EXPECT_GT(open.hulls, 2u);
  EXPECT_EQ(closed.triangles, open.triangles) << "of the file";
  EXPECT_EQ(result.report.validation.missed + result.report.validation.phantom, 0u);
  EXPECT_EQ(closed.close_openings, 0.11);
}

TEST_F(DecomposeRobot, LinkNamesThatAreNoFileNames) {
  const RobotResult result =
      run(link("a/b", collision("box.obj")) + link("a b", collision("box.obj"), "a/b") + link("..", collision("box.obj"), "a/b"));
  EXPECT_EQ(result.report.links[0].files.front(), "meshes/a_b/0_0.stl");
  EXPECT_EQ(result.report.links[1].files.front(), "meshes/a_b_2/0_0.stl");
  EXPECT_EQ(result.report.links[2].files.front(), "meshes/_../0_0.stl");
}

// The paper's method fills the channel, since its concavity along rays sees nothing there. The certificate does, and the row says so.
TEST_F(DecomposeRobot, DegradedWithNumbersIfTheToleranceIsNotKept) {
  options_.method = Method::kHacd;
  options_.tolerance = shareOf(0.03);
  const RobotResult result = run(link("base", collision("channel.obj")));
  const ElementReport& row = result.report.links[0];
  ASSERT_EQ(row.status, Status::kDegraded);
  EXPECT_GT(row.protrusion_found, row.tolerance);
  EXPECT_NE(row.reason.find("mm"), std::string::npos) << row.reason;
  EXPECT_NE(row.reason.find("concavity"), std::string::npos) << row.reason;
  EXPECT_FALSE(anyFailed(result.report));
}

TEST_F(DecomposeRobot, OtherMethodsGiveTheirReasons) {
  options_.method = Method::kSingleHull;
  const RobotResult single = run(link("base", collision("channel.obj")));
  EXPECT_EQ(single.report.links[0].hulls, 1u);
  EXPECT_EQ(single.report.links[0].status, Status::kDegraded);
  EXPECT_NE(single.report.links[0].reason.find("single_hull"), std::string::npos);
  options_.method = Method::kBoundingBox;
  const RobotResult box = run(link("base", collision("box.obj")));
  EXPECT_EQ(box.report.links[0].hull_vertices, 8u);
  EXPECT_EQ(box.report.links[0].status, Status::kOk) << box.report.links[0].reason;
}

std::size_t notesWith(const Report& report, const std::string& part) {
  return static_cast<std::size_t>(std::count_if(report.notes.begin(), report.notes.end(),
                                                [&](const std::string& note) { return note.find(part) != std::string::npos; }));
}

// 200 m long: a box in millimetres that is read as metres.
TEST_F(DecomposeRobot, AMeshInMillimetresFailsBeforeTheWorkAndLeavesTheOthers) {
  const std::string huge = "    <visual>\n      " + meshTag("../meshes/bracket.obj", " scale=\"1000 1000 1000\"") + "\n    </visual>\n";
  const RobotResult result = run(link("base", visual("box.obj")) + link("tip", huge, "base"));
  EXPECT_EQ(result.report.links[0].status, Status::kOk);
  const ElementReport& row = result.report.links[1];
  EXPECT_EQ(row.status, Status::kFailed);
  EXPECT_EQ(row.error, "TooLarge");
  EXPECT_EQ(row.repair.components, 0u) << "it was not even repaired";
  EXPECT_EQ(notesWith(result.report, "m across"), 0u) << "the row says it";
  for (const char* part : {"'../meshes/bracket.obj' is 300 m across", "--scale 0.001", "scale=\"0.001 0.001 0.001\"", "1%"})
    EXPECT_NE(row.reason.find(part), std::string::npos) << row.reason;
}

TEST_F(DecomposeRobot, AShareAloneTakesALinkOfAnySize) {
  const std::string huge = "    <visual>\n      " + meshTag("../meshes/bracket.obj", " scale=\"1000 1000 1000\"") + "\n    </visual>\n";
  options_.tolerance = shareOf(0.05);
  const RobotResult result = run(link("base", huge));
  EXPECT_EQ(result.report.links[0].status, Status::kOk) << result.report.links[0].reason;
  EXPECT_EQ(notesWith(result.report, "millimetres"), 1u);
}

TEST_F(DecomposeRobot, TheToleranceIsLargerThanTheMesh) {
  const std::string links = link("base", visual("box.obj") + visual("bracket.obj")) + link("tip", visual("box.obj"), "base");
  options_.tolerance = lengthOf(0.5);
  const RobotResult coarse = run(links);
  for (const ElementReport& row : coarse.report.links) EXPECT_EQ(row.hulls, 1u);
  EXPECT_EQ(notesWith(coarse.report, "the tolerance of 500 mm is larger than '../meshes/box.obj'"), 1u);
  EXPECT_EQ(notesWith(coarse.report, "2 other meshes"), 1u);
  options_.tolerance = Options{}.tolerance;
  EXPECT_EQ(notesWith(run(links).report, "is larger than"), 0u);
}

TEST_F(DecomposeRobot, ScaleIsForASingleMesh) {
  options_.scale = 0.001;
  try {
    run(link("base", visual("box.obj")));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    for (const char* part : {"scale '0.001'", "scale=\"0.001 0.001 0.001\""})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST_F(DecomposeRobot, AScaledMesh) {
  const RobotResult plain = decomposeMesh(folder_ / "meshes/bracket.obj", options_);
  options_.scale = 2;
  const RobotResult twice = decomposeMesh(folder_ / "meshes/bracket.obj", options_);
  EXPECT_EQ(twice.report.links[0].scale, Eigen::Vector3d::Constant(2));
  EXPECT_NEAR(twice.report.links[0].diagonal, 2 * plain.report.links[0].diagonal, 1e-12);
  EXPECT_NEAR(twice.elements[0].hulls[0].vertices[0].norm(), 2 * plain.elements[0].hulls[0].vertices[0].norm(), 1e-6);
}

TEST_F(DecomposeRobot, SameBytesForAnyNumberOfThreads) {
  const std::string links =
      link("a", collision("bracket.obj")) + link("b", collision("channel.obj"), "a") + link("c", collision("box.obj"), "a");
  options_.validate = options_.cache = false;
  const auto written = [&](int jobs) {
    options_.jobs = jobs;
    RobotResult result = run(links);
    writeOutput(result, folder_ / "out");
    auto files = fixtures::contents(folder_ / "out");
    files.erase("report.json");  // it holds times
    return files;
  };
  const auto one = written(1);
  EXPECT_GT(one.size(), 5u);
  EXPECT_EQ(written(4), one);
}

TEST_F(DecomposeRobot, RejectsBadOptionsFirst) {
  options_.max_vertices = 5;
  EXPECT_THROW(run(link("a", collision("rubbish.stl"))), Error);
}

TEST_F(DecomposeRobot, SegmentsOfEachElementWithTheCacheAndWithoutIt) {
  options_.method = Method::kHacd;
  const std::string links = link("a", collision("channel.obj") + collision("box.obj"));
  EXPECT_TRUE(run(links).extra_files.empty());
  EXPECT_FALSE(run(links).elements[0].segments);
  options_.segments = true;
  const RobotResult cached = run(links);
  EXPECT_TRUE(cached.report.links[0].cached);
  options_.cache = false;
  const RobotResult result = run(links);
  EXPECT_EQ(result.extra_files, cached.extra_files);
  std::set<std::string> files;
  for (const auto& [file, text] : result.extra_files) files.insert(file);
  EXPECT_EQ(files, (std::set<std::string>{"segments/a/0.ply", "segments/a/0.csv", "segments/a/1.ply", "segments/a/1.csv"}));
  EXPECT_EQ(result.elements[0].segments->segmentation.clusters.size(), result.report.links[0].hulls);
}

}  // namespace
}  // namespace collision_hulls
