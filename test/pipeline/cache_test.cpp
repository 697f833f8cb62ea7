#include "pipeline/cache.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "geometry/bytes.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using fixtures::TempFolder;
using nlohmann::json;
using Notes = std::vector<std::string>;

const std::string kKey(64, '0');

ElementResult element() {
  ElementResult element;
  ElementReport& row = element.report;
  row.link = "upper";
  row.element = 3;
  row.visual = true;
  row.uri = "upper.stl";
  row.sha256 = "abc";
  row.scale = {1, -2, 0.5};
  row.triangles = 12;
  row.skipped_primitives = 2;
  row.status = Status::kDegraded;
  row.reason = "a reason";
  row.error = "an error";
  row.repair = {1, 2, 3, 4, 5, 6, 7, 0.125};
  row.method = Method::kSingleHull;
  row.tolerance = 0.1 + 0.2;
  row.hulls = 4;
  row.hull_vertices = 5;
  row.uncovered = 0.01;
  row.protrusion = 1.0 / 3;
  row.protrusion_found = 0.3;
  row.worst = {1, 2, 3};
  row.worst_nearest = {4, 5, 6};
  row.interior = "closed";
  row.volume = 7;
  row.hull_volume = 8;
  row.covered_share = 0.5;
  row.diagonal = 9;
  row.nudge = 1e-7;
  row.thickness = 1e-6;
  row.seconds.decompose = 1;
  row.files = {"a file"};
  element.original = test_shapes::box(1, 2, 3);
  element.hulls = {convexHull(test_shapes::box(1, 2, 3).vertices), convexHull(test_shapes::box(4, 5, 6).vertices)};
  return element;
}

/// The part of an element's report that does not depend on its place in a robot.
json shown(ElementResult element) {
  Report report;
  ElementReport& row = element.report;
  row.link = row.uri = "";
  row.element = 0;
  row.visual = row.cached = false;
  row.seconds = {};
  row.files.clear();
  report.links.push_back(row);
  return json::parse(toJson(report))["links"][0];
}

TEST(Cache, Empty) {
  const TempFolder folder;
  for (const fs::path& place : {fs::path(), folder.path()}) {
    Cache cache(place);
    EXPECT_FALSE(cache.findElement(kKey));
    EXPECT_FALSE(cache.findValidation(kKey));
    EXPECT_FALSE(cache.findTree(kKey));
    EXPECT_EQ(cache.notes(), Notes());
  }
}

TEST(Cache, RestoresAnElementToTheLastBit) {
  const TempFolder folder;
  Cache(folder.path()).storeElement(kKey, element());
  const auto found = Cache(folder.path()).findElement(kKey);
  ASSERT_TRUE(found);
  EXPECT_EQ(shown(*found), shown(element()));
  EXPECT_EQ(toBytes(found->original), toBytes(element().original));
  EXPECT_EQ(toBytes(found->hulls), toBytes(element().hulls));
  EXPECT_EQ(found->report.link, "") << "an entry must not contain its place in a robot";
  EXPECT_EQ(found->report.seconds.decompose, 0);
  EXPECT_TRUE(found->report.files.empty());
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
      [](std::string& bytes) { bytes[8] = 99; }};  // the format's version
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Cache cache(folder.path());
    cache.storeElement(kKey, element());
    cache.storeTree(kKey, tree());
    cache.storeValidation(kKey, {});
    for (const char* kind : {".element", ".tree", ".validation"}) spoil(folder / (kKey + kind), changes[i]);
    EXPECT_FALSE(cache.findElement(kKey)) << i;
    EXPECT_FALSE(cache.findTree(kKey)) << i;
    EXPECT_FALSE(cache.findValidation(kKey)) << i;
    EXPECT_TRUE(fixtures::contents(folder.path()).empty()) << i;
    ASSERT_EQ(cache.notes().size(), 1u) << i;
    EXPECT_NE(cache.notes()[0].find("3 damaged"), std::string::npos) << cache.notes()[0];
  }
}

TEST(Cache, RejectsAnEntryUnderAnotherName) {
  const TempFolder folder;
  Cache cache(folder.path());
  cache.storeElement(kKey, element());
  const std::string other(64, '1');
  fs::copy(folder / (kKey + ".element"), folder / (other + ".element"));
  EXPECT_FALSE(cache.findElement(other));
  EXPECT_TRUE(cache.findElement(kKey));
}

