// Cover and protrusion of descriptions against closed forms, what only one side has, and the queries.
// Also tests src/verify/compare_link.cpp and src/verify/verify_report.cpp.
#include "collision_hulls/verify/verify.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "collision_hulls/error.h"
#include "counted_looks.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using test_shapes::box;
using test_shapes::lBracket;
using test_shapes::merged;
using test_shapes::moved;
using test_shapes::uChannel;

class Verify : public ::testing::Test {
 protected:
  std::string mesh(const std::string& name, const TriangleMesh& content) {
    return fixtures::meshTag(fixtures::write(folder_ / name, fixtures::obj(content)));
  }
  static std::string primitive(const std::string& tag) { return "<geometry><" + tag + "/></geometry>"; }
  static std::string visual(const std::string& geometry) { return "<visual>" + geometry + "</visual>"; }
  static std::string collision(const std::string& geometry, const std::string& origin = "") {
    return "<collision>" + origin + geometry + "</collision>";
  }
  static Description robot(const std::string& links) { return {parseRobotDescription(fixtures::robot("r", links)), PackageFinder()}; }
  static LinkVerification only(const Verification& seen) {
    EXPECT_EQ(seen.links.size(), 1u);
    return seen.links.at(0);
  }
  /// One link that looks like the first and collides like the second.
  LinkVerification measured(const std::string& look, const std::string& model, const VerifyOptions& options = {}) {
    const Description both = robot(fixtures::link("part", visual(look) + collision(model)));
    const Verification seen = verify(both, both, options);
    EXPECT_EQ(seen.contradictions, 0u);
    return only(seen);
  }
  static void expectNear(const Largest& largest, double value, double slack) {
    constexpr double kSinglePrecision = 1e-7;  // of the files
    EXPECT_GE(largest.bound, value - kSinglePrecision);
    EXPECT_LE(largest.bound, value + slack);
    EXPECT_LE(largest.found, value + kSinglePrecision);
    EXPECT_GE(largest.found, value - slack);
    EXPECT_LE(largest.found, largest.bound);
  }

  fixtures::TempFolder folder_;
};

TEST_F(Verify, AHullShrunkByATenthIsFoundOut) {
  const TriangleMesh cube = moved(box(0.2, 0.2, 0.2), {-0.1, -0.1, -0.1});
  TriangleMesh shrunk = cube;
  for (Eigen::Vector3d& v : shrunk.vertices) v *= 0.9;
  const std::string look = mesh("cube.obj", cube);
  VerifyOptions options;
  options.max_uncovered = 0;
  const Description good = robot(fixtures::link("part", visual(look) + collision(mesh("same.obj", test_shapes::subdivided(cube, 2)))));
  const Description bad = robot(fixtures::link("part", collision(mesh("shrunk.obj", shrunk))));
  EXPECT_TRUE(passed(verify(good, good, options), options));
  const Verification seen = verify(good, bad, options);
  EXPECT_FALSE(passed(seen, options));
  EXPECT_EQ(only(seen).status, LinkStatus::kOver);
  expectNear(only(seen).uncovered, 0.01 * std::sqrt(3.0), 3e-4);
  EXPECT_DOUBLE_EQ(only(seen).uncovered_share, 1);
  expectNear(only(seen).protrusion, 0, 1e-4);
  EXPECT_GT(seen.missed, 0u);
  EXPECT_EQ(seen.phantom, 0u);
}

TEST_F(Verify, ALargerBoxProtrudesByItsCorner) {
  const LinkVerification row =
      measured(mesh("cube.obj", moved(box(0.2, 0.2, 0.2), {-0.1, -0.1, -0.1})), primitive("box size='0.22 0.22 0.22'"));
  EXPECT_EQ(row.uncovered.bound, 0);
  EXPECT_EQ(row.uncovered_share, 0);
  expectNear(row.protrusion, 0.01 * std::sqrt(3.0), 3e-4);
  EXPECT_EQ(row.missed, 0u);
  EXPECT_GT(row.phantom, 0u);
}

