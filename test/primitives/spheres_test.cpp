// Also tests src/primitives/sphere_choice.cpp.
#include "collision_hulls/primitives/spheres.h"

#include <gtest/gtest.h>

#include "base/millimetres.h"
#include "base/parallel.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

SphereOptions within(double tolerance, Effort effort = Effort::kQuick) {
  SphereOptions options;
  options.tolerance = tolerance;
  options.effort = effort;
  return options;
}

bool isIn(const std::vector<Sphere>& spheres, const Eigen::Vector3d& p, double slack) {
  for (const Sphere& sphere : spheres)
    if ((p - sphere.centre).norm() <= sphere.radius + slack) return true;
  return false;
}

/// Checks by sampling alone.
void expectKept(const TriangleMesh& mesh, const CertifiedSpheres& result, double tolerance) {
  RandomPoints random(1);
  const Solid solid = solidOf(mesh);
  for (int i = 0; i < 5000; ++i) EXPECT_TRUE(isIn(result.spheres, random.on(mesh), 1e-12 * diagonal(mesh)));
  for (const Eigen::Vector3d& v : mesh.vertices) EXPECT_TRUE(isIn(result.spheres, v, 1e-12 * diagonal(mesh)));
  ASSERT_EQ(result.bounds.size(), result.spheres.size());
  for (std::size_t s = 0; s < result.spheres.size(); ++s) {
    EXPECT_LE(result.bounds[s], result.bound);
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d p = result.spheres[s].centre + result.spheres[s].radius * random.onSphere();
      EXPECT_LE(solid.leastDistance(p, solid.distanceToSurface(p)), result.bounds[s]);
    }
  }
  EXPECT_LE(result.bound, tolerance);
  EXPECT_TRUE(result.within_tolerance);
  EXPECT_TRUE(covers(result.spheres, mesh));
}

TEST(CertifiedSpheres, CoverAndKeepTheTolerance) {
  for (const TriangleMesh& mesh :
       {box(1, 2, 0.5), lBracket(), uChannel(), flask(), torus(), flange(), sphere(), sheet(), boxWithWindow()}) {
    const double tolerance = 0.05 * diagonal(mesh);
    expectKept(mesh, certifiedSpheres(mesh, within(tolerance, Effort::kInstant)), tolerance);
  }
  for (const TriangleMesh& mesh : {flange(), boxWithWindow()}) {
    const double tolerance = 0.05 * diagonal(mesh);
    expectKept(mesh, certifiedSpheres(mesh, within(tolerance)), tolerance);
  }
}

TEST(CertifiedSpheres, AreFew) {
  const auto count = [](const TriangleMesh& mesh, double share) {
    return certifiedSpheres(mesh, within(share * diagonal(mesh))).spheres.size();
  };
  EXPECT_EQ(count(sphere(1, 8), 0.01), 1U);
  EXPECT_EQ(count(box(1, 1, 1), 0.3), 1U);  // the ball through its corners protrudes by 0.21 diagonals
  // Of two balls in a bar of 10 by 1 by 1, one holds half: 2.6 from the middle to a corner, protruding by 2.1, a fifth of the diagonal.
  EXPECT_LE(count(box(10, 1, 1), 0.22), 2U);
  EXPECT_LE(count(torus(), 0.05), 12U);
  EXPECT_LE(count(lBracket(), 0.05), 70U);
}

TEST(CertifiedSpheres, InAnyPositionAndSize) {
  RandomPoints random(2);
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const Eigen::Isometry3d pose = Eigen::Translation3d(scale * random.inCube()) * Eigen::Isometry3d(random.rotation());
    const TriangleMesh mesh = transformed(scaled(lBracket(), Eigen::Vector3d::Constant(scale)), pose);
    expectKept(mesh, certifiedSpheres(mesh, within(0.05 * diagonal(mesh), Effort::kInstant)), 0.05 * diagonal(mesh));
  }
}

