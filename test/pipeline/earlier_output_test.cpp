// Two runs, the second on the result of the first: nothing that is still in use may be lost.
#include "pipeline/earlier_output.h"

#include <gtest/gtest.h>

#include <regex>

#include "base/roots.h"
#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/pipeline/output.h"
#include "counted_looks.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using fixtures::link;
using fixtures::meshTag;

std::string withoutCollisions(const std::string& urdf) {
  return std::regex_replace(urdf, std::regex("\\s*<collision[^]*?</collision>"), "");
}

class TwoRuns : public ::testing::TestWithParam<UriStyle> {
 protected:
  TwoRuns() {
    fixtures::write(folder_ / "meshes/box.obj", fixtures::obj(test_shapes::box(0.1, 0.2, 0.3)));
    fixtures::write(folder_ / "meshes/bracket.obj", fixtures::obj(test_shapes::lBracket(0.2, 0.03, 0.1)));
    options_.uri = GetParam();
    options_.validate = false;
  }

  std::string element(const std::string& kind, const std::string& mesh) {
    return "    <" + kind + "><origin xyz=\"0 0 1\"/>" + meshTag(folder_ / ("meshes/" + mesh)) + "</" + kind + ">\n";
  }

  RobotResult run(const std::string& urdf, const std::string& output) {
    RobotResult result = decomposeRobot(readRobotDescription(urdf), defaultPackageFinder(urdf), options_, folder_ / output);
    writeOutput(result, folder_ / output);
    return result;
  }

  /// All links, into `first`.
  void runFirst() {
    run(fixtures::write(folder_ / "urdf/arm.urdf",
                        fixtures::robot("arm", link("base", element("visual", "bracket.obj") + element("collision", "bracket.obj")) +
                                                   link("tip", element("visual", "box.obj") + element("collision", "box.obj"), "base"))),
        "first");
  }

  /// The meshes of an output's <collision> elements, which all lie in it.
  std::vector<std::string> meshes(const std::string& output) {
    const std::string urdf = folder_ / (output + "/urdf/arm.urdf");
    std::vector<std::string> contents;
    for (const LinkDescription& link : readRobotDescription(urdf).links) {
      for (const GeometryElement& collision : link.collisions) {
        const std::string file = resolveUri(collision.uri, urdf, defaultPackageFinder(urdf));
        EXPECT_EQ(file.rfind(folder_ / output, 0), 0u) << file;
        contents.push_back(link.name + fixtures::read(file));
      }
    }
    return contents;
  }

  fixtures::TempFolder folder_;
  Options options_;
};

INSTANTIATE_TEST_SUITE_P(UriStyles, TwoRuns, ::testing::Values(UriStyle::kPackage, UriStyle::kFile, UriStyle::kRelative));

TEST_P(TwoRuns, HullsThatStayComeAlong) {
  for (const std::string output : {"second", "first"}) {
    runFirst();
    const std::vector<std::string> before = meshes("first");
    const std::string text = fixtures::read(folder_ / "first/urdf/arm.urdf");
    options_.links = "base";
    options_.source = Source::kVisual;
    const RobotResult result = run(folder_ / "first/urdf/arm.urdf", output);
    options_.links.clear();
    if (output != "first") fs::remove_all(folder_ / "first");
    const std::vector<std::string> after = meshes(output);
    ASSERT_EQ(after.size(), before.size());
    EXPECT_TRUE(after.back() == before.back()) << "the hull of tip";
    EXPECT_EQ(withoutCollisions(result.urdf), withoutCollisions(text));
    EXPECT_NE(result.urdf.find("name=\"tip_0_0\""), std::string::npos);
    ASSERT_EQ(result.kept_files.count("meshes/tip/0_0.stl"), 1u);
    EXPECT_EQ(std::count(result.report.files.begin(), result.report.files.end(), "meshes/tip/0_0.stl"), 1);
    EXPECT_NE(toTable(result.report).find("1 hull of an earlier run"), std::string::npos);
    // A third run finds them again.
    options_.links = "base";
    run(folder_ / (output + "/urdf/arm.urdf"), "third");
    EXPECT_TRUE(meshes("third").back() == before.back());
    options_.links.clear();
    options_.source = Source::kAuto;
  }
}

TEST_P(TwoRuns, AKeptHullWhosePlaceIsTaken) {
  runFirst();
  fixtures::write(folder_ / "first/meshes/tip/0_0.stl", "no mesh");
  std::string urdf = fixtures::read(folder_ / "first/urdf/arm.urdf");
  const std::size_t end = urdf.rfind("</collision>") + 12;
  urdf.insert(end, element("collision", "box.obj"));
  fixtures::write(folder_ / "first/urdf/arm.urdf", urdf);
  const RobotResult result = run(folder_ / "first/urdf/arm.urdf", "second");
  const std::vector<ElementReport>& rows = result.report.links;
  EXPECT_EQ(rows[rows.size() - 2].status, Status::kFailed);
  EXPECT_EQ(rows.back().files, (std::vector<std::string>{"meshes/tip/1_0.stl"}));
  EXPECT_EQ(result.kept_files, (std::map<std::string, std::string>{{"meshes/tip/0_0.stl", "no mesh"}}));
  const auto places = keptHulls(readRobotDescription(folder_ / "first/urdf/arm.urdf"), {"base"}, {"meshes/Tip/0_0.obj"}, folder_ / "second",
                                defaultPackageFinder(folder_ / "first/urdf/arm.urdf"));
  ASSERT_EQ(places.contents.size(), 1u);
  EXPECT_EQ(places.contents.begin()->first, "meshes/tip/0_0_2.stl");
}

