// Meshes that fail, that are of a size that cannot be meant, and runs that are refused: what is said, and that no other link is lost.
// Also tests src/pipeline/mesh_result.cpp, src/pipeline/run.cpp and src/pipeline/stages.cpp.
#include <gtest/gtest.h>

#include <algorithm>

#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/output.h"
#include "pipeline/robot_run.h"

namespace collision_hulls {
namespace {

using fixtures::link;
using fixtures::meshTag;

class FailedMeshes : public fixtures::RobotRun {};

TEST_F(FailedMeshes, MoreHullsThanADescriptionMayHoldEndTheRun) {
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

TEST_F(FailedMeshes, UnreadableElementHasItsOwnRow) {
  const std::string bad = "    <visual>\n      " + meshTag("../meshes/box.obj", " scale=\"0.001\"") + "\n    </visual>\n";
  const RobotResult result = run(link("base", visual("bracket.obj")) + link("tip", bad, "base"));
  ASSERT_EQ(result.report.links.size(), 2u);
  EXPECT_EQ(result.report.links[0].status, Status::kOk);
  EXPECT_EQ(result.report.links[1].status, Status::kFailed);
  EXPECT_EQ(result.report.links[1].error, "BadGeometry");
  for (const char* part : {"arm.urdf', line ", "<visual> of link 'tip'", "0.001"})
    EXPECT_NE(result.report.links[1].reason.find(part), std::string::npos) << result.report.links[1].reason;
}

TEST_F(FailedMeshes, OneBadLinkLosesNoOther) {
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

TEST_F(FailedMeshes, ALinkWithoutCollisionElementsGetsTheHullsOfItsOtherMeshes) {
  const RobotResult result =
      run(link("base", visual("box.obj") + visual("rubbish.stl")) + link("tip", visual("rubbish.stl"), "base") +
          link("ball", visual("rubbish.stl") + "    <visual><geometry><sphere radius=\"1\"/></geometry></visual>\n", "base"));
  EXPECT_NE(result.urdf.find("meshes/base/0_0.stl"), std::string::npos) << result.urdf;
  const std::string all = fixtures::joined(result.report.notes);
  for (const char* part :
       {"links base, ball have no <collision> elements to keep in place of meshes that failed: only their other elements collide; mend the "
        "meshes, or add <collision> elements",
        "link 'tip' has no <collision> elements to keep in place of a mesh that failed: nothing collides there; mend the mesh, or add a "
        "<collision> element"})
    EXPECT_NE(all.find(part), std::string::npos) << all;
}

TEST_F(FailedMeshes, LinksWithTheSameLossShareANote) {
  std::string links = link("base", collision("box.obj"));
  for (int i = 0; i < 7; ++i) {
    links += link("bare" + std::to_string(i), visual("rubbish.stl"), "base");
    links += link("part" + std::to_string(i), collision("box.obj") + collision("rubbish.stl"), "base");
  }
  const std::vector<std::string> notes = run(links).report.notes;
  const auto counted = [&](const std::string& note) { return std::count(notes.begin(), notes.end(), note); };
  EXPECT_EQ(counted("links bare0, bare1, bare2, bare3, bare4 and 2 more have no <collision> elements to keep in place of meshes that "
                    "failed: nothing collides there; mend the meshes, or add <collision> elements"),
            1)
      << fixtures::joined(notes);
  EXPECT_EQ(counted("links part0, part1, part2, part3, part4 and 2 more keep their collision elements because a mesh of each failed; "
                    "hulls of their other meshes are written, but not used"),
            1);
  for (const std::string& note : notes) EXPECT_EQ(note.find("link '"), std::string::npos) << note;
}

// Each row names its own mesh, though equal ones are worked on once.
TEST_F(FailedMeshes, AnEqualMeshFailsUnderItsOwnName) {
  fixtures::write(folder_ / "meshes/copy.stl", fixtures::read(folder_ / "meshes/rubbish.stl"));
  const RobotResult result = run(link("a", collision("rubbish.stl")) + link("b", collision("copy.stl"), "a") +
                                 link("c", collision("rubbish.stl"), "a") + link("d", collision("box.obj"), "a"));
  const auto& rows = result.report.links;
  ASSERT_EQ(rows.size(), 4u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(rows[i].error, "NotAMesh") << rows[i].reason;
  EXPECT_EQ(rows[1].reason, "'../meshes/copy.stl' is equal to '../meshes/rubbish.stl': " + rows[0].reason);
  EXPECT_EQ(rows[2].reason, rows[0].reason);
}

// A run in which everything fails is usually at fault itself, so nothing is written. Not so if as many links need no mesh.
TEST_F(FailedMeshes, OneBadMeshLosesNoLinkOfPrimitives) {
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

std::size_t notesWith(const Report& report, const std::string& part) {
  return static_cast<std::size_t>(std::count_if(report.notes.begin(), report.notes.end(),
                                                [&](const std::string& note) { return note.find(part) != std::string::npos; }));
}

// 200 m long: a box in millimetres that is read as metres.
TEST_F(FailedMeshes, AMeshInMillimetresFailsBeforeTheWorkAndLeavesTheOthers) {
  const std::string huge = "    <visual>\n      " + meshTag("../meshes/bracket.obj", " scale=\"1000 1000 1000\"") + "\n    </visual>\n";
  const RobotResult result = run(link("base", visual("box.obj")) + link("tip", huge, "base"));
  EXPECT_EQ(result.report.links[0].status, Status::kOk);
  const ElementReport& row = result.report.links[1];
  EXPECT_EQ(row.status, Status::kFailed);
  EXPECT_EQ(row.error, "TooLarge");
  EXPECT_EQ(row.repair.components, 0u) << "it was not even repaired";
  EXPECT_EQ(notesWith(result.report, "m across"), 0u) << "the row says it";
  for (const char* part : {"'../meshes/bracket.obj' is 300 m across", "by 0.001 in place of '1000 1000 1000'", "--scale 0.001",
                           "scale=\"0.001 0.001 0.001\"", "1%"})
    EXPECT_NE(row.reason.find(part), std::string::npos) << row.reason;
}

TEST_F(FailedMeshes, AMeshThatIsTooLargeInMillimetresIsNotToldToBeMillimetres) {
  fixtures::write(folder_ / "meshes/huge.obj", fixtures::obj(test_shapes::box(3e4, 1, 1)));
  const std::string mirrored =
      "    <visual>\n      " + meshTag("../meshes/bracket.obj", " scale=\"-1000 -1000 -1000\"") + "\n    </visual>\n";
  EXPECT_NE(run(link("base", mirrored)).report.links[0].reason.find("scale it by 0.001 in place of"), std::string::npos);
  const std::string huge = "    <visual>\n      " + meshTag("../meshes/huge.obj", " scale=\"0.001 0.001 0.001\"") + "\n    </visual>\n";
  const std::string reason = run(link("base", visual("box.obj")) + link("tip", huge, "base")).report.links[1].reason;
  EXPECT_NE(reason.find("'../meshes/huge.obj' is 30 m across"), std::string::npos) << reason;
  EXPECT_NE(reason.find("too large for the scale '0.001 0.001 0.001': give a smaller one; if it really is that large"), std::string::npos)
      << reason;
}

TEST_F(FailedMeshes, AScaleBeyondNumbersIsNamed) {
  const std::string huge = "    <visual>\n      " + meshTag("../meshes/bracket.obj", " scale=\"1e300 1e300 1e300\"") + "\n    </visual>\n";
  options_.tolerance = shareOf(0.05);
  const RobotResult result = run(link("base", visual("box.obj")) + link("tip", huge, "base"));
  const ElementReport& row = result.report.links[1];
  EXPECT_EQ(row.status, Status::kFailed);
  EXPECT_EQ(row.error, "TooLarge");
  EXPECT_NE(row.reason.find("with the scale '1e+300 1e+300 1e+300'; correct the scale"), std::string::npos) << row.reason;
}

TEST_F(FailedMeshes, AShareAloneTakesALinkOfAnySize) {
  const std::string huge = "    <visual>\n      " + meshTag("../meshes/bracket.obj", " scale=\"1000 1000 1000\"") + "\n    </visual>\n";
  options_.tolerance = shareOf(0.05);
  const RobotResult result = run(link("base", huge));
  EXPECT_EQ(result.report.links[0].status, Status::kOk) << result.report.links[0].reason;
  EXPECT_EQ(notesWith(result.report, "millimetres"), 1u);
}

TEST_F(FailedMeshes, TheToleranceIsLargerThanTheMesh) {
  const std::string links = link("base", visual("box.obj") + visual("bracket.obj")) + link("tip", visual("box.obj"), "base");
  options_.tolerance = lengthOf(0.5);
  const RobotResult coarse = run(links);
  for (const ElementReport& row : coarse.report.links) EXPECT_EQ(row.hulls, 1u);
  EXPECT_EQ(notesWith(coarse.report, "the tolerance of 500 mm is larger than '../meshes/box.obj'"), 1u);
  EXPECT_EQ(notesWith(coarse.report, "2 other meshes"), 1u);
  options_.tolerance = Options{}.tolerance;
  EXPECT_EQ(notesWith(run(links).report, "is larger than"), 0u);
}

TEST_F(FailedMeshes, ScaleIsForASingleMesh) {
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

TEST_F(FailedMeshes, RejectsBadOptionsFirst) {
  options_.max_vertices = 5;
  EXPECT_THROW(run(link("a", collision("rubbish.stl"))), Error);
}

}  // namespace
}  // namespace collision_hulls
