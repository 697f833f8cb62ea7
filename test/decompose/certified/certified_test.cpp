#include "collision_hulls/decompose/certified.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "decompose/certified/certified_cases.h"
#include "geometry/pi.h"

namespace collision_hulls {
namespace {

using test_shapes::bentTube;
using test_shapes::expectCovers;
using test_shapes::kGap;
using test_shapes::RandomPoints;
using test_shapes::within;

Decomposition checked(const TriangleMesh& mesh, const DecomposeOptions& options) {
  const RepairedMesh repaired = repair(mesh);
  Decomposition result = certified(repaired, options);
  const RoundedHulls fitted = expectCovers(repaired, result.hulls, options.max_vertices);
  EXPECT_LE(protrusion(fitted.hulls, Solid(repaired), kGap * options.tolerance).bound, options.tolerance);
  for (const ConvexHull& hull : result.hulls)
    EXPECT_TRUE(options.max_vertices == 0 || hull.vertices.size() <= static_cast<std::size_t>(options.max_vertices));
  EXPECT_FALSE(result.capped);
  return result;
}

std::size_t count(const TriangleMesh& mesh, double share, Effort effort = Effort::kQuick) {
  return checked(mesh, within(share * diagonal(mesh), effort)).hulls.size();
}

TriangleMesh rotated(const TriangleMesh& mesh, const Eigen::Matrix3d& rotation) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation;
  return transformed(mesh, pose);
}

/// A square frame with a wall on it: an L with a hole.
TriangleMesh bracketWithHole() {
  const std::vector<Eigen::Vector2d> outer{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, hole{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}};
  const auto at = [](const Eigen::Vector2d& p, double z) { return Eigen::Vector3d(p.x(), p.y(), z); };
  test_shapes::MeshBuilder builder;
  const double t = 0.1;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    builder.quad(at(outer[i], t), at(outer[j], t), at(hole[j], t), at(hole[i], t));
    builder.quad(at(outer[j], 0), at(outer[i], 0), at(hole[i], 0), at(hole[j], 0));
    builder.quad(at(outer[i], 0), at(outer[j], 0), at(outer[j], t), at(outer[i], t));
    builder.quad(at(hole[j], 0), at(hole[i], 0), at(hole[i], t), at(hole[j], t));
  }
  return test_shapes::merged({builder.mesh(), test_shapes::moved(test_shapes::box(1, t, 0.6), {0, 0, t})});
}

void expectEqual(const std::vector<ConvexHull>& a, const std::vector<ConvexHull>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t h = 0; h < a.size(); ++h) {
    EXPECT_EQ(a[h].vertices, b[h].vertices);
    EXPECT_EQ(a[h].triangles, b[h].triangles);
  }
}

// Degenerate input.

TEST(Certified, SingleTriangleAndFlatMesh) {
  const TriangleMesh l_shape{{{0, 0, 0}, {1, 0, 0}, {1, 0.1, 0}, {0.1, 0.1, 0}, {0.1, 1, 0}, {0, 1, 0}},
                             {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 5}}, {{3, 4, 5}}}};
  for (Effort effort : allEfforts()) {
    EXPECT_EQ(count(test_shapes::singleTriangle(), 0.01, effort), 1u);
    EXPECT_EQ(count(test_shapes::sheet(1, 2, 3), 0.01, effort), 1u);
  }
  EXPECT_EQ(count(l_shape, 0.05), 2u);
}

TEST(Certified, OnlyLoosePoints) {
  RepairedMesh mesh;
  mesh.loose = test_shapes::loosePoints({{0, 0, 0}, {0.01, 0, 0}, {5, 0, 0}, {5, 0.01, 0}, {0, 0, 7}});
  for (Effort effort : allEfforts()) {
    const Decomposition result = certified(mesh, within(0.1, effort));
    EXPECT_EQ(result.hulls.size(), 3u);
    expectCovers(mesh, result.hulls);
  }
  mesh.loose = test_shapes::loosePoints({{1, 2, 3}});
  expectCovers(mesh, certified(mesh, within(0.1)).hulls);
}