/// Cubes of 0.2 m in a row; the gap between their middles is `apart`. Links next to each other are joined.
std::string rowOfLinks(const std::string& visual, const std::string& collision, const std::vector<std::string>& names, double apart) {
  std::string links;
  for (std::size_t i = 0; i < names.size(); ++i) {
    links += "<link name='" + names[i] + "'>" + visual + collision + "</link>";
    if (i == 0) continue;
    links += "<joint name='to_" + names[i] + "' type='prismatic'><parent link='" + names[i - 1] + "'/><child link='" + names[i] +
             "'/><origin xyz='" + std::to_string(apart) + " 0 0'/><axis xyz='0 0 1'/>" +
             "<limit lower='-0.01' upper='0.01' effort='1' velocity='1'/></joint>";
  }
  return links;
}

TEST_F(Verify, NamesThePairsOfLinksThatTouchWhereTheOriginalsDoNot) {
  const std::string look = visual(primitive("box size='0.2 0.2 0.2'")), model = collision(primitive("box size='0.22 0.22 0.22'"));
  VerifyOptions options;
  options.configurations = 50;
  const Description row = robot(rowOfLinks(look, model, {"a", "b", "c", "d"}, 0.105));
  const Verification seen = verify(row, row, options);
  ASSERT_EQ(seen.pairs.size(), 2u) << "those next but one to each other; a and d are far apart, the others are joined";
  EXPECT_EQ(seen.pairs[0].first + seen.pairs[0].second + seen.pairs[1].first + seen.pairs[1].second, "acbd");
  EXPECT_EQ(seen.pairs[0].queries, 50u);
  EXPECT_EQ(seen.pairs[0].hits, 0u);
  EXPECT_EQ(seen.pairs[0].phantom, 50u);
  const std::string table = toTable(seen);
  for (const char* part :
       {"false collisions: 'a' and 'c' collide in RESULT in 50 of the 50 configurations in which they do not collide in ORIGINAL\n",
        "false collisions: give these links a tighter model (decompose: a lower tolerance; fit_scene: a smaller clearance); or disable a "
        "pair, if it never collides in ORIGINAL\n"})
    EXPECT_NE(table.find(part), std::string::npos) << table;
  for (const char* other : {"missed: ", "phantom"}) EXPECT_EQ(table.find(other), std::string::npos) << table;
  const nlohmann::json json = nlohmann::json::parse(toJson(seen, options, "", ""));
  const nlohmann::json expected = {{"first", "a"}, {"second", "c"}, {"queries", 50}, {"hits", 0}, {"missed", 0}, {"phantom", 50}};
  EXPECT_EQ(json["pairs"][0], expected);
}

TEST_F(Verify, NamesThePairsOfLinksThatDoNotTouchWhereTheOriginalsDo) {
  const std::string look = visual(primitive("box size='0.22 0.22 0.22'")), model = collision(primitive("box size='0.2 0.2 0.2'"));
  VerifyOptions options;
  options.configurations = 50;
  const Description row = robot(rowOfLinks(look, model, {"a", "b", "c"}, 0.105));
  const Verification seen = verify(row, row, options);
  const std::string table = toTable(seen);
  EXPECT_NE(table.find("missed: 'a' and 'c' do not collide in RESULT in 50 of the 50 configurations in which they collide in ORIGINAL\n"),
            std::string::npos)
      << table;
  EXPECT_EQ(table.find("false collisions: "), std::string::npos) << table;
  EXPECT_EQ(fixtures::count(table, "  ok, but misses\n"), 3u) << "each of them misses boxes, too\n" << table;
  EXPECT_EQ(seen.links[0].status, LinkStatus::kOk) << "there is no gate";
  const std::string note =
      " collisions were missed, and no gate limits how much of ORIGINAL is uncovered: set --max-uncovered, 0 for cover without a gap";
  ASSERT_EQ(seen.notes.size(), 1u);
  EXPECT_EQ(seen.notes[0], std::to_string(seen.missed) + note);
  options.max_uncovered = 0.1;
  EXPECT_TRUE(verify(row, row, options).notes.empty()) << "there is a gate";
}

TEST(VerifyTable, NamesTenPairsThoseWithMostFirst) {
  Verification seen;
  for (std::size_t i = 0; i < 12; ++i) seen.pairs.push_back({"a", "b" + std::to_string(i), 100, i, 0, i + 1});
  const std::string table = toTable(seen);
  EXPECT_EQ(fixtures::count(table, " collide in RESULT in "), 10u) << table;
  EXPECT_LT(table.find("'b11' collide in RESULT in 12 of the 89 configurations"),
            table.find("'b10' collide in RESULT in 11 of the 90 configurations"));
  EXPECT_EQ(table.find("'b1' "), std::string::npos) << table;
  EXPECT_NE(table.find("false collisions: 2 more pairs of links, which --json lists\n"), std::string::npos) << table;
}

