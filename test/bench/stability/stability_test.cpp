#include "bench/stability/stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using nlohmann::json;

StabilityRow row(TroubleKind kind, std::size_t hulls, double ratio) {
  StabilityRow result;
  result.trouble.kind = kind;
  result.hulls = hulls;
  result.hulls_ratio = ratio;
  result.uncovered = 0;
  result.protrusion = 1;
  result.tolerance = 1;
  return result;
}

TEST(Outcome, IsTheWorstThatApplies) {
  StabilityRow bad = row(TroubleKind::kRotation, 20, 2);
  EXPECT_EQ(outcomeOf(bad), "changed");
  bad.protrusion = 1.001;
  EXPECT_EQ(outcomeOf(bad), "over_bound");
  bad.uncovered = 1e-9;
  EXPECT_EQ(outcomeOf(bad), "uncovered");
  bad.allowed_uncovered = 1e-8;
  EXPECT_EQ(outcomeOf(bad), "over_bound");
}

TEST(Outcome, ChangeIsMoreThanOneAndMoreThanATenth) {
  EXPECT_EQ(outcomeOf(row(TroubleKind::kJitter, 10, 1)), "ok");
  EXPECT_EQ(outcomeOf(row(TroubleKind::kJitter, 3, 1.5)), "ok");         // of 2
  EXPECT_EQ(outcomeOf(row(TroubleKind::kJitter, 4, 2)), "changed");      // of 2
  EXPECT_EQ(outcomeOf(row(TroubleKind::kJitter, 108, 1.08)), "ok");      // of 100
  EXPECT_EQ(outcomeOf(row(TroubleKind::kJitter, 85, 0.85)), "changed");  // of 100
}

TEST(Outcome, AnotherShapeMayHaveAnotherNumberOfHulls) {
  EXPECT_EQ(outcomeOf(row(TroubleKind::kHole, 20, 2)), "ok");
  StabilityRow first = row(TroubleKind::kRotation, 20, 2);
  first.hulls_ratio.reset();  // there is no result for the undisturbed mesh
  EXPECT_EQ(outcomeOf(first), "ok");
}

TEST(StabilityCsv, HasAsManyFieldsAsColumns) {
  const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  EXPECT_EQ(commas(toCsv(row(TroubleKind::kSliver, 2, 1))), commas(stabilityHeader()));
  EXPECT_EQ(stabilityHeader().rfind("mesh,method,trouble,amount,outcome,hulls,hulls_ratio,protrusion,message", 0), 0u);
}

TEST(StabilityJob, WritesTheTroubledMesh) {
  const fixtures::TempFolder folder;
  const json job = {{"job", "trouble"},
                    {"file", fixtures::write(folder / "box.obj", fixtures::obj(test_shapes::box(1, 2, 2)))},
                    {"scale", {2, 2, 2}},
                    {"kind", "scale"},
                    {"amount", 10},
                    {"seed", 1},
                    {"troubled", folder / "out.obj"}};
  doStabilityJob(fixtures::write(folder / "job.json", job.dump()), folder / "result.json");
  EXPECT_NEAR(json::parse(fixtures::read(folder / "result.json"))["diagonal"].get<double>(), 6, 1e-6);
  EXPECT_NEAR(diagonal(readMesh(folder / "out.obj").mesh), 60, 1e-5);
}

}  // namespace
}  // namespace collision_hulls