TEST_P(TwoRuns, ADescriptionThatWasMovedAway) {
  runFirst();
  fs::create_directories(folder_ / "elsewhere");
  fs::copy(folder_ / "first/urdf/arm.urdf", folder_ / "elsewhere/arm.urdf");
  options_.links = "base";
  options_.source = Source::kVisual;
  const RobotDescription robot = readRobotDescription(folder_ / "elsewhere/arm.urdf");
  const RobotResult result = decomposeRobot(robot, PackageFinder(), options_, folder_ / "first");
  EXPECT_EQ(result.kept_files.count("meshes/tip/0_0.stl"), 1u);
}

// The file:// URIs in it name a folder that is not there any more.
TEST_P(TwoRuns, AnOutputThatWasMoved) {
  runFirst();
  const std::vector<std::string> before = meshes("first");
  fs::rename(folder_ / "first", folder_ / "moved");
  options_.links = "base";
  options_.source = Source::kVisual;
  run(folder_ / "moved/urdf/arm.urdf", "moved");
  EXPECT_TRUE(meshes("moved").back() == before.back());
}

TEST_P(TwoRuns, AHullThatIsALink) {
  runFirst();
  const std::string hull = folder_ / "first/meshes/tip/0_0.stl", content = fixtures::read(hull);
  fs::rename(hull, folder_ / "kept.stl");
  fs::create_symlink(folder_ / "kept.stl", hull);
  options_.links = "base";
  options_.source = Source::kVisual;
  run(folder_ / "first/urdf/arm.urdf", "first");
  EXPECT_TRUE(fixtures::read(hull) == content);
}

// As the node gets it once a launch file loads the output: a text, without its file or with that of the original.
TEST_P(TwoRuns, AnOutputThatIsDecomposedAgainIsNoted) {
  runFirst();
  const std::string file = folder_ / "first/urdf/arm.urdf", text = fixtures::read(file);
  const auto noted = [&](const std::string& urdf, const std::string& path) {
    const auto find_package = [&](const std::string&) { return std::optional<std::string>(folder_ / "first"); };
    const RobotResult result = decomposeRobot(parseRobotDescription(urdf, path), PackageFinder(find_package), options_, folder_ / "second");
    const std::string table = toTable(result.report), again = "the output of an earlier run: bounds are measured from its hulls";
    return table.find(again) == std::string::npos ? "" : table.substr(table.find("note: "));
  };
  EXPECT_NE(noted(text, file).find("'" + file + "' is the output"), std::string::npos);
  const std::string in_folder = "the description has <collision> meshes in '" + (folder_ / "first") + "', the output";
  for (const std::string& path : {std::string(), std::string(folder_ / "elsewhere/urdf/arm.urdf")}) {
    if (GetParam() == UriStyle::kRelative) break;  // then its meshes are not found
    EXPECT_NE(noted(text, path).find(in_folder), std::string::npos) << path;
  }
  EXPECT_EQ(noted(fixtures::read(folder_ / "urdf/arm.urdf"), ""), "") << "its meshes are no hulls";
  options_.source = Source::kVisual;
  options_.links = "tip";
  EXPECT_EQ(noted(text, file), "") << "what is decomposed is no hull";
}

TEST_P(TwoRuns, RefusesToLoseAVisual) {
  runFirst();
  const std::string hull = folder_ / "first/meshes/tip/0_0.stl";
  const std::string urdf =
      fixtures::write(folder_ / "urdf/two.urdf", fixtures::robot("arm", link("base", "    <visual>" + meshTag(hull) + "</visual>\n")));
  try {
    run(urdf, "first");
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kUnwritableOutput);
    for (const std::string& part : {hull, std::string("'base'"), std::string("choose another output")})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
  EXPECT_TRUE(fs::exists(hull));
  EXPECT_NO_THROW(run(urdf, "second"));
}

TEST_P(TwoRuns, RefusesToReplaceWhatHullsWouldBeMadeFrom) {
  runFirst();
  const std::string hull = folder_ / "first/meshes/base/0_0.stl", content = fixtures::read(hull);
  const auto refused = [&] {
    try {
      run(folder_ / "first/urdf/arm.urdf", "first");
      return std::string("accepted");
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kUnwritableOutput);
      return std::string(error.what());
    }
  };
  for (const std::string& part : {folder_ / "first", std::string("meshes/base/0_0.stl"), std::string("'base'"),
                                  std::string("decompose the description that it was made from, or choose another output")})
    EXPECT_NE(refused().find(part), std::string::npos) << refused();
  EXPECT_TRUE(fixtures::read(hull) == content);
  options_.links = "tip";
  EXPECT_NE(refused().find("'tip'"), std::string::npos) << refused();
}