TEST_F(Verify, GatesAreInclusiveAndEachIsItsOwn) {
  const TriangleMesh cube = moved(box(0.2, 0.2, 0.2), {-0.1, -0.1, -0.1});
  VerifyOptions options;
  options.max_uncovered = 0;
  options.max_protrusion = 0.018;
  EXPECT_EQ(measured(mesh("cube.obj", cube), primitive("box size='0.22 0.22 0.22'"), options).status, LinkStatus::kOk);
  options.max_protrusion = 0.017;
  const LinkVerification over = measured(mesh("cube.obj", cube), primitive("box size='0.22 0.22 0.22'"), options);
  EXPECT_EQ(over.status, LinkStatus::kOver);
  EXPECT_NE(over.reason.find("protrudes by up to 17.3"), std::string::npos) << over.reason;
  EXPECT_NE(over.reason.find("allowed 17 mm"), std::string::npos) << over.reason;
}

TEST_F(Verify, AMeshIsNotTakenForItsHull) {
  const TriangleMesh channel = uChannel(0.2, 0.2, 0.02, 0.3);
  const LinkVerification same = measured(mesh("u.obj", channel), mesh("finer.obj", test_shapes::subdivided(channel, 2)));
  EXPECT_EQ(same.hulls, 0u);
  EXPECT_EQ(same.meshes, 1u);
  EXPECT_LE(same.uncovered.bound, 1e-4);
  EXPECT_LE(same.protrusion.bound, 1e-4);
  EXPECT_EQ(same.phantom, 0u);
  const LinkVerification hulled = measured(mesh("u.obj", channel), mesh("hull.obj", surface(convexHull(channel.vertices))));
  EXPECT_EQ(hulled.hulls, 1u);
  EXPECT_EQ(hulled.uncovered.bound, 0);
  EXPECT_GT(hulled.protrusion.found, 0.05);
  EXPECT_GT(hulled.phantom, 0u);
}

TEST_F(Verify, AShiftedMeshLeavesAndCoversByTheShift) {
  const TriangleMesh channel = uChannel(0.2, 0.2, 0.02, 0.3);
  const LinkVerification row = measured(mesh("u.obj", channel), mesh("up.obj", moved(channel, {0, 0, 0.005})));
  expectNear(row.uncovered, 0.005, 1e-4);
  expectNear(row.protrusion, 0.005, 1e-4);
}

TEST_F(Verify, AShellCountsAsASolidWhereItsOpeningsAreClosed) {
  const std::string look = mesh("pipe.obj", test_shapes::pipe(0.1, 0.4, 32));
  const std::string rod = mesh("rod.obj", surface(convexHull(test_shapes::pipe(0.1, 0.4, 32).vertices)));
  const double to_axis = 0.1 * std::cos(test_shapes::kPi / 32);  // from the skin
  expectNear(measured(look, rod).protrusion, to_axis, 0.01);
  VerifyOptions options;
  options.close_openings = 0.21;
  expectNear(measured(look, rod, options).protrusion, 0, 1e-4);
  options.close_openings = 0.19;
  expectNear(measured(look, rod, options).protrusion, to_axis, 0.01);
}

TEST_F(Verify, ManyHullsInOneFileCountAsHulls) {
  const TriangleMesh bracket = lBracket(0.2, 0.03, 0.1);
  const TriangleMesh hulls = merged({box(0.2, 0.03, 0.1), box(0.03, 0.2, 0.1)});
  const LinkVerification row = measured(mesh("l.obj", bracket), mesh("hulls.obj", hulls));
  EXPECT_EQ(row.hulls, 2u);
  EXPECT_EQ(row.meshes, 0u);
  EXPECT_EQ(row.uncovered.bound, 0);
  expectNear(row.protrusion, 0, 1e-4);
}

TEST_F(Verify, RoundPrimitivesCoverExactly) {
  const std::string cube = mesh("cube.obj", moved(box(0.1, 0.1, 0.1), {-0.05, -0.05, -0.05}));
  const double out = 0.05 * std::sqrt(3.0);
  const LinkVerification row = measured(cube, primitive("sphere radius='0.0867'"));  // the corners are at 0.0866
  EXPECT_EQ(row.primitives, 1u);
  EXPECT_EQ(row.uncovered.bound, 0);
  expectNear(row.protrusion, 0.0867 - 0.05, 0.004 * 0.0867 + 4e-4);
  expectNear(measured(cube, primitive("sphere radius='0.08'")).uncovered, out - 0.08, 1e-4);
  expectNear(measured(cube, primitive("cylinder radius='0.06' length='0.1'")).uncovered, 0.05 * std::sqrt(2.0) - 0.06, 1e-4);
}