TEST(Certified, OpenAndOverlappingSurfaces) {
  RandomPoints random(11);
  count(test_shapes::boxWithWindow(), 0.03);
  count(random.soup(4), 0.03);
  const TriangleMesh box = test_shapes::box(1, 1, 1);
  EXPECT_EQ(count(test_shapes::merged({box, box}), 0.02), 1u);
  EXPECT_EQ(count(test_shapes::merged({box, test_shapes::moved(box, {0.5, 0, 0})}), 0.02), 1u);
}

// Known counts.

TEST(Certified, ConvexInputIsOneHull) {
  RandomPoints random(3);
  for (Effort effort : allEfforts()) {
    EXPECT_EQ(count(test_shapes::box(1, 2, 3), 0.01, effort), 1u);
    EXPECT_EQ(count(test_shapes::box(1, 1, 0.001, 2), 0.01, effort), 1u);
    EXPECT_EQ(count(surface(convexHull(random.cloud(30))), 0.01, effort), 1u);
    EXPECT_EQ(count(test_shapes::sphere(1, 4), 0.05, effort), 1u);
  }
}

/// A star of eight points.
TEST(Certified, TwoHullsWhereTheFirstWayLeavesThree) {
  constexpr int kCorners = 16;
  const auto at = [](int i, double z) {
    const double radius = i % 2 == 0 ? 1 : 0.7, turn = 2 * kPi * i / kCorners;
    return Eigen::Vector3d(radius * std::cos(turn), radius * std::sin(turn), z);
  };
  test_shapes::MeshBuilder builder;
  for (int i = 0; i < kCorners; ++i) {
    const int j = (i + 1) % kCorners;
    builder.quad(at(i, 0), at(j, 0), at(j, 0.4), at(i, 0.4));
    builder.triangle({0, 0, 0}, at(j, 0), at(i, 0));
    builder.triangle({0, 0, 0.4}, at(i, 0.4), at(j, 0.4));
  }
  EXPECT_EQ(count(builder.mesh(), 0.05), 2u);
}

TEST(Certified, WallsAreOneHullEach) {
  for (Effort effort : allEfforts()) {
    SCOPED_TRACE(name(effort));
    for (double share : {0.01, 0.02}) {
      EXPECT_EQ(count(test_shapes::lBracket(), share, effort), 2u) << share;
      EXPECT_EQ(count(test_shapes::uChannel(), share, effort), 3u) << share;
    }
    EXPECT_EQ(count(test_shapes::openBox(), 0.01, effort), 5u);
  }
  EXPECT_EQ(count(test_shapes::openBox(1, 1, 1, 0.05, 2), 0.02, Effort::kBest), 5u);
}