TEST(CertifiedSpheres, OfDegenerateMeshes) {
  const TriangleMesh needle{{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}, {{0, 1, 2}}},
      repeated{{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 2, 3}, {1, 2, 3}}};
  const TriangleMesh point{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{0, 1, 2}}};
  for (const TriangleMesh& mesh : {singleTriangle(), needle, repeated})
    expectKept(mesh, certifiedSpheres(mesh, within(0.05, Effort::kInstant)), 0.05);
  EXPECT_EQ(certifiedSpheres(point, within(0.05)).spheres.size(), 1U);
}

TEST(CertifiedSpheres, KnowOfGroovesAndWallsInside) {
  // Two boxes that overlap: seen from inside, the walls in the overlap are no border.
  const TriangleMesh overlapping = merged({box(1, 1, 1), moved(box(1, 1, 1), {0.5, 0, 0})}), whole = box(1.5, 1, 1);
  const double tolerance = 0.1;
  EXPECT_LE(certifiedSpheres(overlapping, within(tolerance)).spheres.size(),
            1.35 * certifiedSpheres(whole, within(tolerance)).spheres.size());
}

TEST(CertifiedSpheres, BeyondTheLimitTheToleranceIsRaised) {
  const TriangleMesh mesh = sheet();
  SphereOptions options = within(0.01);
  options.max_spheres = 50;
  const CertifiedSpheres result = certifiedSpheres(mesh, options);
  EXPECT_LE(result.spheres.size(), 50U);
  EXPECT_TRUE(covers(result.spheres, mesh));
  EXPECT_FALSE(result.within_tolerance);
  EXPECT_GT(result.bound, 0.01);
  EXPECT_NE(result.reason.find("50 spheres do not cover the mesh within the tolerance of 10 mm"), std::string::npos) << result.reason;
  EXPECT_NE(result.reason.find("; raise the limit (max_spheres; max-hulls of a program), or the tolerance"), std::string::npos)
      << result.reason;
  EXPECT_NE(result.reason.find("; " + std::to_string(result.spheres.size()) + " spheres do within " + millimetres(result.bound)),
            std::string::npos)
      << result.reason;
}

SphereOptions atMost(std::size_t spheres, Effort effort = Effort::kQuick) {
  SphereOptions options = within(0.001, effort);
  options.max_spheres = spheres;
  return options;
}

TEST(CertifiedSpheres, UseTheirLimitWell) {
  const TriangleMesh mesh = lBracket();
  double last = std::numeric_limits<double>::infinity();
  for (const std::size_t limit : {1U, 4U, 8U, 16U}) {
    const CertifiedSpheres result = certifiedSpheres(mesh, atMost(limit));
    EXPECT_TRUE(covers(result.spheres, mesh));
    EXPECT_LE(result.spheres.size(), limit);
    EXPECT_GE(result.spheres.size(), 0.75 * static_cast<double>(limit)) << limit;
    EXPECT_LT(result.bound, 0.9 * last) << limit;
    last = result.bound;
  }
  EXPECT_GT(certifiedSpheres(mesh, within(0.85 * last)).spheres.size(), 16U) << "the limit allows a smaller tolerance";
}

TEST(CertifiedSpheres, UseTheirLimitWithoutASearch) {
  const CertifiedSpheres result = certifiedSpheres(lBracket(), atMost(16, Effort::kInstant));
  EXPECT_LE(result.spheres.size(), 16U);
  EXPECT_GE(result.spheres.size(), 12U);
}

/// The first choice of spheres takes more, by one; the search then drops several.
TEST(CertifiedSpheres, ALimitThatTheSearchKeepsIsEnough) {
  const TriangleMesh mesh = lBracket();
  SphereOptions options = within(0.3);
  options.max_spheres = certifiedSpheres(mesh, within(0.3, Effort::kInstant)).spheres.size() - 1;
  const CertifiedSpheres result = certifiedSpheres(mesh, options);
  EXPECT_TRUE(result.within_tolerance) << result.reason;
  EXPECT_LE(result.spheres.size(), options.max_spheres);
}

