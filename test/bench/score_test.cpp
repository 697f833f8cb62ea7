// The evaluator on shapes with known cover, protrusion and volume.
// Also tests src/bench/original.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "bench/jobs.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "pipeline/fixtures.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using nlohmann::json;
using namespace test_shapes;

constexpr double kTolerance = 0.01;

class Score : public ::testing::Test {
 protected:
  json of(const TriangleMesh& mesh, const std::vector<ConvexHull>& hulls) {
    const std::string mesh_file = fixtures::write(folder_ / "mesh.obj", fixtures::obj(mesh));
    const std::string hulls_file = fixtures::write(folder_ / "hulls.obj", encodeHullsObj(hulls, "hull"));
    return score({{"file", mesh_file}, {"scale", {1, 1, 1}}, {"tolerance", kTolerance}, {"hulls", {hulls_file}}});
  }

  void expectProtrusion(const json& scored, double truth, double faceting = 1e-6) {
    EXPECT_GE(scored["protrusion"].get<double>(), truth - faceting);
    EXPECT_LE(scored["protrusion"].get<double>(), truth + kTolerance * 0.02 + faceting);
    EXPECT_LE(scored["protrusion_found"].get<double>(), truth + faceting);
  }

  fixtures::TempFolder folder_;
};

TEST_F(Score, MissingHullsAreAnError) {
  EXPECT_THROW(of(box(1, 1, 1), {}), Error);
}

TEST_F(Score, ConvexShapeByItsHull) {
  const json scored = of(box(1, 2, 3), {boxHull({0, 0, 0}, {1, 2, 3})});
  EXPECT_EQ(scored["hulls"], 1);
  EXPECT_EQ(scored["hull_vertices"], 8);
  EXPECT_EQ(scored["uncovered"], 0.0);
  EXPECT_NEAR(scored["volume_ratio"].get<double>(), 1, 0.01);
  expectProtrusion(scored, 0);
}

TEST_F(Score, UChannelInOneHull) {  // width 1, depth 1, walls 0.1, height 2: the middle of the mouth is 0.4 from the walls
  const TriangleMesh channel = uChannel();
  const json scored = of(channel, {hullOf(channel)});
  EXPECT_EQ(scored["uncovered"], 0.0);
  EXPECT_NEAR(scored["volume_ratio"].get<double>(), 1 / (1 - 0.8 * 0.9), 0.05);
  expectProtrusion(scored, 0.4);
}

TEST_F(Score, TorusInOneHull) {  // furthest at the middle of the flat top: sqrt(R^2 + r^2) - r
  const TriangleMesh ring = torus(1, 0.3, 64, 32);
  expectProtrusion(of(ring, {hullOf(ring)}), std::sqrt(1 + 0.09) - 0.3, 4e-3);
}

TEST_F(Score, SphereInABox) {  // the corner of the cube about the unit sphere: sqrt(3) - 1
  const json scored = of(sphere(1, 24), {boxHull({-1, -1, -1}, {1, 1, 1})});
  EXPECT_NEAR(scored["volume_ratio"].get<double>(), 6 / kPi, 0.05);
  expectProtrusion(scored, std::sqrt(3.0) - 1, 2e-3);
}

TEST_F(Score, TwoBoxesInOneHull) {  // half the gap between them
  const TriangleMesh pair = merged({box(1, 1, 1), moved(box(1, 1, 1), {1.5, 0, 0})});
  const json scored = of(pair, {hullOf(pair)});
  EXPECT_NEAR(scored["volume_ratio"].get<double>(), 1.25, 0.02);
  expectProtrusion(scored, 0.25);
}

TEST_F(Score, DecidesCorrectlyHoweverNearTheTolerance) {  // the middle of the mouth is 0.4 from the walls
  const TriangleMesh channel = uChannel();
  const std::string mesh = fixtures::write(folder_ / "mesh.obj", fixtures::obj(channel));
  const std::string hull = fixtures::write(folder_ / "hulls.obj", encodeHullsObj({hullOf(channel)}, "hull"));
  const std::string none = fixtures::write(folder_ / "none.obj", "o nothing\n");
  for (const double tolerance : {0.04, 0.3, 0.39, 0.399, 0.401, 0.41, 0.5, 4.0}) {
    const json job = {{"job", "decide"}, {"file", mesh}, {"scale", {1, 1, 1}}, {"tolerance", tolerance}, {"hulls", {none, hull}}};
    doJob(fixtures::write(folder_ / "job.json", job.dump()), folder_ / "result.json");
    const json results = json::parse(fixtures::read(folder_ / "result.json"))["results"];
    EXPECT_NE(results[0]["error"].get<std::string>().find("no hull"), std::string::npos);
    const double protrusion = results[1]["protrusion"];
    EXPECT_EQ(protrusion > tolerance, 0.4 > tolerance) << tolerance;
    EXPECT_GE(protrusion, 0.4 - 1e-6);
    EXPECT_LE(protrusion, 0.4 + 0.1 * tolerance + 1e-6);
    EXPECT_EQ(results[1]["uncovered"], 0.0);
  }
}

TEST_F(Score, UncoveredSurface) {  // only one of two boxes has a hull; the far side of the other is 1.5 away
  const TriangleMesh pair = merged({box(1, 1, 1), moved(box(1, 1, 1), {1.5, 0, 0})});
  const json scored = of(pair, {boxHull({0, 0, 0}, {1, 1, 1})});
  EXPECT_NEAR(scored["uncovered"].get<double>(), 1.5, 0.02);
  expectProtrusion(scored, 0);
}

TEST_F(Score, ProvesTheLeastNumberOfHullsIfAsked) {
  const TriangleMesh pair = merged({box(1, 1, 1), moved(box(1, 1, 1), {1.5, 0, 0})});
  const std::string mesh = fixtures::write(folder_ / "mesh.obj", fixtures::obj(pair));
  json job = {{"file", mesh}, {"scale", {1, 1, 1}}, {"tolerance", kTolerance}, {"least", true}};
  for (const std::vector<ConvexHull>& hulls :
       {std::vector{hullOf(pair)}, {boxHull({0, 0, 0}, {1, 1, 1}), boxHull({1.5, 0, 0}, {2.5, 1, 1})}}) {
    job["hulls"] = {fixtures::write(folder_ / "hulls.obj", encodeHullsObj(hulls, "hull"))};
    EXPECT_EQ(score(job)["least_hulls"], 2) << hulls.size();  // also where one hull leaves the tolerance
  }
  job["least"] = false;
  EXPECT_FALSE(score(job).contains("least_hulls"));
}

TEST_F(Score, SheetHasNoVolume) {
  const TriangleMesh plate = sheet();
  const json scored = of(plate, {hullOf(plate)});
  EXPECT_TRUE(scored["volume_ratio"].is_null());
  EXPECT_EQ(scored["uncovered"], 0.0);
}

TEST_F(Score, OverlapOfHullsCountsOnce) {
  const json scored = of(box(1, 1, 1), {boxHull({0, 0, 0}, {1, 1, 0.75}), boxHull({0, 0, 0.25}, {1, 1, 1})});
  EXPECT_EQ(scored["hulls"], 2);
  EXPECT_NEAR(scored["volume_ratio"].get<double>(), 1, 0.01);
}

}  // namespace
}  // namespace collision_hulls