/// A disc with pointed teeth.
TriangleMesh star(int teeth) {
  std::vector<Eigen::Vector2d> outline;
  std::vector<Triangle> cap;
  for (int i = 0; i < 2 * teeth; ++i) {
    const double angle = test_shapes::kPi * i / teeth, radius = i % 2 ? 10 : 2;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  for (int i = 0; i < teeth; ++i) {
    const int after = (2 * i + 2) % (2 * teeth);
    cap.push_back({2 * i, 2 * i + 1, after});
    if (i > 0 && after > 0) cap.push_back({0, 2 * i, after});
  }
  return test_shapes::prism(outline, cap, 1);
}

TEST(Certified, PartsWithSolidBetweenThemShareAHull) {
  EXPECT_EQ(count(star(20), 0.01), 10u) << "opposite teeth";
}

TEST(Certified, DistantPartsAreOneHullEach) {
  EXPECT_EQ(count(test_shapes::fourSpheres(), 0.02), 4u);
}

TEST(Certified, FarFromTheOriginIsTheSame) {
  const TriangleMesh mesh = test_shapes::uChannel();
  EXPECT_EQ(count(test_shapes::moved(mesh, {1000, -2000, 500}), 0.02), 3u);
}

TEST(Certified, APocketBehindANarrowNeckIsNotFilled) {
  const TriangleMesh mesh = test_shapes::flask();
  EXPECT_GT(checked(mesh, within(0.5)).hulls.size(), 1u);
  EXPECT_EQ(checked(mesh, within(1.1)).hulls.size(), 1u);
}

TEST(Certified, APocketThatOnlyAProofFindsIsNotFilled) {
  const TriangleMesh mesh = test_shapes::flaskBesidePlates();
  EXPECT_GT(checked(mesh, within(0.95)).hulls.size(), 1u);
  EXPECT_EQ(checked(mesh, within(1.05)).hulls.size(), 1u);
}

TEST(Certified, AHullWithAPocketIsMergedAnew) {
  using namespace test_shapes;
  const TriangleMesh mesh = merged({flaskBesidePlates(), moved(box(3, 3, 3), {0, 20, 0})});
  EXPECT_GT(checked(mesh, within(0.95)).hulls.size(), 2u);
  EXPECT_GT(checked(mesh, within(0.95, Effort::kBest)).hulls.size(), 2u);
  EXPECT_EQ(checked(mesh, within(1.05)).hulls.size(), 2u);
}

TEST(Certified, FilledHullsContainTheInside) {
  const TriangleMesh mesh = bentTube(8, 12);
  const Solid solid(repair(mesh));
  double least = 1;
  for (double share : {0.05, 0.02})
    for (Effort effort : allEfforts()) {
      SCOPED_TRACE(testing::Message() << share << ", " << name(effort));
      DecomposeOptions options = within(share * diagonal(mesh), effort);
      least = std::min(least, coveredShare(checked(mesh, options).hulls, solid));
      options.fill = true;
      EXPECT_EQ(coveredShare(checked(mesh, options).hulls, solid), 1);
    }
  EXPECT_LT(least, 1) << "otherwise there was nothing to fill";
}

// The promise.

TEST(Certified, CoversWithinTheTolerance) {
  for (const TriangleMesh& mesh :
       {test_shapes::torus(1, 0.3, 8, 6), bentTube(4, 6), bracketWithHole(), test_shapes::flange(3, 0.4, 1, 0.12, 0.15, 2, 1)})
    for (double share : {0.05, 0.02, 0.01})
      for (int max_vertices : {0, 64}) {
        SCOPED_TRACE(testing::Message() << mesh.triangles.size() << " triangles, " << share << ", " << max_vertices);
        checked(mesh, within(share * diagonal(mesh), Effort::kQuick, max_vertices));
      }
}

TEST(Certified, FewVerticesStillCoverWithinTheTolerance) {
  for (int max_vertices : {8, 16}) {
    const TriangleMesh mesh = bentTube();
    checked(mesh, within(0.04 * diagonal(mesh), Effort::kQuick, max_vertices));
  }
}

TEST(Certified, BestNeedsNoMoreHullsThanQuick) {
  for (const TriangleMesh& mesh : {test_shapes::torus(1, 0.3, 12, 8), bentTube(8, 8), bracketWithHole()}) {
    SCOPED_TRACE(testing::Message() << mesh.triangles.size() << " triangles");
    EXPECT_LE(count(mesh, 0.03, Effort::kBest), count(mesh, 0.03, Effort::kQuick));
  }
}

TEST(Certified, MoreToleranceNeedsNoMoreHulls) {
  const TriangleMesh mesh = bracketWithHole();
  EXPECT_LE(count(mesh, 0.05), count(mesh, 0.01));
}

TEST(Certified, RotationChangesTheCountLittle) {
  RandomPoints random(5);
  const TriangleMesh mesh = bracketWithHole();
  const double still = static_cast<double>(count(mesh, 0.04));
  for (int i = 0; i < 2; ++i) {
    const TriangleMesh turned_mesh = rotated(mesh, random.rotation());
    const double turned = static_cast<double>(checked(turned_mesh, within(0.04 * diagonal(mesh))).hulls.size());
    EXPECT_LE(std::abs(turned - still), std::max(1.0, 0.25 * still));
  }
}

TEST(Certified, ASymmetricMeshHasTheSameCountWhenTurned) {
  RandomPoints random(6);
  for (const TriangleMesh& mesh : {test_shapes::uChannel(), test_shapes::openBox(), test_shapes::flange()}) {
    const auto hulls = [&](const TriangleMesh& some) { return decompose(repair(some), within(0.02 * diagonal(mesh))).hulls.size(); };
    EXPECT_EQ(hulls(rotated(mesh, random.rotation())), hulls(mesh));
  }
}

// Execution.

TEST(Certified, SameBytesForAnyNumberOfThreads) {
  const RepairedMesh large = repair(bentTube(36, 36)), small = repair(bentTube(8, 8));
  ASSERT_GT(large.mesh.triangles.size(), 5000u) << "small parts are not split in parallel";
  for (Effort effort : allEfforts()) {
    const RepairedMesh& mesh = effort == Effort::kQuick ? large : small;
    DecomposeOptions options = within(0.1, effort);
    options.max_vertices = 16;
    const Decomposition first = certified(mesh, options);
    for (const int threads : {1, 2, 4}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
      tbb::task_arena arena(threads);
      arena.execute([&] { expectEqual(certified(mesh, options).hulls, first.hulls); });
    }
  }
}

TEST(Certified, MaxHullsCapsAndIsReported) {
  const TriangleMesh mesh = test_shapes::openBox();
  const RepairedMesh repaired = repair(mesh);
  DecomposeOptions options = within(0.01 * diagonal(mesh));
  for (int cap : {2, 5}) {
    options.max_hulls = cap;
    const Decomposition result = certified(repaired, options);
    EXPECT_LE(result.hulls.size(), static_cast<std::size_t>(cap));
    EXPECT_EQ(result.capped, cap < 5);
    expectCovers(repaired, result.hulls, 64);
  }
}

TEST(Certified, CanBeCancelledAtAnyTime) {
  const RepairedMesh mesh = repair(test_shapes::torus(1, 0.3, 16, 8));
  for (double share : {0.0, 0.3, 0.7}) {  // while splitting, after the first way, in the last search
    RunControl control;
    control.progress = [&](double done) {
      if (done >= share) control.cancel();
    };
    try {
      certified(mesh, within(0.1, Effort::kBest), control);
      FAIL() << share;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kCancelled);
    }
  }
}