TEST(CertifiedSpheres, BeyondTheLimitProgressNeverDecreasesAndACancelIsHeard) {
  RunControl control;
  double last = 0;
  control.progress = [&](double share) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1);
    last = share;
  };
  certifiedSpheres(lBracket(), atMost(4, Effort::kInstant), control);
  EXPECT_GT(last, 0.5);
  control.progress = [&](double) { control.cancel(); };
  EXPECT_THROW(certifiedSpheres(lBracket(), atMost(4), control), Error);
}

TEST(CertifiedSpheres, ASingleOneIsSpokenOfAsOne) {
  SphereOptions options = within(0.01);
  options.max_spheres = 1;
  const CertifiedSpheres result = certifiedSpheres(sheet(), options);
  EXPECT_NE(result.reason.find("1 sphere does not cover the mesh within the tolerance of 10 mm; 1 sphere does within "), std::string::npos)
      << result.reason;
}

TEST(CertifiedSpheres, BelowSinglePrecisionTheToleranceIsRaised) {
  const TriangleMesh mesh = moved(sphere(0.001, 3), {100, 0, 0});
  const CertifiedSpheres result = certifiedSpheres(mesh, within(1e-7));
  EXPECT_FALSE(result.within_tolerance);
  EXPECT_NE(result.reason.find("too small"), std::string::npos) << result.reason;
  EXPECT_TRUE(covers(result.spheres, mesh));
}

TEST(CertifiedSpheres, FarFromTheOriginTheToleranceIsRaisedToWhatCanBeProved) {
  const TriangleMesh mesh = test_shapes::moved(test_shapes::box(0.03, 0.02, 0.015), {100, -100, 0});
  for (const double tolerance : {0.0005, 0.001, 0.0015, 0.0041, 0.006}) {
    const CertifiedSpheres result = certifiedSpheres(mesh, {tolerance});
    EXPECT_TRUE(covers(result.spheres, mesh)) << tolerance;
    EXPECT_EQ(result.within_tolerance, tolerance > 0.004) << tolerance << " " << result.reason;
  }
}

TEST(CertifiedSpheres, AreSinglePrecisionNumbersLargestFirst) {
  const CertifiedSpheres result = certifiedSpheres(lBracket(), within(0.1, Effort::kInstant));
  double last = std::numeric_limits<double>::infinity();
  for (const Sphere& sphere : result.spheres) {
    EXPECT_EQ(sphere.centre, sphere.centre.cast<float>().cast<double>());
    EXPECT_EQ(sphere.radius, static_cast<double>(static_cast<float>(sphere.radius)));
    EXPECT_LE(sphere.radius, last);
    last = sphere.radius;
  }
}

TEST(CertifiedSpheres, AreTheSameOnAnyNumberOfThreads) {
  const TriangleMesh mesh = flange();
  for (const SphereOptions& options : {within(0.1), atMost(4)}) {
    std::vector<CertifiedSpheres> results(2);
    for (int jobs : {1, 2}) withJobs(jobs, [&] { results[static_cast<std::size_t>(jobs - 1)] = certifiedSpheres(mesh, options); });
    ASSERT_EQ(results[0].spheres.size(), results[1].spheres.size());
    for (std::size_t s = 0; s < results[0].spheres.size(); ++s) {
      EXPECT_EQ(results[0].spheres[s].centre, results[1].spheres[s].centre);
      EXPECT_EQ(results[0].spheres[s].radius, results[1].spheres[s].radius);
    }
  }
}

TEST(CertifiedSpheres, MoreEffortNeverTakesMore) {
  const TriangleMesh mesh = flask();
  SphereOptions options = within(0.2);
  const std::size_t quick = certifiedSpheres(mesh, options).spheres.size();
  options.effort = Effort::kInstant;
  EXPECT_GT(certifiedSpheres(mesh, options).spheres.size(), quick);
}

TEST(CertifiedSpheres, TheMarginIsPartOfTheBound) {
  const TriangleMesh mesh = lBracket();
  const RepairedMesh repaired = repair(mesh);
  const Solid solid(repaired);
  CertifiedSpheres result = certifiedSpheres({mesh, repaired, solid, 0.02, nullptr, ""}, within(0.1, Effort::kInstant));
  EXPECT_LE(result.bound, 0.1);
  for (double& bound : result.bounds) bound -= 0.02 - 1e-9;
  expectKept(mesh, result, 0.1);
}

