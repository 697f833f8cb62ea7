#include "decompose/certified/lower_bound.h"

#include <gtest/gtest.h>

#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/decompose/least_hulls.h"
#include "decompose/certified/certified_cases.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

/// What a search asked for.
struct Asked {
  std::size_t hulls = 0;  // of the result
  std::vector<std::vector<ConvexHull>> covers;
};

Asked askedFor(const TriangleMesh& mesh, double tolerance, std::size_t answer) {
  Asked asked;
  LowerBound least([&](const std::vector<ConvexHull>& cover, const RunControl&) {
    asked.covers.push_back(cover);
    return answer;
  });
  const RepairedMesh repaired = repair(mesh);
  asked.hulls = certified(repaired, Solid(repaired), within(tolerance), least, {}).hulls.size();
  return asked;
}

TEST(LowerBound, IsSoughtOnce) {
  int calls = 0;
  LowerBound least([&](const std::vector<ConvexHull>& cover, const RunControl&) {
    ++calls;
    return cover.size();
  });
  EXPECT_FALSE(least.known());
  EXPECT_EQ(least(std::vector<ConvexHull>(3), {}), 3u);
  EXPECT_EQ(least(std::vector<ConvexHull>(2), {}), 3u);
  EXPECT_EQ(least.known(), 3u);
  EXPECT_EQ(calls, 1);
}

TEST(LowerBound, IsSoughtAgainAfterTimeEnded) {
  bool in_time = false;
  LowerBound least([&](const std::vector<ConvexHull>&, const RunControl&) -> std::size_t {
    if (!in_time) throw Error(ErrorCode::kOutOfTime, "");
    return 2;
  });
  EXPECT_THROW(least({}, {}), Error);
  EXPECT_FALSE(least.known());
  in_time = true;
  EXPECT_EQ(least({}, {}), 2u);
}

TEST(LowerBound, TheSearchEndsAtThatNumber) {
  const TriangleMesh mesh = boxWithWindow();
  const double tolerance = 0.05 * diagonal(mesh);
  const Asked early = askedFor(mesh, tolerance, 100), late = askedFor(mesh, tolerance, 1);
  EXPECT_EQ(early.covers.size(), 1u);
  EXPECT_GT(early.hulls, late.hulls);
  EXPECT_EQ(askedFor(mesh, tolerance, early.hulls).hulls, early.hulls);
  EXPECT_LT(askedFor(mesh, tolerance, early.hulls - 1).hulls, early.hulls);
}

TEST(LowerBound, TheSearchGivesACoverInTheMeshsFrame) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(10, -20, 30);
  const TriangleMesh mesh = transformed(uChannel(), pose);
  const Asked asked = askedFor(mesh, 0.05, 1);
  ASSERT_EQ(asked.covers.size(), 1u);
  EXPECT_EQ(asked.covers.front().size(), 3u);
  EXPECT_LT(uncovered(mesh, asked.covers.front()), 1e-9);
}

TEST(LowerBound, NeitherTwoHullsNorManyNeedIt) {
  EXPECT_TRUE(askedFor(lBracket(), 0.05, 1).covers.empty());
  std::vector<TriangleMesh> boxes;
  for (int i = 0; i < 9; ++i) boxes.push_back(moved(box(1, 1, 1), {3.0 * i, 0, 0}));
  EXPECT_TRUE(askedFor(merged(boxes), 0.05, 1).covers.empty());
  boxes.pop_back();
  EXPECT_EQ(askedFor(merged(boxes), 0.05, 1).covers.size(), 1u);
}

TEST(LowerBound, CertifiedHullsReportWhatTheSearchProved) {
  const TriangleMesh channel = uChannel();
  const CertifiedHulls three = certifiedHulls(channel, within(0.05));
  EXPECT_EQ(three.hulls.size(), 3u);
  EXPECT_EQ(three.least_hulls, 3u);
  EXPECT_FALSE(certifiedHulls(lBracket(), within(0.05)).least_hulls);
}

/// With this margin the search aims at 0.15, and has to keep the walls apart. The tolerance itself exceeds half the way between them.
TEST(LowerBound, RefersToTheWholeTolerance) {
  const TriangleMesh mesh = uChannel(0.6, 1);
  const RepairedMesh repaired = repair(mesh);
  const Solid solid(repaired);
  const CertifiedHulls result = certifiedHulls({mesh, repaired, solid, 0.02, nullptr, ""}, within(0.21));
  EXPECT_EQ(result.hulls.size(), 3u);
  EXPECT_EQ(result.least_hulls, 1u);
}

}  // namespace
}  // namespace collision_hulls
