#include "web/summary.h"

#include <gtest/gtest.h>

#include "web/pages.h"

namespace collision_hulls {
namespace {

using pages::row;
using pages::Sample;

std::string all(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += sentence + "|";
  return text;
}

TEST(Summary, TotalsFirst) {
  const Sample sample;
  const std::vector<std::string> said = summary(sample.report, sample.report);
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(
      said[0],
      "2,468 triangles in 2 meshes \xE2\x86\x92 4 hulls. They never miss a collision, protrude by at most 9.80 mm, and answer distance "
      "queries 27.0 times quicker than the meshes.");
  EXPECT_EQ(said[1],
            "400 queries compared hulls and meshes: no collision missed, no false collision beyond the protrusion; distances at most 0 mm "
            "too short.");
  EXPECT_TRUE(warnings(sample.report, sample.report).empty());
}

TEST(Summary, OnlyWhatWasMeasured) {
  Sample sample({row("cup")});
  sample.report.options.validate = false;
  const std::vector<std::string> said = summary(sample.report, sample.report);
  EXPECT_EQ(said[0], "1,234 triangles in 1 mesh \xE2\x86\x92 2 hulls. They never miss a collision and protrude by at most 9.80 mm.");
  EXPECT_EQ(said[1], "Not compared by collision queries (--no-validate).");
}

TEST(Summary, SlowerIsSaidAsWell) {
  Sample sample;
  sample.report.validation.hull_query_us = 54;
  EXPECT_NE(summary(sample.report, sample.report)[0].find("2.00 times slower than the meshes"), std::string::npos);
}

TEST(Summary, AFitIsMeasuredOnTheWholeRobot) {
  Sample sample;
  sample.report.links[1].primitives = 1;
  sample.report.links[1].hulls = 0;
  FitReport fit;
  fit.scene = "shelf";
  fit.samples = 10000;
  fit.clearance = 0.01;
  fit.phantom_rate_bound = 0.0003;
  fit.query_us = 1;
  fit.original_query_us = 8;
  fit.distance_us = 2;
  fit.original_distance_us = 54;
  sample.report.scene = fit;
  const std::vector<std::string> said = summary(sample.report, sample.report);
  ASSERT_EQ(said.size(), 3u);
  EXPECT_NE(said[0].find("2 hulls and 1 primitive. They"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("answer collision queries 8.00 times quicker and distance queries 27.0 times quicker than the meshes"),
            std::string::npos)
      << said[0];
  EXPECT_EQ(
      said[1],
      "Fitted to the scene shelf with a clearance of 10.0 mm: in 10,000 random configurations, no collision missed, no false collision "
      "beyond the clearance (at 95 % confidence in at most 0.0300 % of all configurations).");
}

TEST(Summary, NothingIsClaimedOfWhatHasNoHulls) {
  const Sample failed({row("arm"), row("hand", Status::kFailed)});
  EXPECT_NE(
      summary(failed.report, failed.report)[0].find("They never miss a collision with the surface that they cover, protrude by at most"),
      std::string::npos)
      << summary(failed.report, failed.report)[0];
  const Sample left({row("arm"), row("base", Status::kKept), row("camera", Status::kRemoved), row("lamp", Status::kRemoved)});
  const std::vector<std::string> said = summary(left.report, left.report);
  EXPECT_NE(said[0].find("with the surface that they cover"), std::string::npos) << said[0];
  EXPECT_EQ(said[1], "1 link is kept as described, and 2 links are left without collision elements, as configured.");
}

TEST(Summary, NothingIsClaimedWithoutHulls) {
  const Sample sample({row("arm", Status::kFailed)});
  EXPECT_EQ(all(summary(sample.report, sample.report)), "1,234 triangles in 1 mesh: no hulls.|");
}

TEST(Warnings, WhatAsksForAttention) {
  Sample sample({row("a", Status::kFailed), row("b", Status::kDegraded), row("c")});
  sample.report.validation.missed = 2;
  sample.report.validation.phantom = 1;
  EXPECT_EQ(all(warnings(sample.report, sample.report)),
            "1 of 3 meshes failed: no hulls, and a link with one keeps the collision elements that it has.|"
            "1 of 3 meshes protrudes further than the tolerance.|"
            "2 collisions missed in the check: please report this as a fault of collision_hulls.|"
            "1 false collision beyond the protrusion: please report this as a fault of collision_hulls.|");
}

}  // namespace
}  // namespace collision_hulls
