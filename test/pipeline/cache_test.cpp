#include "pipeline/cache.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "geometry/bytes.h"
#include "pipeline/fixtures.h"
#include "pipeline/rows.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using fixtures::TempFolder;
using nlohmann::json;
using Notes = std::vector<std::string>;

const std::string kKey(64, '0');

MeshResult mesh() {
  MeshResult result;
  MeshFacts& facts = result.mesh;
  facts.sha256 = "abc";
  facts.triangles = 12;
  facts.skipped_primitives = 2;
  facts.repair = {1, 2, 3, 4, 5, 6, 7, 0.125};
  facts.interior = "closed";
  facts.volume = 7;
  facts.diagonal = 9;
  facts.tolerance = 0.1 + 0.2;
  HullFacts& model = result.model;
  model.hulls = 4;
  model.least_hulls = 3;
  model.hull_vertices = 5;
  model.uncovered = 0.01;
  model.protrusion = 1.0 / 3;
  model.protrusion_found = 0.3;
  model.worst = {1, 2, 3};
  model.worst_nearest = {4, 5, 6};
  model.hull_volume = 8;
  model.covered_share = 0.5;
  model.nudge = 1e-7;
  model.thickness = 1e-6;
  result.status = Status::kDegraded;
  result.reason = "a reason";
  result.error = "an error";
  result.seconds.decompose = 1;
  result.original = test_shapes::box(1, 2, 3);
  result.hulls = {convexHull(test_shapes::box(1, 2, 3).vertices), convexHull(test_shapes::box(4, 5, 6).vertices)};
  return result;
}

/// What a report shows of a mesh, whichever link uses it.
json shown(const MeshResult& mesh) {
  RobotResult result;
  MeshResult timeless = mesh;
  timeless.seconds = {};
  putTogether({MeshUse()}, {std::make_shared<const MeshResult>(timeless)}, result);
  return json::parse(toJson(result.report))["links"][0];
}

TEST(Cache, Empty) {
  const TempFolder folder;
  for (const fs::path& place : {fs::path(), folder.path()}) {
    Cache cache(place);
    EXPECT_FALSE(cache.findMesh(kKey, "abc"));
    EXPECT_FALSE(cache.findValidation(kKey));
    EXPECT_FALSE(cache.findTree(kKey));
    EXPECT_EQ(cache.notes(), Notes());
  }
}

TEST(Cache, RestoresAMeshToTheLastBit) {
  const TempFolder folder;
  Cache(folder.path()).storeMesh(kKey, mesh());
  const auto found = Cache(folder.path()).findMesh(kKey, "abc");
  ASSERT_TRUE(found);
  EXPECT_EQ(shown(*found), shown(mesh()));
  EXPECT_EQ(toBytes(found->original), toBytes(mesh().original));
  EXPECT_EQ(toBytes(found->hulls), toBytes(mesh().hulls));
  EXPECT_EQ(found->seconds.decompose, 0);
}

TEST(Cache, RestoresAValidation) {
  const TempFolder folder;
  Cache cache(folder.path());
  Validation validation{1, 2, 3, 0.1 + 0.2, 4, 0, 6, 7, 8.5, 9.5, {"a remark", "another"}};
  cache.storeValidation(kKey, validation);
  Report before, after;
  before.validation = validation;
  after.validation = cache.findValidation(kKey).value();
  EXPECT_EQ(toJson(after), toJson(before));
}

TEST(Cache, DoesNotStoreAValidationWithTimeouts) {
  const TempFolder folder;
  Cache cache(folder.path());
  Validation validation;
  validation.timeouts = 1;
  cache.storeValidation(kKey, validation);
  EXPECT_FALSE(cache.findValidation(kKey));
}

HullTree tree() {
  const ConvexHull hull = convexHull(test_shapes::box(1, 2, 3).vertices);
  return {{{hull, 0, 2, -1, -1}, {hull, 0.1, 2, -1, -1}, {hull, 0.2, -1, 0, 1}}, 0.1};
}

TEST(Cache, RestoresATree) {
  const TempFolder folder;
  Cache cache(folder.path());
  cache.storeTree(kKey, tree());
  const HullTree found = cache.findTree(kKey).value();
  EXPECT_EQ(found.tolerance, 0.1);
  ASSERT_EQ(found.nodes.size(), 3u);
  EXPECT_EQ(found.nodes[2].right, 1);
  EXPECT_EQ(toBytes(found.nodes[1].hull), toBytes(tree().nodes[1].hull));
}

