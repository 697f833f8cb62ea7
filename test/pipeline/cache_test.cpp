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

/// What an element has that does not depend on where it stands, as the report shows it.
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

TEST(Cache, AnElementComesBackToTheLastBit) {
  const TempFolder folder;
  Cache(folder.path()).storeElement(kKey, element());
  const auto found = Cache(folder.path()).findElement(kKey);
  ASSERT_TRUE(found);
  EXPECT_EQ(shown(*found), shown(element()));
  EXPECT_EQ(toBytes(found->original), toBytes(element().original));
  EXPECT_EQ(toBytes(found->hulls), toBytes(element().hulls));
  EXPECT_EQ(found->report.link, "") << "says nothing about where it stands";
  EXPECT_EQ(found->report.seconds.decompose, 0);
  EXPECT_TRUE(found->report.files.empty());
}

TEST(Cache, AValidationComesBack) {
  const TempFolder folder;
  Cache cache(folder.path());
  Validation validation{1, 2, 3, 0.1 + 0.2, 4, 0, 6, 7, 8.5, 9.5, {"a remark", "another"}};
  cache.storeValidation(kKey, validation);
  Report before, after;
  before.validation = validation;
  after.validation = cache.findValidation(kKey).value();
  EXPECT_EQ(toJson(after), toJson(before));
}

