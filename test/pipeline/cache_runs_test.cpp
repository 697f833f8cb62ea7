// Runs with a cache: what they find equals what a new computation would give.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <thread>

#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/pipeline/output.h"
#include "collision_hulls/report/totals.h"
#include "geometry/bytes.h"
#include "pipeline/cache.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using fixtures::TempFolder;
using nlohmann::json;
using Notes = std::vector<std::string>;

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

  /// A run; `files_` then has everything it wrote except its report.
  RobotResult run() {
    const RobotDescription robot = readRobotDescription(folder_ / "urdf/arm.urdf");
    RunControl control;
    calls_ = 0;
    control.progress = [&](double) { ++calls_; };
    RobotResult result = decomposeRobot(robot, defaultPackageFinder(), options_, folder_ / "out", control);
    writeOutput(result, folder_ / "out");
    files_ = fixtures::contents(folder_ / "out");
    for (const char* name : {"report.json", "report.html"}) files_.erase(name);
    return result;
  }

  /// A report without times and without what came from the cache.
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
    auto files = fs::exists(cache()) ? fixtures::contents(cache()) : std::map<std::string, std::string>();
    for (const char* no_entry : {"key", ".trimmed"}) files.erase(no_entry);
    return files;
  }

  /// The names of entries for meshes, in the order of their size.
  std::vector<std::string> meshEntries() const {
    std::vector<std::string> names;
    for (const auto& [name, bytes] : entries())
      if (fs::path(name).extension() == ".mesh") names.push_back(name);
    std::sort(names.begin(), names.end(), [&](auto& a, auto& b) { return fs::file_size(cache() / a) < fs::file_size(cache() / b); });
    return names;
  }

  /// A run after an attack: gives what a run without a cache gives, and says that it refused this many entries.
  void expectNoticed(const json& sound, std::size_t refused) {
    const RobotResult result = run();
    json report = timeless(result);
    ASSERT_EQ(report["notes"].size(), sound["notes"].size() + 1);
    EXPECT_NE(result.report.notes[0].find(std::to_string(refused) + " damaged or foreign entries"), std::string::npos)
        << result.report.notes[0];
    report["notes"].erase(0);
    EXPECT_EQ(report, sound);
    EXPECT_EQ(cachedRows(run()), kAll) << "they were not replaced";
  }

  const std::vector<bool> kNone = {false, false, false, false}, kAll = {true, true, false, true};  // a failed mesh is tried again
  TempFolder folder_;
  Options options_;
  std::size_t calls_ = 0;
  std::map<std::string, std::string> files_;
};