TEST(Cache, RejectsRemovesAndCountsDamagedEntries) {
  const TempFolder folder;
  const auto spoil = [](const std::string& file, const std::function<void(std::string&)>& change) {
    std::string bytes = fixtures::read(file);
    change(bytes);
    fixtures::write(file, bytes);
  };
  const std::vector<std::function<void(std::string&)>> changes = {
      [](std::string& bytes) { bytes.clear(); }, [](std::string& bytes) { bytes.pop_back(); }, [](std::string& bytes) { bytes += '\0'; },
      [](std::string& bytes) { bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1); },
      [](std::string& bytes) { bytes[8] = 99; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Cache cache(folder.path());
    cache.storeMesh(kKey, mesh());
    cache.storeTree(kKey, tree());
    cache.storeValidation(kKey, {});
    for (const char* kind : {".mesh", ".tree", ".validation"}) spoil(folder / (kKey + kind), changes[i]);
    EXPECT_FALSE(cache.findMesh(kKey, "abc")) << i;
    EXPECT_FALSE(cache.findTree(kKey)) << i;
    EXPECT_FALSE(cache.findValidation(kKey)) << i;
    EXPECT_EQ(fixtures::contents(folder.path()).size(), 1u) << i << ": the key is left";
    ASSERT_EQ(cache.notes().size(), 1u) << i;
    EXPECT_NE(cache.notes()[0].find("3 damaged"), std::string::npos) << cache.notes()[0];
  }
}

TEST(Cache, RejectsAnEntryOfAnotherMesh) {
  const TempFolder folder;
  Cache cache(folder.path());
  cache.storeMesh(kKey, mesh());
  EXPECT_FALSE(cache.findMesh(kKey, "abd"));
  EXPECT_FALSE(cache.findMesh(kKey, "abc")) << "it is removed";
  EXPECT_EQ(cache.notes().size(), 1u);
}