TEST_F(Verify, RoundOriginalsHaveAStatedError) {
  const std::string ball = primitive("sphere radius='0.1'");
  EXPECT_EQ(measured(ball, primitive("box size='0.2 0.2 0.2'")).uncovered.bound, 0);
  expectNear(measured(ball, primitive("sphere radius='0.09'")).uncovered, 0.01, 1e-3);
  expectNear(measured(ball, primitive("box size='0.3 0.3 0.3'")).protrusion, 0.15 * std::sqrt(3.0) - 0.1, 2e-3);
}

TEST_F(Verify, WhatBothSidesHoldEquallyIsExact) {
  for (const std::string& geometry : {primitive("sphere radius='0.1'"), primitive("cylinder radius='0.1' length='0.3'"),
                                      primitive("box size='0.1 0.2 0.3'"), mesh("l.obj", lBracket(0.2, 0.03, 0.1))}) {
    const LinkVerification row = measured(geometry, geometry);
    EXPECT_EQ(row.uncovered.bound, 0) << geometry;
    EXPECT_EQ(row.protrusion.bound, 0) << geometry;
  }
}

TEST_F(Verify, ScaleAndOriginApply) {
  const std::string look = mesh("cube.obj", moved(box(0.2, 0.2, 0.2), {-0.1, -0.1, -0.1}));
  std::string big = mesh("big.obj", moved(box(200, 200, 200), {-100, -100, -100}));
  big.replace(big.find("/></geometry>"), 2, " scale='0.001 0.001 0.001'/>");
  const Description both =
      robot(fixtures::link("part", visual(look) + collision(big, "<origin xyz='0 0 0.01' rpy='0 0 1.5707963267948966'/>")));
  const LinkVerification row = only(verify(both, both, {}));
  expectNear(row.uncovered, 0.01, 1e-4);
  expectNear(row.protrusion, 0.01, 1e-4);
}

TEST_F(Verify, WhatOneSideLacksIsARow) {
  const std::string cube = visual(primitive("box size='1 1 1'")), model = collision(primitive("box size='1 1 1'"));
  const Description original = robot(fixtures::link("a", cube) + fixtures::link("b", cube, "a") + fixtures::link("c", "", "a"));
  const Description result = robot(fixtures::link("a", model) + fixtures::link("c", model, "a") + fixtures::link("d", model, "a"));
  VerifyOptions options;
  const Verification seen = verify(original, result, options);
  std::map<std::string, LinkStatus> status;
  for (const LinkVerification& row : seen.links) status[row.link] = row.status;
  const std::map<std::string, LinkStatus> expected = {
      {"a", LinkStatus::kOk}, {"b", LinkStatus::kMissing}, {"c", LinkStatus::kAdded}, {"d", LinkStatus::kAdded}};
  EXPECT_EQ(status, expected);
  EXPECT_TRUE(passed(seen, options));
  options.max_uncovered = 1;
  EXPECT_FALSE(passed(seen, options));
  options = {};
  options.max_protrusion = 1;
  EXPECT_FALSE(passed(seen, options));
  const nlohmann::json json = nlohmann::json::parse(toJson(seen, options, "one", "two"));
  EXPECT_TRUE(json["links"][1]["uncovered"]["bound"].is_null());
  EXPECT_TRUE(json["links"][1]["protrusion"].is_null());
  EXPECT_EQ(json["links"][0]["protrusion"]["bound"], 0);
  EXPECT_EQ(json["passed"], false);
  EXPECT_NE(toTable(seen).find("missing: b: RESULT has no such link"), std::string::npos) << toTable(seen);
}