TEST(Cache, AValidationWithTimeoutsIsNotRemembered) {
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

TEST(Cache, ATreeComesBack) {
  const TempFolder folder;
  Cache cache(folder.path());
  cache.storeTree(kKey, tree());
  const HullTree found = cache.findTree(kKey).value();
  EXPECT_EQ(found.tolerance, 0.1);
  ASSERT_EQ(found.nodes.size(), 3u);
  EXPECT_EQ(found.nodes[2].right, 1);
  EXPECT_EQ(toBytes(found.nodes[1].hull), toBytes(tree().nodes[1].hull));
}

TEST(Cache, DamagedEntriesAreRefusedRemovedAndCounted) {
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

TEST(Cache, AnEntryUnderAnotherNameIsNotTaken) {
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
      [](ElementReport&, std::string&, Options& o) {
        o.tolerance = {0.02, true};
      },
      [](ElementReport&, std::string&, Options& o) {
        o.tolerance = {0.01, false};
      },
      [](ElementReport&, std::string&, Options& o) { o.method = Method::kHacd; },
      [](ElementReport&, std::string&, Options& o) { o.effort = Effort::kBest; },
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
  EXPECT_EQ(tree_keys.size(), changes.size() - 3) << "tolerance and number of hulls choose a cut of the tree, not the tree";
  tree_keys.insert(treeKey(row, "part.stl", {}, 0.02));
  EXPECT_EQ(tree_keys.size(), changes.size() - 2) << "the tolerance of its leaves does";
  for (const std::string& key : keys) EXPECT_TRUE(CacheFolder::isEntry(key + ".element")) << key;
}

TEST(CacheKeys, WhatChangesNoHullDoesNotCount) {
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
      << "one without hulls is not asked";
}

/// Runs with a cache, from here on.
class CachedRun : public ::testing::Test {
 protected:
  CachedRun() {
    fixtures::write(folder_ / "meshes/box.obj", fixtures::obj(test_shapes::box(0.1, 0.2, 0.3)));
    fixtures::write(folder_ / "meshes/bracket.obj", fixtures::obj(test_shapes::lBracket(0.2, 0.03, 0.1)));
    fixtures::write(folder_ / "meshes/channel.obj", fixtures::obj(test_shapes::uChannel(0.2, 0.2, 0.02, 0.4)));
    fixtures::write(folder_ / "meshes/rubbish.stl", "no mesh at all");
    fixtures::write(folder_ / "urdf/arm.urdf", description());
  }

  static std::string description() {
    const auto part = [](const std::string& name, const std::string& mesh, const std::string& parent = "") {
      return fixtures::link(name, "    <collision>" + fixtures::meshTag("../meshes/" + mesh) + "</collision>\n", parent);
    };
    return fixtures::robot(
        "arm", part("a", "bracket.obj") + part("b", "channel.obj", "a") + part("c", "rubbish.stl", "a") + part("d", "bracket.obj", "b"));
  }

  /// A run, which leaves everything that it writes in `files_` but for its report.
  RobotResult run() {
    const RobotDescription robot = readRobotDescription(folder_ / "urdf/arm.urdf");
    RunControl control;
    calls_ = 0;
    control.progress = [&](double) { ++calls_; };
    RobotResult result = decomposeRobot(robot, defaultPackageFinder(), options_, folder_ / "out", control);
    writeOutput(result, folder_ / "out");
    files_ = fixtures::contents(folder_ / "out");
    files_.erase("report.json");
    return result;
  }

  /// What a report says, but for times and what came from the cache.
  static json timeless(const RobotResult& result) {
    json report = json::parse(toJson(result.report));
    for (json& row : report["links"]) {
      row.erase("seconds");
      row.erase("cached");
    }
    for (const char* field : {"cached", "mesh_query_us", "hull_query_us"}) report["validation"].erase(field);
    report["totals"].erase("seconds");
    report["options"].erase("no-cache");
    return report;
  }

  static std::vector<bool> cachedRows(const RobotResult& result) {
    std::vector<bool> cached;
    for (const ElementReport& row : result.report.links) cached.push_back(row.cached);
    return cached;
  }

  fs::path cache() const { return fixtures::OwnCache::listener()->path(); }
  std::map<std::string, std::string> entries() const {
    return fs::exists(cache()) ? fixtures::contents(cache()) : std::map<std::string, std::string>();
  }

  const std::vector<bool> kNone = {false, false, false, false}, kAll = {true, true, false, true};  // what fails is tried again
  TempFolder folder_;
  Options options_;
  std::size_t calls_ = 0;
  std::map<std::string, std::string> files_;
};

TEST_F(CachedRun, SameBytesWithAndWithout) {
  options_.cache = false;
  const json uncached = timeless(run());
  const auto files = files_;
  EXPECT_GT(files.size(), 5u);
  options_.cache = true;
  for (const std::vector<bool>& expected : {kNone, kAll, kAll}) {
    const RobotResult result = run();
    EXPECT_EQ(cachedRows(result), expected);
    EXPECT_EQ(result.report.validation_cached, expected == kAll);
    EXPECT_EQ(timeless(result), uncached);
    EXPECT_EQ(files_, files);
  }
}

// A decomposition tells of its progress again and again; where there is none, each task and the validation end, and that is all.
TEST_F(CachedRun, ASecondRunDoesNothingAgain) {
  run();
  const std::size_t first = calls_;
  const RobotResult second = run();
  EXPECT_EQ(calls_, 3u + 1u) << "after " << first << " in the first run";
  EXPECT_GT(first, calls_);
  for (const ElementReport& row : second.report.links) {
    if (row.cached) {
      EXPECT_EQ(row.seconds.repair + row.seconds.decompose + row.seconds.certify, 0);
    }
  }
}

// What it finds is what it returns: an entry that was changed with care comes out.
TEST_F(CachedRun, EntriesAreWhatIsUsed) {
  const RobotResult first = run();
  const std::string key = elementKey(first.report.links[1], "channel.obj", options_);
  Cache cache(this->cache());
  ElementResult forged = cache.findElement(key).value();
  forged.report.reason = "forged";
  cache.storeElement(key, forged);
  EXPECT_EQ(run().report.links[1].reason, "forged");
}

TEST_F(CachedRun, OtherOptionsAreOtherEntries) {
  run();
  const std::vector<std::function<void(Options&)>> changes = {
      [](Options& o) { o.tolerance = {0.03, true}; }, [](Options& o) { o.method = Method::kSingleHull; },
      [](Options& o) { o.effort = Effort::kBest; },   [](Options& o) { o.max_hulls = 1; },
      [](Options& o) { o.max_vertices = 8; },         [](Options& o) { o.seed = 2; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    options_ = Options();
    changes[i](options_);
    EXPECT_EQ(cachedRows(run()), kNone) << i;
    EXPECT_EQ(cachedRows(run()), kAll) << i;
  }
  options_ = Options();
  options_.jobs = 1;
  options_.uri = UriStyle::kRelative;
  options_.format = MeshFormat::kObj;
  EXPECT_EQ(cachedRows(run()), kAll) << "these change no hull";
}

TEST_F(CachedRun, AnotherMeshOfTheSameNameIsAnotherEntry) {
  run();
  fixtures::write(folder_ / "meshes/channel.obj", fixtures::obj(test_shapes::uChannel(0.2, 0.2, 0.03, 0.4)));
  const RobotResult result = run();
  EXPECT_EQ(cachedRows(result), (std::vector<bool>{true, false, false, true}));
  EXPECT_FALSE(result.report.validation_cached);
}

// Its digest was taken at the beginning: what is read later must not be remembered under it.
TEST_F(CachedRun, AMeshThatChangesDuringTheRun) {
  const std::string bracket = folder_ / "meshes/bracket.obj", channel = folder_ / "meshes/channel.obj";
  fixtures::write(bracket, fixtures::read(bracket) + "#" + std::string(1000, '-') + "\n");  // the largest is read first
  for (const std::string& mesh : {bracket, channel}) fs::last_write_time(mesh, fs::file_time_type::clock::now() - std::chrono::hours(1));
  const std::string before = fixtures::read(channel);
  options_.jobs = 1;
  const auto change = [&](const Step& step) {
    if (step.item == "a") fixtures::write(channel, fixtures::obj(test_shapes::uChannel(0.2, 0.2, 0.03, 0.4)));
  };
  const RobotDescription robot = readRobotDescription(folder_ / "urdf/arm.urdf");
  const RobotResult changed = decomposeRobot(robot, defaultPackageFinder(), options_, folder_ / "out", {}, change);
  EXPECT_EQ(changed.report.links[1].error, "FileNotFound");
  EXPECT_NE(changed.report.links[1].reason.find("channel.obj' was changed"), std::string::npos) << changed.report.links[1].reason;
  fixtures::write(channel, before);
  const RobotResult again = run();
  EXPECT_EQ(cachedRows(again), (std::vector<bool>{true, false, false, true}));
  EXPECT_NE(again.report.links[1].status, Status::kFailed) << again.report.links[1].reason;
}

TEST_F(CachedRun, AnotherPlaceIsAnotherValidationOnly) {
  run();
  std::string moved = description();
  moved.replace(moved.find("xyz=\"0 0 0.5\""), 13, "xyz=\"0 0 0.6\"");
  fixtures::write(folder_ / "urdf/arm.urdf", moved);
  const RobotResult result = run();
  EXPECT_EQ(cachedRows(result), kAll);
  EXPECT_FALSE(result.report.validation_cached);
}

TEST_F(CachedRun, DamagedEntriesAreMadeAnew) {
  const json sound = timeless(run());
  const auto files = files_;
  const auto before = entries();
  EXPECT_EQ(before.size(), 3u) << "two meshes and the validation";
  for (const auto& [name, bytes] : before) fixtures::write(cache() / name, bytes.substr(0, bytes.size() / 2));
  const RobotResult rebuilt = run();
  EXPECT_EQ(cachedRows(rebuilt), kNone);
  EXPECT_EQ(files_, files);
  ASSERT_FALSE(rebuilt.report.notes.empty());
  EXPECT_NE(rebuilt.report.notes[0].find("3 damaged"), std::string::npos) << rebuilt.report.notes[0];
  const RobotResult again = run();
  EXPECT_EQ(cachedRows(again), kAll);
  EXPECT_EQ(timeless(again), sound);
}

TEST_F(CachedRun, WithoutCacheNothingIsReadOrWritten) {
  options_.cache = false;
  run();
  EXPECT_FALSE(fs::exists(cache()));
  options_.cache = true;
  run();
  const auto before = entries();
  for (const auto& [name, bytes] : before) fixtures::write(cache() / name, "damaged");
  options_.cache = false;
  const RobotResult result = run();
  EXPECT_EQ(cachedRows(result), kNone);
  for (const auto& [name, bytes] : entries()) EXPECT_EQ(bytes, "damaged") << name;
}

TEST_F(CachedRun, AnUnwritableFolderIsANote) {
  options_.cache = false;
  run();
  const auto files = files_;
  options_.cache = true;
  fixtures::write(cache(), "a file where the folder should be");
  const RobotResult result = run();
  EXPECT_EQ(files_, files);
  EXPECT_EQ(cachedRows(result), kNone);
  ASSERT_FALSE(result.report.notes.empty());
  EXPECT_NE(result.report.notes[0].find(cache().string()), std::string::npos) << result.report.notes[0];
}

TEST_F(CachedRun, ThreadsAtTheSameTime) {
  const RobotDescription robot = readRobotDescription(folder_ / "urdf/arm.urdf");
  std::vector<json> reports(3);
  std::vector<std::thread> threads;
  for (json& report : reports) {
    threads.emplace_back([&] { report = timeless(decomposeRobot(robot, defaultPackageFinder(), options_, folder_ / "out")); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(reports[1], reports[0]);
  EXPECT_EQ(reports[2], reports[0]);
  EXPECT_EQ(cachedRows(run()), kAll);
}

TEST_F(CachedRun, OneMesh) {
  const auto mesh = [&] { return decomposeMesh(folder_ / "meshes/channel.obj", options_); };
  const RobotResult first = mesh(), second = mesh();
  EXPECT_EQ(cachedRows(second), std::vector<bool>{true});
  EXPECT_EQ(timeless(second), timeless(first));
  EXPECT_EQ(toBytes(second.elements[0].hulls), toBytes(first.elements[0].hulls));
  EXPECT_EQ(toBytes(second.elements[0].original), toBytes(first.elements[0].original));
}

}  // namespace
}  // namespace collision_hulls