// With a valid seal: nobody else can make one, but whatever it says must not cost more memory than the entry itself.
TEST(Cache, CountsBeyondAnEntrysEnd) {
  const TempFolder folder;
  Cache cache(folder.path());
  cache.storeMesh(kKey, mesh());
  CacheFolder files(folder.path(), Cache::kMostBytes);
  const std::string sound = files.find(kKey + ".mesh").value(), vertices = toBytes(std::uint64_t{8}, mesh().original.vertices[0]);
  const std::size_t place = sound.find(vertices);
  ASSERT_NE(place, std::string::npos);
  for (const std::uint64_t count : {std::uint64_t{9}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    files.store(kKey + ".mesh", std::string(sound).replace(place, 8, toBytes(count)));
    EXPECT_FALSE(cache.findMesh(kKey, "abc")) << count;
  }
  files.store(kKey + ".mesh", sound);
  EXPECT_TRUE(cache.findMesh(kKey, "abc"));
}

TEST(Cache, RejectsAnEntryUnderAnotherName) {
  const TempFolder folder;
  Cache cache(folder.path());
  cache.storeMesh(kKey, mesh());
  const std::string other(64, '1');
  fs::copy(folder / (kKey + ".mesh"), folder / (other + ".mesh"));
  EXPECT_FALSE(cache.findMesh(other, "abc"));
  EXPECT_TRUE(cache.findMesh(kKey, "abc"));
}

MeshTask task() {
  MeshTask task;
  task.file = "part.stl";
  task.uri = "package://arm/part.stl";
  task.scale = {1, -2, 0.5};
  task.sha256 = "abc";
  return task;
}

TEST(CacheKeys, EachInputOfAMeshCounts) {
  const std::vector<std::function<void(MeshTask&, Options&)>> changes = {
      [](MeshTask&, Options&) {},
      [](MeshTask& t, Options&) { t.sha256 = "abd"; },
      [](MeshTask& t, Options&) { t.scale.x() = std::nextafter(1.0, 2.0); },
      [](MeshTask& t, Options&) {
        t.scale = {-2, 1, 0.5};
      },
      [](MeshTask& t, Options&) { t.file = "part.obj"; },
      [](MeshTask& t, Options&) { t.close_openings = 0.05; },
      [](MeshTask&, Options& o) { o.tolerance = shareOf(0.02); },
      [](MeshTask&, Options& o) { o.tolerance = lengthOf(0.01); },
      [](MeshTask&, Options& o) { o.method = Method::kHacd; },
      [](MeshTask&, Options& o) { o.effort = Effort::kBest; },
      [](MeshTask&, Options& o) { o.fill = true; },
      [](MeshTask&, Options& o) { o.tree = shareOf(0.005); },
      [](MeshTask&, Options& o) { o.max_hulls = 3; },
      [](MeshTask&, Options& o) { o.max_vertices = 32; },
      [](MeshTask&, Options& o) { o.padding = 0.02; },
      [](MeshTask&, Options& o) { o.seed = 2; }};
  std::set<std::string> keys, tree_keys;
  for (const auto& change : changes) {
    MeshTask changed = task();
    Options options;
    change(changed, options);
    keys.insert(meshKey(changed, options, options.seed));
    tree_keys.insert(treeKey(changed, options, options.seed, 0.01));
  }
  EXPECT_EQ(keys.size(), changes.size());
  EXPECT_EQ(tree_keys.size(), changes.size() - 5)
      << "tolerances, number of hulls and padding choose and change a cut of the tree, not the tree";
  tree_keys.insert(treeKey(task(), {}, 1, 0.02));
  EXPECT_EQ(tree_keys.size(), changes.size() - 4) << "the tolerance of the leaves is part of the key";
  for (const std::string& key : keys) EXPECT_TRUE(CacheFolder::isEntry(key + ".mesh")) << key;
}

TEST(CacheKeys, ATreeForPrimitivesIsNoTreeToCut) {
  Options options;
  const std::string to_cut = treeKey(task(), options, 1, 0.01);
  options.shapes = Shapes::kPrimitives;
  EXPECT_NE(treeKey(task(), options, 1, 0.01), to_cut) << "its bounds are not proved";
  options.tree = shareOf(0.005);
  EXPECT_EQ(treeKey(task(), options, 1, 0.01), to_cut) << "one that is asked for serves hulls as well";
}

TEST(CacheKeys, WhatChangesNoHullDoesNotCount) {
  MeshTask elsewhere = task();
  elsewhere.file = "other/part.stl";
  elsewhere.uri = "package://other/part.stl";
  elsewhere.bytes = 5;
  elsewhere.variants = {{{}, {3}}};
  Options options;
  options.links = "lower";
  options.source = Source::kVisual;
  options.format = MeshFormat::kObj;
  options.uri = UriStyle::kFile;
  options.jobs = 1;
  options.validate = options.cache = false;
  EXPECT_EQ(meshKey(elsewhere, options, 1), meshKey(task(), {}, 1));
}

TEST(CacheKeys, EachInputOfAValidationCounts) {
  MeshUse upper;
  upper.link = "upper";
  upper.element = 3;
  std::vector<MeshUse> uses = {upper, upper, upper};
  const auto result = std::make_shared<const MeshResult>(mesh());
  MeshResults results = {result, result, std::make_shared<const MeshResult>()};
  std::vector<std::string> keys = {"a", "b", "failed"};
  std::set<std::string> found;
  std::size_t expected = 0;
  const auto add = [&](const Options& options) {
    found.insert(validationKey(uses, results, keys, 0, options.seed));
    EXPECT_EQ(found.size(), ++expected);
  };
  Options options;
  add(options);
  options.seed = 2;
  add(options);
  keys[0] = "c";
  add(options);
  uses[1].link = "lower";
  add(options);
  uses[1].element = 4;
  add(options);
  uses[0].pose.translation().x() = 1e-9;
  add(options);
  uses[0].pose.linear() = Eigen::AngleAxisd(1e-9, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  add(options);
  std::swap(keys[0], keys[1]);
  add(options);
  const std::string before = validationKey(uses, results, keys, 0, options.seed);
  uses.resize(2);
  results.resize(2);
  EXPECT_EQ(validationKey(uses, results, keys, 0, options.seed), before) << "a use without hulls must not matter";
}

}  // namespace
}  // namespace collision_hulls