TEST_F(Verify, AMeshThatCannotBeReadFailsItsLinkAlone) {
  const std::string cube = primitive("box size='1 1 1'");
  const Description both = robot(fixtures::link("a", visual(cube) + collision(fixtures::meshTag("/nowhere/a.stl"))) +
                                 fixtures::link("b", visual(cube) + collision(cube), "a"));
  const Verification seen = verify(both, both, {});
  ASSERT_EQ(seen.links.size(), 2u);
  EXPECT_EQ(seen.links[0].status, LinkStatus::kFailed);
  EXPECT_NE(seen.links[0].reason.find("RESULT: "), std::string::npos);
  EXPECT_NE(seen.links[0].reason.find("/nowhere/a.stl"), std::string::npos);
  EXPECT_EQ(seen.links[1].status, LinkStatus::kOk);
  EXPECT_FALSE(passed(seen, {}));
  EXPECT_TRUE(nlohmann::json::parse(toJson(seen, {}, "", ""))["links"][0]["uncovered"].is_null());
}

// Each element has a copy of its mesh: a short description could ask for any amount of memory.
TEST_F(Verify, TheTrianglesOfAllElementsAreLimited) {
  const std::string cube = mesh("cube.obj", box(1, 1, 1)), sheet = mesh("sheet.obj", test_shapes::sheet());
  std::string links = fixtures::link("a", collision(cube));
  links += fixtures::link("b", collision(cube), "a") + fixtures::link("c", collision(sheet), "b");
  const Description both = robot(links);
  VerifyOptions options;
  options.configurations = 0;
  options.mesh_limits.max_triangles = 23;
  const Verification seen = verify(both, both, options);
  ASSERT_EQ(seen.links.size(), 3u);
  EXPECT_EQ(seen.links[0].status, LinkStatus::kOk) << seen.links[0].reason;
  EXPECT_EQ(seen.links[1].status, LinkStatus::kFailed);
  for (const std::string& part : {folder_ / "cube.obj", std::string("12 triangles"), std::string("limit of 23"), std::string("--links")})
    EXPECT_NE(seen.links[1].reason.find(part), std::string::npos) << seen.links[1].reason;
  EXPECT_EQ(seen.links[2].status, LinkStatus::kOk) << "it is small enough: " << seen.links[2].reason;
  options.mesh_limits.max_triangles = 26;
  EXPECT_EQ(verify(both, both, options).links[1].status, LinkStatus::kOk);
}

TEST_F(Verify, LinksThatAreNotChosenAreLooksAtTheControl) {
  const Description both = robot(fixtures::link("a", collision(primitive("box size='1 1 1'"))));
  VerifyOptions options;
  options.links = "other[a-z]*";
  EXPECT_EQ(looksAfterCancel(1, [&](const RunControl& control) { verify(both, both, options, control); }), 1u);
}

TEST_F(Verify, SourceSaysWhatCountsOfTheOriginal) {
  const Description both = robot(fixtures::link("a", visual(primitive("box size='2 2 2'")) + collision(primitive("box size='1 1 1'"))));
  VerifyOptions options;
  EXPECT_GT(only(verify(both, both, options)).uncovered.found, 0.5);
  options.source = Source::kCollision;
  EXPECT_EQ(only(verify(both, both, options)).uncovered.bound, 0);
  options.source = Source::kAuto;
  const Description bare = robot(fixtures::link("a", collision(primitive("box size='1 1 1'"))));
  EXPECT_EQ(only(verify(bare, bare, options)).status, LinkStatus::kOk);
  options.source = Source::kVisual;
  EXPECT_EQ(only(verify(bare, bare, options)).status, LinkStatus::kAdded);
}

TEST_F(Verify, VisualPrimitivesOfNoSizeAreNothing) {
  const std::string ball = collision(primitive("sphere radius='0.1'"));
  const Description dot = robot(fixtures::link("toe", visual(primitive("sphere radius='0'")) + ball));
  const LinkVerification toe = only(verify(dot, dot, {}));
  EXPECT_EQ(toe.status, LinkStatus::kOk) << toe.reason;
  EXPECT_EQ(toe.uncovered.bound, 0);
  const std::string both = visual(primitive("box size='0 1 1'")) + visual(primitive("box size='1 1 1'"));
  const Description panel = robot(fixtures::link("panel", both + collision(primitive("box size='1 1 1'"))));
  EXPECT_EQ(only(verify(panel, panel, {})).status, LinkStatus::kOk);
}