// Deadlines.

TriangleMesh ring() {
  return test_shapes::torus(0.1, 0.03, 32, 16);
}

/// The search is at `share` of its work when time ends.
Decomposition endedAt(double share, const TriangleMesh& mesh, const DecomposeOptions& options) {
  RunControl control;
  control.deadline = std::chrono::steady_clock::now() + std::chrono::hours(1);
  control.progress = [&](double done) {
    if (done >= share) control.deadline = std::chrono::steady_clock::now();
  };
  Decomposition result;
  withJobs(1, [&] { result = certified(repair(mesh), options, control); });
  return result;
}

double protrusionOf(const std::vector<ConvexHull>& hulls, const TriangleMesh& mesh) {
  return protrusion(hulls, test_shapes::solidOf(mesh), 1e-5).bound;
}

TEST(CertifiedUntilADeadline, HullsCoverWheneverTimeEnds) {
  for (const Effort effort : allEfforts()) {
    for (const double share : {0.0, 0.01, 0.1, 0.3, 0.45, 0.55, 0.69}) {
      SCOPED_TRACE(std::string(name(effort)) + " until " + std::to_string(share));
      const Decomposition result = endedAt(share, ring(), within(0.002, effort));
      expectCovers(repair(ring()), result.hulls, 64);
      EXPECT_LT(result.hulls.size(), 500u);
    }
  }
}

// Of an hour, nothing passes while leaves are made; the first progress at the tolerance itself comes after the coarser covers.
TEST(CertifiedUntilADeadline, ACoarserCoverStandsInForOneThatIsNotComplete) {
  const Decomposition result = endedAt(0.001, ring(), within(0.002));
  EXPECT_GT(result.hulls.size(), 1u);
  const double reached = protrusionOf(result.hulls, ring());
  EXPECT_GT(reached, 0.002);
  EXPECT_LT(reached, 4 * 0.002);
  EXPECT_NE(result.untried.find("the division of all of the surface"), std::string::npos) << result.untried;
}

TEST(CertifiedUntilADeadline, TheToleranceHoldsOnceTheSurfaceIsDivided) {
  for (const double share : {0.25, 0.3, 0.4, 0.5, 0.65}) {
    const Decomposition result = endedAt(share, ring(), within(0.004));
    EXPECT_LE(protrusionOf(result.hulls, ring()), 0.004);
    EXPECT_NE(result.untried.find("the search for fewer hulls"), std::string::npos) << result.untried;
    EXPECT_EQ(result.untried.find("the division of all"), std::string::npos) << result.untried;
  }
}

TEST(CertifiedUntilADeadline, CapsHold) {
  DecomposeOptions options = within(0.002);
  options.max_hulls = 3;
  for (const double share : {0.0, 0.01, 0.3}) EXPECT_LE(endedAt(share, ring(), options).hulls.size(), 3u);
}

}  // namespace
}  // namespace collision_hulls
