// What a run makes of a robot: its rows, its description, the same for equal meshes and any number of threads.
// Also tests src/pipeline/stages.cpp.
#include "collision_hulls/pipeline/decompose_robot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "collision_hulls/pipeline/output.h"
#include "pipeline/robot_run.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using fixtures::count;
using fixtures::link;

/// The text without its <collision> elements.
std::string withoutCollisions(const std::string& urdf) {
  return std::regex_replace(urdf, std::regex("\\s*<collision[^]*?</collision>"), "");
}

class DecomposeRobot : public fixtures::RobotRun {};

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

TEST_F(DecomposeRobot, PassesOnNotesAboutTheDescription) {
  const RobotResult result = run(link("base", collision("box.obj")) + "  <xacro:gripper/>\n");
  ASSERT_EQ(result.report.notes.size(), 1u);
  EXPECT_NE(result.report.notes[0].find("<xacro:gripper>"), std::string::npos) << result.report.notes[0];
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

// Its lower edge is split in the front alone, so that three edges along one line are open.
TEST_F(DecomposeRobot, ATJunctionIsNoOpening) {
  fixtures::write(folder_ / "meshes/t.obj",
                  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 0.5 0 0\n"
                  "f 1 4 3 2\nf 5 6 7 8\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 1 9 6 5\nf 9 2 6\n");
  const ElementReport row = run(link("t", collision("t.obj"))).report.links.at(0);
  EXPECT_EQ(row.repair.open_edges, 3u);
  EXPECT_EQ(std::make_tuple(row.openings, row.widest_opening), std::make_tuple(0u, 0.0));
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