TEST_F(CachedRun, SameBytesWithAndWithoutCache) {
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

// A decomposition reports progress many times. Without one there are two reports per task, as it is skipped and done, and three as the
// stages change.
TEST_F(CachedRun, SecondRunRepeatsNoWork) {
  run();
  const std::size_t first = calls_;
  const RobotResult second = run();
  EXPECT_EQ(calls_, 2 * 3u + 3u) << "after " << first << " in the first run";
  EXPECT_GT(first, calls_);
  for (const ElementReport& row : second.report.links) {
    if (row.cached) {
      EXPECT_EQ(row.seconds.repair + row.seconds.decompose + row.seconds.certify, 0);
    }
  }
}

// A run must return what it finds: here a valid entry with changed content.
TEST_F(CachedRun, UsesTheContentOfEntries) {
  const RobotResult first = run();
  MeshTask channel;
  channel.file = "channel.obj";
  channel.sha256 = first.report.links[1].sha256;
  const std::string key = meshKey(channel, options_, options_.seed);
  Cache cache(this->cache());
  MeshResult forged = cache.findMesh(key, channel.sha256).value();
  forged.reason = "forged";
  cache.storeMesh(key, forged);
  EXPECT_EQ(run().report.links[1].reason, "forged");
}

// The attacks change what entries hold, as someone can who writes to the folder but does not know its key.

TEST_F(CachedRun, HullsOfAnotherMesh) {
  const json sound = timeless(run());
  const auto files = files_;
  const std::vector<std::string> names = meshEntries();
  ASSERT_EQ(names.size(), 2u);
  std::string forged = fixtures::read(cache() / names[0]);
  for (const std::string& name : names) forged = std::regex_replace(forged, std::regex(name), names[1]);
  fixtures::write(cache() / names[1], forged);
  expectNoticed(sound, 1);
  EXPECT_EQ(files_, files);
}

TEST_F(CachedRun, EntriesSealedWithAnotherKey) {
  const json sound = timeless(run());
  const auto files = files_;
  const TempFolder attacker;
  CacheFolder own(cache(), Cache::kMostBytes), other(attacker.path(), Cache::kMostBytes);
  const std::vector<std::string> names = meshEntries();
  const std::string smallest = own.find(names[0]).value();
  for (const std::string& name : names) {
    other.store(name, smallest);
    fs::copy_file(attacker / name, cache() / name, fs::copy_options::overwrite_existing);
  }
  expectNoticed(sound, 2);
  EXPECT_EQ(files_, files);
}

TEST_F(CachedRun, EntriesOfOtherOptions) {
  const json sound = timeless(run());
  const auto files = files_;
  std::map<std::string, std::string> old;
  for (const std::string& name : meshEntries()) old[name] = fixtures::read(cache() / name);
  fs::remove_all(cache());
  options_.method = Method::kBoundingBox;
  run();
  const std::vector<std::string> replayed = meshEntries();
  options_ = Options();
  ASSERT_EQ(replayed.size(), old.size());
  for (auto [name, i] = std::pair(old.begin(), std::size_t{0}); name != old.end(); ++name, ++i)
    fs::copy_file(cache() / replayed[i], cache() / name->first);
  expectNoticed(sound, 2);
  EXPECT_EQ(files_, files);
}

TEST_F(CachedRun, AFolderThatOthersCanWrite) {
  const json sound = timeless(run());
  const auto before = entries();
  fs::permissions(cache(), fs::perms::others_write, fs::perm_options::add);
  const RobotResult result = run();
  EXPECT_EQ(cachedRows(result), kNone);
  ASSERT_EQ(result.report.notes.size(), sound["notes"].size() + 1);
  EXPECT_NE(result.report.notes[0].find("chmod go-w"), std::string::npos) << result.report.notes[0];
  EXPECT_EQ(entries(), before);
}

TEST_F(CachedRun, OtherOptionsHaveOtherEntries) {
  run();
  const std::vector<std::function<void(Options&)>> changes = {
      [](Options& o) { o.tolerance = shareOf(0.03); }, [](Options& o) { o.method = Method::kSingleHull; },
      [](Options& o) { o.effort = Effort::kBest; },    [](Options& o) { o.max_hulls = 1; },
      [](Options& o) { o.max_vertices = 8; },          [](Options& o) { o.seed = 2; }};
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

TEST_F(CachedRun, AnotherToleranceIsCutFromTheSameTree) {
  options_.tree = shareOf(0.005);
  const auto trees = [&] {
    std::set<std::string> names;
    for (const auto& [name, bytes] : entries())
      if (fs::path(name).extension() == ".tree") names.insert(name);
    return names;
  };
  run();
  const std::set<std::string> known = trees();
  EXPECT_EQ(known.size(), 2u) << "of the bracket and of the channel";
  options_.tolerance = shareOf(0.02);
  const RobotResult second = run();
  EXPECT_EQ(cachedRows(second), kNone);
  EXPECT_EQ(trees(), known);
  for (const ElementReport& row : second.report.links) {
    if (row.status == Status::kFailed) continue;
    EXPECT_EQ(row.status, Status::kOk) << row.reason;
    EXPECT_EQ(row.uncovered, 0);
    EXPECT_LE(row.protrusion, row.tolerance);
    EXPECT_EQ(row.hulls, row.link == "b" ? 3u : 2u);
  }
  const auto files = files_;
  options_.cache = false;
  EXPECT_EQ(timeless(run())["links"], timeless(second)["links"]);
  EXPECT_EQ(files_, files) << "the tree must be built again";
}

TEST_F(CachedRun, CutsATreeToTheCaps) {
  options_.tree = shareOf(0.005);
  options_.max_hulls = 1;
  const RobotResult result = run();
  EXPECT_GT(totals(result.report).degraded, 1u);
  for (const ElementReport& row : result.report.links) {
    if (row.status == Status::kFailed) continue;
    EXPECT_EQ(row.hulls, 1u);
    EXPECT_EQ(row.status, Status::kDegraded);
    EXPECT_NE(row.reason.find("max-hulls 1"), std::string::npos) << row.reason;
  }
}

TEST_F(CachedRun, AnotherMeshOfTheSameNameHasAnotherEntry) {
  run();
  fixtures::write(folder_ / "meshes/channel.obj", fixtures::obj(test_shapes::uChannel(0.2, 0.2, 0.03, 0.4)));
  const RobotResult result = run();
  EXPECT_EQ(cachedRows(result), (std::vector<bool>{true, false, false, true}));
  EXPECT_FALSE(result.report.validation_cached);
}

// The digest is computed at the start; content read later must not be stored under it.
TEST_F(CachedRun, MeshThatChangesDuringTheRun) {
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
  EXPECT_NE(changed.report.links[1].reason.find("channel.obj' changed"), std::string::npos) << changed.report.links[1].reason;
  fixtures::write(channel, before);
  const RobotResult again = run();
  EXPECT_EQ(cachedRows(again), (std::vector<bool>{true, false, false, true}));
  EXPECT_NE(again.report.links[1].status, Status::kFailed) << again.report.links[1].reason;
}

TEST_F(CachedRun, MovedMeshNeedsOnlyAnotherValidation) {
  run();
  std::string moved = description();
  moved.replace(moved.find("xyz=\"0 0 0.5\""), 13, "xyz=\"0 0 0.6\"");
  fixtures::write(folder_ / "urdf/arm.urdf", moved);
  const RobotResult result = run();
  EXPECT_EQ(cachedRows(result), kAll);
  EXPECT_FALSE(result.report.validation_cached);
}

TEST_F(CachedRun, ComputesDamagedEntriesAgain) {
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

TEST_F(CachedRun, UnwritableFolderGivesANote) {
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

// What a time limit cut short is neither kept nor taken for what a run without one finds, and says so.
TEST_F(CachedRun, NothingThatTimeCutShort) {
  options_.cache = false;
  const json free = timeless(run());
  options_.cache = true;
  options_.time_limit = 1e-9;
  const RobotResult cut = run();
  EXPECT_EQ(cut.report.links[1].hulls, 1u);
  EXPECT_EQ(cut.report.links[1].status, Status::kDegraded);
  EXPECT_NE(cut.report.links[1].untried, "");
  const auto says = [](const RobotResult& result) {
    return std::count_if(result.report.notes.begin(), result.report.notes.end(), [](const std::string& note) {
      return note.find("the time limit ended the search for 3 of 4 meshes") != std::string::npos;
    });
  };
  EXPECT_EQ(says(cut), 1);
  EXPECT_EQ(cut.report.validation.missed, 0);
  EXPECT_EQ(entries().size(), 0u);
  options_.time_limit = 0;
  EXPECT_EQ(timeless(run()), free);
  options_.time_limit = 1e-9;
  const RobotResult known = run();
  EXPECT_EQ(cachedRows(known), kAll) << "what is known takes no time";
  EXPECT_EQ(says(known), 0);
}

// Whenever time ends: a row that lacks nothing is that of a run without a limit.
TEST_F(CachedRun, WhatLacksNothingIsWhole) {
  options_.cache = false;
  const RobotResult free = run();
  const auto all = [](const ElementReport& row) {
    return std::make_tuple(row.hulls, row.least_hulls, row.protrusion, row.status, row.hull_vertices);
  };
  double seconds = 0;
  for (const ElementReport& row : free.report.links) seconds += row.seconds.decompose + row.seconds.certify;
  for (int i = 1; i <= 20; ++i) {
    options_.time_limit = seconds * i / 20;
    const RobotResult cut = run();
    for (std::size_t row = 0; row < cut.report.links.size(); ++row) {
      if (!cut.report.links[row].untried.empty()) continue;
      EXPECT_EQ(all(cut.report.links[row]), all(free.report.links[row])) << i;
    }
  }
}

}  // namespace
}  // namespace collision_hulls
