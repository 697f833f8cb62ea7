#include "pipeline/mesh_uses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "collision_hulls/error.h"
#include "counted_looks.h"
#include "pipeline/fixtures.h"

namespace collision_hulls {
namespace {

using fixtures::TempFolder;

MeshUse use(const std::string& uri, const Eigen::Vector3d& scale = Eigen::Vector3d::Ones()) {
  MeshUse use;
  use.source.uri = uri;
  use.source.scale = scale;
  return use;
}

GeometryElement boxOf(double thickness) {
  GeometryElement box;
  box.kind = GeometryElement::Kind::kBox;
  box.size = {1, 1, thickness};
  return box;
}

TEST(CollisionFate, FollowsTheActionAndTheSource) {
  LinkDescription link;
  LinkOptions options;
  options.action = Action::kKeep;
  EXPECT_EQ(collisionFate(link, nullptr), CollisionFate::kStay);
  EXPECT_EQ(collisionFate(link, &options), CollisionFate::kStay);
  options.action = Action::kRemove;
  EXPECT_EQ(collisionFate(link, &options), CollisionFate::kGo);
  options.action = Action::kDecompose;
  EXPECT_EQ(collisionFate(link, &options), CollisionFate::kStay);
  link.visuals = {boxOf(0)};
  EXPECT_EQ(collisionFate(link, &options), CollisionFate::kStay) << "it is flat";
  link.visuals = {boxOf(0), boxOf(1)};
  EXPECT_EQ(collisionFate(link, &options), CollisionFate::kReplaced);
  link.collisions = {boxOf(1)};
  EXPECT_EQ(collisionFate(link, &options), CollisionFate::kStay) << "there is nothing to decompose";
  link.collisions.push_back(use("a.stl").source);
  EXPECT_EQ(collisionFate(link, &options), CollisionFate::kReplaced);
}

class MeshTaskTest : public ::testing::Test {
 protected:
  MeshTaskTest() {
    fixtures::write(folder_ / "a.stl", "same content");
    fixtures::write(folder_ / "b.stl", "same content");
    fixtures::write(folder_ / "c.obj", "same content");
    fixtures::write(folder_ / "large.stl", std::string(1000, ' '));
  }

  /// The uses of each variant of each task, in their order.
  std::vector<std::vector<std::size_t>> groups(const std::vector<MeshUse>& uses) {
    found_ = meshTasks(
        uses, [&](const std::string& uri) { return folder_ / uri; }, MeshLimits(), RunControl());
    std::vector<std::vector<std::size_t>> groups;
    for (const MeshTask& task : found_.tasks)
      for (const MeshVariant& variant : task.variants) groups.push_back(variant.uses);
    return groups;
  }

  using Groups = std::vector<std::vector<std::size_t>>;
  TempFolder folder_;
  MeshTasks found_;
};

TEST_F(MeshTaskTest, ContentKindOfFileAndScaleMakeATask) {
  EXPECT_EQ(groups({}), Groups());
  EXPECT_EQ(groups({use("a.stl"), use("c.obj"), use("b.stl"), use("a.stl", {1, 1, -1}), use("a.stl")}), (Groups{{0, 2, 4}, {1}, {3}}));
  EXPECT_EQ(found_.tasks[0].uri, "a.stl");
  EXPECT_EQ(found_.tasks[2].scale, Eigen::Vector3d(1, 1, -1));
  EXPECT_EQ(found_.tasks[0].sha256, found_.tasks[1].sha256);
  EXPECT_TRUE(std::none_of(found_.done.begin(), found_.done.end(), [](const auto& failed) { return failed; }));
}

TEST_F(MeshTaskTest, FilesOfBuffersAreContentToo) {
  const std::string text = R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "part.bin", "byteLength": 4}]})";
  for (const char* folder : {"a/", "b/", "c/"}) {
    fixtures::write(folder_ / (std::string(folder) + "part.gltf"), text);
    fixtures::write(folder_ / (std::string(folder) + "part.bin"), *folder == 'c' ? "4321" : "1234");
  }
  EXPECT_EQ(groups({use("a/part.gltf"), use("b/part.gltf"), use("c/part.gltf")}), (Groups{{0, 1}, {2}}));
  EXPECT_NO_THROW(contentOf(found_.tasks[0], {}, {}));
  fixtures::write(folder_ / "a/part.bin", "4321");
  EXPECT_THROW(contentOf(found_.tasks[0], {}, {}), Error) << "it is no longer what was hashed";
}

TEST_F(MeshTaskTest, RegionsMakeVariantsOfATask) {
  MeshUse clear = use("a.stl"), renamed = use("a.stl"), moved = use("a.stl");
  clear.options.regions = renamed.options.regions = moved.options.regions = {halfSpaceRegion({0, 0, 1}, 1, kRegionSlack)};
  renamed.options.regions[0].name = "top";
  moved.options.regions[0].sides[0].offset = 2;
  EXPECT_EQ(groups({use("a.stl"), clear, renamed, moved}), (Groups{{0}, {1, 2}, {3}}));
}

TEST_F(MeshTaskTest, OptionsMakeVariantsOfATask) {
  MeshUse fine = use("a.stl"), from_visual = use("b.stl");
  fine.options.tolerance = lengthOf(0.001);
  from_visual.options.source = Source::kVisual;
  EXPECT_EQ(groups({use("a.stl"), fine, from_visual, fine}), (Groups{{0, 2}, {1, 3}}));
  ASSERT_EQ(found_.tasks.size(), 1u) << "it is read once";
  EXPECT_EQ(found_.tasks[0].variants[1].options.tolerance.limit, 0.001);
}