/// A description that names two hulls of an earlier output.
class KeptHullsTest : public ::testing::Test {
 protected:
  KeptHullsTest() {
    for (const std::string file : {"a", "b"}) fixtures::write(hull(file), file);
    writeReport("out/report.json", "");
    std::string collisions;
    for (const std::string& uri : {hull("a"), "file://" + hull("a"), hull("b")})
      collisions += "<collision>" + meshTag(uri) + "</collision>";
    robot_ = readRobotDescription(fixtures::write(folder_ / "arm.urdf", fixtures::robot("arm", link("base", collisions))));
  }

  std::string hull(const std::string& name) const { return folder_ / ("out/meshes/" + name + ".stl"); }
  void writeReport(const std::string& file, const std::string& above) {
    fixtures::write(folder_ / file,
                    R"({"collision_hulls": "1", "links": [], "files": [")" + above + R"(meshes/a.stl", ")" + above + R"(meshes/b.stl"]})");
  }
  KeptHulls kept(const RunControl& control = {}) const { return keptHulls(robot_, {}, {}, folder_ / "new", PackageFinder(), control); }

  const fixtures::TempFolder folder_;
  RobotDescription robot_;
};

TEST_F(KeptHullsTest, AFileOfTwoNamesIsKeptOnce) {
  const KeptHulls all = kept();
  EXPECT_EQ(all.places.size(), 3u);
  EXPECT_EQ(all.contents, (std::map<std::string, std::string>{{"meshes/a.stl", "a"}, {"meshes/b.stl", "b"}}));
}

TEST_F(KeptHullsTest, TheirSumIsLimited) {
  constexpr std::uintmax_t kMost = std::uintmax_t{1} << 30;
  fs::resize_file(hull("b"), kMost);  // with a hole; alone it would do
  try {
    kept();
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kTooLarge);
    for (const std::string& part : {hull("b"), std::to_string(kMost), std::to_string(kMost + 1), std::string("decompose their links")})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST_F(KeptHullsTest, ACancelIsHeededAtEachElementAndFile) {
  const auto work = [&](const RunControl& control) { kept(control); };
  EXPECT_GE(looksOf(work), 6u) << "three elements, two hulls, a report";
  for (const std::size_t at : {1, 3, 5}) EXPECT_EQ(looksAfterCancel(at, work), 1u);
  EXPECT_EQ(looksAfterCancel(1,
                             [&](const RunControl& control) {
                               fs::create_directory(folder_ / "new");
                               RobotDescription robot = robot_;
                               robot.links[0].visuals = robot.links[0].collisions;
                               refuseLosingOriginals(robot, {}, folder_ / "new", PackageFinder(), control);
                             }),
            1u);
}

TEST_F(KeptHullsTest, AReportAboveTheRootCountsForNothing) {
  fs::remove(folder_ / "out/report.json");
  writeReport("report.json", "out/");
  EXPECT_EQ(kept().contents.size(), 2u);
  const std::string root = folder_ / "out";
  const Confinement confinement({{root}, {root}, {}, {}, "", ""});
  EXPECT_TRUE(kept().places.empty());
}

TEST(RefuseLosingCache, ACacheInTheOutput) {
  const fixtures::TempFolder folder;
  fs::create_directory_symlink(folder.path(), folder / "link");
  const std::string before = fixtures::OwnCache::listener()->path();
  const auto check = [&](const std::string& cache, bool is_used) {
    Options options;
    options.cache = is_used;
    setenv("COLLISION_HULLS_CACHE", (folder / cache).c_str(), 1);
    refuseLosingCache(options, folder / "out");
  };
  for (const char* within : {"out", "out/cache", "link/out/cache"}) {
    try {
      check(within, true);
      ADD_FAILURE() << within;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kUnwritableOutput);
      for (const std::string& part :
           {"the cache '" + (folder / "out"), "lies in output '" + (folder / "out'"), std::string("set COLLISION_HULLS_CACHE")})
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    EXPECT_NO_THROW(check(within, false));
  }
  for (const char* beside : {"output", "cache"}) EXPECT_NO_THROW(check(beside, true)) << beside;
  setenv("COLLISION_HULLS_CACHE", before.c_str(), 1);
}

TEST(RefuseLosingInput, AMeshInTheOutput) {
  const fixtures::TempFolder folder;
  const std::string mesh = fixtures::write(folder / "out/hull_0.stl", "");
  EXPECT_THROW(refuseLosingInput(mesh, folder / "out"), Error);
  EXPECT_NO_THROW(refuseLosingInput(mesh, folder / "other"));
  EXPECT_NO_THROW(refuseLosingInput(mesh, folder / "out/other"));
}

}  // namespace
}  // namespace collision_hulls