TEST(CacheKeys, EachInputOfAnElementCounts) {
  const ElementReport row = element().report;
  const std::vector<std::function<void(ElementReport&, std::string&, Options&)>> changes = {
      [](ElementReport&, std::string&, Options&) {},
      [](ElementReport& r, std::string&, Options&) { r.sha256 = "abd"; },
      [](ElementReport& r, std::string&, Options&) { r.scale.x() = std::nextafter(1.0, 2.0); },
      [](ElementReport& r, std::string&, Options&) {
        r.scale = {-2, 1, 0.5};
      },
      [](ElementReport&, std::string& file, Options&) { file = "part.obj"; },
      [](ElementReport&, std::string&, Options& o) { o.tolerance = shareOf(0.02); },
      [](ElementReport&, std::string&, Options& o) { o.tolerance = lengthOf(0.01); },
      [](ElementReport&, std::string&, Options& o) { o.method = Method::kHacd; },
      [](ElementReport&, std::string&, Options& o) { o.effort = Effort::kBest; },
      [](ElementReport&, std::string&, Options& o) { o.fill = true; },
      [](ElementReport&, std::string&, Options& o) { o.tree = shareOf(0.005); },
      [](ElementReport&, std::string&, Options& o) { o.max_hulls = 3; },
      [](ElementReport&, std::string&, Options& o) { o.max_vertices = 32; },
      [](ElementReport&, std::string&, Options& o) { o.seed = 2; }};
  std::set<std::string> keys, tree_keys;
  for (const auto& change : changes) {
    ElementReport changed = row;
    std::string file = "part.stl";
    Options options;
    change(changed, file, options);
    keys.insert(elementKey(changed, file, options));
    tree_keys.insert(treeKey(changed, file, options, 0.01));
  }
  EXPECT_EQ(keys.size(), changes.size());
  EXPECT_EQ(tree_keys.size(), changes.size() - 4) << "tolerances and number of hulls choose a cut of the tree, not the tree";
  tree_keys.insert(treeKey(row, "part.stl", {}, 0.02));
  EXPECT_EQ(tree_keys.size(), changes.size() - 3) << "the tolerance of the leaves is part of the key";
  for (const std::string& key : keys) EXPECT_TRUE(CacheFolder::isEntry(key + ".element")) << key;
}

TEST(CacheKeys, OptionsThatChangeNoHullDoNotCount) {
  const ElementReport row = element().report;
  ElementReport elsewhere = row;
  elsewhere.link = "lower";
  elsewhere.uri = "package://other/part.stl";
  elsewhere.visual = false;
  Options options;
  options.links = "lower";
  options.source = Source::kVisual;
  options.format = MeshFormat::kObj;
  options.uri = UriStyle::kFile;
  options.jobs = 1;
  options.validate = options.cache = false;
  EXPECT_EQ(elementKey(elsewhere, "other/part.stl", options), elementKey(row, "part.stl", {}));
}

TEST(CacheKeys, EachInputOfAValidationCounts) {
  std::vector<ElementResult> elements = {element(), element(), ElementResult()};
  std::vector<std::string> keys = {"a", "b", "failed"};
  std::set<std::string> found;
  std::size_t expected = 0;
  const auto add = [&](const Options& options) {
    found.insert(validationKey(elements, keys, options));
    EXPECT_EQ(found.size(), ++expected);
  };
  Options options;
  add(options);
  options.seed = 2;
  add(options);
  keys[0] = "c";
  add(options);
  elements[1].report.link = "lower";
  add(options);
  elements[1].report.element = 4;
  add(options);
  elements[0].pose.translation().x() = 1e-9;
  add(options);
  elements[0].pose.linear() = Eigen::AngleAxisd(1e-9, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  add(options);
  std::swap(keys[0], keys[1]);
  add(options);
  elements.resize(2);
  EXPECT_EQ(validationKey(elements, keys, options), *found.find(validationKey(elements, keys, options)))
      << "an element without hulls must not matter";
}

}  // namespace
}  // namespace collision_hulls