TEST_F(Verify, NothingToCompareIsAnError) {
  const Description empty = robot(fixtures::link("a", ""));
  EXPECT_THROW(verify(empty, empty, {}), Error);
  VerifyOptions options;
  options.max_uncovered = -1;
  const Description full = robot(fixtures::link("a", collision(primitive("box size='1 1 1'"))));
  EXPECT_THROW(verify(full, full, options), Error);
  options = {};
  options.jobs = -7;
  EXPECT_THROW(verify(full, full, options), Error);
  try {
    verify(full, robot(fixtures::link("b", collision(primitive("box size='1 1 1'")))), {});
    ADD_FAILURE() << "two robots";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    for (const std::string part : {"'a'", "'b'", "one robot"}) EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << part;
  }
  EXPECT_NO_THROW(verify(full, empty, {})) << "a model without a link's geometry";
}

TEST_F(Verify, ThreadsDoNotMatter) {
  const Description both =
      robot(fixtures::link("a", visual(mesh("u.obj", uChannel(0.2, 0.2, 0.02, 0.3))) + collision(primitive("box size='0.2 0.1 0.1'"))));
  VerifyOptions one, two;
  one.jobs = 1;
  const auto text = [&](const VerifyOptions& options) {
    Verification seen = verify(both, both, options);
    seen.seconds = 0;
    for (LinkVerification& row : seen.links) row.seconds = 0;
    return toJson(seen, {}, "", "");
  };
  EXPECT_EQ(text(one), text(two));
}

TEST_F(Verify, ALinkThatStandsElsewhereIsNoted) {
  const std::string cube = collision(primitive("box size='1 1 1'"));
  const std::string links = fixtures::link("a", cube) + fixtures::link("b", cube, "a");
  std::string other = links;
  other.replace(other.find("0 0 0.5"), 7, "0 0 0.6");
  const Verification seen = verify(robot(links), robot(other), {});
  ASSERT_EQ(seen.notes.size(), 1u);
  EXPECT_NE(seen.notes[0].find("'b'"), std::string::npos) << seen.notes[0];
}

TEST_F(Verify, ADescriptionInAnotherUnitIsNoted) {
  const auto model = [&](double size, double other) {
    const auto cube = [&](double s) {
      const std::string text = std::to_string(s);
      return collision(primitive("box size='" + text + " " + text + " " + text + "'"));
    };
    return robot(fixtures::link("a", cube(size)) + fixtures::link("b", cube(other), "a"));
  };
  VerifyOptions options;
  options.configurations = 0;
  const auto notes = [&](const Description& original, const Description& result) { return verify(original, result, options).notes; };
  const std::vector<std::string> larger = notes(model(1, 2), model(1000, 2000)), smaller = notes(model(1000, 2000), model(1, 2));
  ASSERT_EQ(larger.size(), 1u);
  EXPECT_NE(larger[0].find("more than ten times as large as ORIGINAL; 'a' is 1732.05 m across, and in ORIGINAL 1.73205 m"),
            std::string::npos)
      << larger[0];
  ASSERT_EQ(smaller.size(), 1u);
  EXPECT_NE(smaller[0].find("less than a tenth as large as ORIGINAL"), std::string::npos) << smaller[0];
  EXPECT_TRUE(notes(model(1, 2), model(1000, 2)).empty()) << "one link is right";
  EXPECT_TRUE(notes(model(1, 2), model(9, 18)).empty());
}

TEST_F(Verify, LinksThatTheOtherSideCallsOtherwiseAreNoted) {
  const std::string cube = collision(primitive("box size='1 1 1'"));
  const auto pair = [&](const std::string& second) { return robot(fixtures::link("a", cube) + fixtures::link(second, cube, "a")); };
  const Verification seen = verify(pair("tip"), pair("Tip"), {});
  ASSERT_EQ(seen.notes.size(), 1u);
  EXPECT_EQ(seen.notes[0], "1 link is in ORIGINAL alone, such as 'tip', and 1 in RESULT alone, such as 'Tip': links are compared by name");
  EXPECT_EQ(seen.links.back().reason, "ORIGINAL has no such link");
  EXPECT_TRUE(verify(pair("tip"), robot(fixtures::link("a", cube)), {}).notes.empty()) << "nothing that may be meant";
}

TEST(DescribeMesh, IsARobotOfOneLink) {
  const Description part = describeMesh("part.stl");
  ASSERT_EQ(part.robot.links.size(), 1u);
  EXPECT_EQ(part.robot.links[0].visuals.size(), 1u);
  EXPECT_EQ(part.robot.links[0].collisions[0].uri, part.robot.path);
}

}  // namespace
}  // namespace collision_hulls