/// Far from the origin by the rounding of coordinates (A1 in doc/certified.md), in front of a window by the blur, too.
TEST(CertifiedSpheres, TheBoundAllowsForRounding) {
  const Eigen::Vector3d far(1e6, 0, 0);
  for (const TriangleMesh& mesh : {moved(box(100, 100, 100), far), moved(scaled(boxWithWindow(), Eigen::Vector3d::Constant(1000)), far)}) {
    const Solid solid = solidOf(mesh);
    const double allowance = 1e-12 * boundingBox(mesh).max().x() + solid.sideError(), tolerance = 0.3 * diagonal(mesh);
    const CertifiedSpheres result = certifiedSpheres(mesh, within(tolerance, Effort::kInstant));
    for (std::size_t s = 0; s < result.spheres.size(); ++s) {
      const Sphere& sphere = result.spheres[s];
      const double by_distance = solid.signedDistance(sphere.centre, solid.distanceToSurface(sphere.centre)) + sphere.radius;
      EXPECT_GE(result.bounds[s], std::min(std::max(0.0, by_distance) + allowance, tolerance) - 1e-9 * allowance) << allowance;
    }
  }
}

TEST(CertifiedSpheres, CanBeCancelled) {
  RunControl control;
  control.cancel();
  EXPECT_THROW(certifiedSpheres(flange(), within(0.01), control), Error);
}

TEST(CertifiedSpheres, BadOptionsAndMeshes) {
  SphereOptions none = within(0.1);
  none.max_spheres = 0;
  EXPECT_THROW(certifiedSpheres(box(1, 1, 1), none), Error);
  for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(certifiedSpheres(box(1, 1, 1), within(tolerance)), Error);
  EXPECT_THROW(certifiedSpheres(TriangleMesh{}, within(0.1)), Error);
}

TEST(CertifiedSpheres, RefuseWhatWouldProveNothingOrNeverEnd) {
  const TriangleMesh mesh = box(1, 1, 1);
  const RepairedMesh repaired = repair(mesh);
  const Solid solid(repaired);
  TriangleMesh endless = mesh;
  endless.vertices[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(certifiedSpheres(mesh, within(0.99e-6 * diagonal(mesh))), Error);
  EXPECT_THROW(certifiedSpheres({mesh, repaired, solid, -1e-3, nullptr, ""}, within(0.1)), Error);
  EXPECT_THROW(certifiedSpheres({endless, repaired, solid, 0, nullptr, ""}, within(0.1)), Error);
  EXPECT_THROW(certifiedSpheres({TriangleMesh{}, repaired, solid, 0, nullptr, ""}, within(0.1)), Error);
}

TEST(CertifiedSpheres, ProgressEndsAtOne) {
  RunControl control;
  double last = 0;
  control.progress = [&](double fraction) { last = fraction; };
  certifiedSpheres(box(1, 1, 1), within(0.3), control);
  EXPECT_EQ(last, 1);
}

TEST(Covers, AShavedSphereLeavesAGap) {
  const TriangleMesh mesh = lBracket();
  CertifiedSpheres result = certifiedSpheres(mesh, within(0.1, Effort::kInstant));
  for (Sphere& sphere : result.spheres) sphere.radius *= 0.9;
  EXPECT_FALSE(covers(result.spheres, mesh));
  EXPECT_FALSE(covers({}, mesh));
}

TEST(Covers, ExactlyTheBallThroughTheCorners) {
  const TriangleMesh mesh = moved(box(2, 2, 2), {-1, -1, -1});
  EXPECT_TRUE(covers({{{0, 0, 0}, std::sqrt(3.0) + 1e-9}}, mesh));
  EXPECT_FALSE(covers({{{0, 0, 0}, std::sqrt(3.0) + 5e-13}}, mesh)) << "less than rounding";
  EXPECT_FALSE(covers({{{0, 0, 0}, std::sqrt(3.0) - 1e-5}}, mesh));
}

}  // namespace
}  // namespace collision_hulls