TEST_F(MeshTaskTest, EachOptionThatChangesHullsMakesAVariant) {
  const std::vector<std::function<void(LinkOptions&)>> changes = {
      [](LinkOptions& o) { o.tolerance.limit = 0.02; }, [](LinkOptions& o) { o.tolerance.share = 0.01; },
      [](LinkOptions& o) { o.method = Method::kAcd; },  [](LinkOptions& o) { o.effort = Effort::kBest; },
      [](LinkOptions& o) { o.tree = lengthOf(0.001); }, [](LinkOptions& o) { o.fill = true; },
      [](LinkOptions& o) { o.max_hulls = 3; },          [](LinkOptions& o) { o.max_vertices = 16; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    MeshUse other = use("a.stl");
    changes[i](other.options);
    EXPECT_EQ(groups({use("a.stl"), other}), (Groups{{0}, {1}})) << i;
  }
}

TEST_F(MeshTaskTest, WhatIsKeptOrRemovedIsDone) {
  MeshUse kept = use("none.stl"), removed = use("a.stl");
  kept.options.action = Action::kKeep;
  removed.options.action = Action::kRemove;
  EXPECT_EQ(groups({kept, use("a.stl"), removed}), Groups{{1}});
  EXPECT_EQ(found_.done[0]->status, Status::kKept) << "nobody looks for its file";
  EXPECT_EQ(found_.done[2]->status, Status::kRemoved);
  EXPECT_EQ(decomposedUses({kept, use("a.stl"), removed}), 1u);
}

TEST_F(MeshTaskTest, LargestFileFirst) {
  EXPECT_EQ(groups({use("a.stl"), use("large.stl")}), (Groups{{1}, {0}}));
}

TEST_F(MeshTaskTest, AMeshWithoutAFileFailsAlone) {
  MeshUse faulty = use("a.stl");
  faulty.source.fault = "line 7: no";
  EXPECT_EQ(groups({use("none.stl"), use("a.stl"), faulty}), Groups{{1}});
  ASSERT_EQ(found_.done.size(), 3u);
  EXPECT_EQ(found_.done[0]->error, "FileNotFound");
  EXPECT_EQ(found_.done[1], nullptr);
  EXPECT_EQ(found_.done[2]->error, "BadGeometry");
  EXPECT_EQ(found_.done[2]->reason, "line 7: no");
}

TEST(NotesOnIdle, ACancelWaitsForOneExpression) {
  RobotDescription robot;
  Options options;
  for (int i = 0; i < 20; ++i) {
    LinkDescription link;
    link.name = "link" + std::to_string(i);
    link.visuals.push_back(use("a.stl").source);
    link.visuals.back().kind = GeometryElement::Kind::kMesh;
    robot.links.push_back(link);
    options.rules.push_back({link.name + "[a-z]*", {}, ""});
  }
  const LinkDecisions decisions(options, robot);
  EXPECT_EQ(looksAfterCancel(30, [&](const RunControl& control) { notesOnIdle(robot, decisions, options, control); }), 1u);
}

TEST(NotesOnIdle, AListOfNamesIsLookedUp) {
  RobotDescription robot;
  robot.links.resize(2);
  robot.links[0].name = "arm";
  robot.links[1].name = "hand";
  robot.links[0].visuals = {use("a.stl").source};
  robot.links[0].visuals[0].kind = GeometryElement::Kind::kMesh;
  Options options;
  options.rules = {{"hand|arm", {}, ""}, {"hand", {}, ""}};
  const std::vector<std::string> notes = notesOnIdle(robot, LinkDecisions(options, robot), options);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].substr(0, 28), "links 'hand' changes nothing");
}

TEST(NotesOnIdle, OfARuleThatKeepsNothing) {
  RobotDescription robot;
  robot.links.resize(2);
  robot.links[0].name = "base_inertia";
  robot.links[0].collisions = {use("a.stl").source};
  robot.links[1].name = "base";
  for (const std::string pattern : {"base", "base_i.*", "base.*", "base|base_inertia"}) {
    Options options;
    options.rules = {{pattern, {}, "f.yaml, line 2"}};
    options.rules[0].settings.action = Action::kKeep;
    const std::vector<std::string> notes = notesOnIdle(robot, LinkDecisions(options, robot), options);
    std::vector<std::string> expected;
    if (pattern == "base") expected = {"f.yaml, line 2: links 'base' changes nothing: no link that it matches has geometry"};
    EXPECT_EQ(notes, expected) << pattern;
  }
}

TEST(Fail, DropsWhatWasMadeAndKeepsWhatWasRead) {
  MeshResult result;
  result.mesh.triangles = 12;
  result.model.hulls = 3;
  result.hulls.resize(3);
  result.unneeded.resize(1);
  try {
    throw std::bad_alloc();
  } catch (...) {
    fail(result);
  }
  EXPECT_EQ(result.status, Status::kFailed);
  EXPECT_EQ(result.error, "OutOfMemory");
  EXPECT_EQ(result.reason.substr(0, 43), "out of memory for a mesh of 12 triangles; u");
  EXPECT_EQ(result.mesh.triangles, 12u);
  EXPECT_EQ(result.model.hulls + result.hulls.size() + result.unneeded.size(), 0u);
}

TEST(Fail, ACancelledRunIsNoFailure) {
  MeshResult result;
  try {
    throw Error(ErrorCode::kCancelled, "cancelled");
  } catch (...) {
    EXPECT_THROW(fail(result), Error);
  }
  EXPECT_EQ(result.status, Status::kOk);
}

}  // namespace
}  // namespace collision_hulls
