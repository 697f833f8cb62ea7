// The promise, checked from outside: cover, bound, status and reason of each method, on shapes whose protrusion is known.
#include "collision_hulls/decompose/certified_hulls.h"

#include <gtest/gtest.h>

#include <atomic>

#include "collision_hulls/decompose/certified.h"
#include "collision_hulls/error.h"
#include "geometry/bytes.h"
#include "solids.h"

namespace collision_hulls {
namespace {

DecomposeOptions within(double tolerance, Method method = Method::kCertified) {
  DecomposeOptions options;
  options.method = method;
  options.tolerance = tolerance;
  return options;
}

/// A channel 0.2 wide and high and 0.4 long with walls of 0.02: its hull fills a gap 0.16 wide and 0.18 deep.
TriangleMesh channel() {
  return test_shapes::uChannel(0.2, 0.2, 0.02, 0.4);
}
constexpr double kHalfGap = 0.08;  // [m] the furthest that a point in the gap is from a wall

void expectError(ErrorCode code, const std::string& part, const std::function<void()>& call) {
  try {
    call();
    ADD_FAILURE() << "accepted, though " << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

/// Cover and bound, of the hulls as they are returned.
void expectPromise(const TriangleMesh& mesh, const CertifiedHulls& result, double tolerance) {
  EXPECT_EQ(uncovered(mesh, result.hulls), 0);
  EXPECT_LE(result.found, result.bound);
  EXPECT_EQ(result.within_tolerance, result.bound <= tolerance);
  EXPECT_EQ(result.within_tolerance, result.reason.empty()) << result.reason;
  const Solid solid = test_shapes::solidOf(mesh);
  EXPECT_NEAR(solid.distance(result.where), result.found, 1e-12);
  EXPECT_NEAR((result.where - result.nearest).norm(), result.found, 1e-12);
  for (const ConvexHull& hull : result.hulls) {
    for (const Eigen::Vector3d& v : hull.vertices) {
      EXPECT_LE(solid.distance(v), result.bound);
      EXPECT_EQ(v, v.cast<float>().cast<double>()) << "what is proved is not what a file would hold";
    }
  }
}

/// A folded sheet has more facets than `instant` divides a mesh into. At twice the tolerance they need not be told apart.
TEST(CertifiedHulls, AToleranceThatAsksForTooManyPiecesGivesWayToTheNext) {
  constexpr double kHeight = 5e-4, kTolerance = 2e-4;
  TriangleMesh sheet;
  for (int i = 0; i <= 1100; ++i)
    for (const double y : {0.0, 0.01}) sheet.vertices.emplace_back(1e-3 * i, y, kHeight * (i % 2));
  for (int i = 0; i < 1100; ++i) {
    sheet.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    sheet.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  DecomposeOptions options = within(kTolerance);
  options.effort = Effort::kInstant;
  const CertifiedHulls result = certifiedHulls(sheet, options);
  expectPromise(sheet, result, kTolerance);
  EXPECT_GT(result.bound, kTolerance);
  EXPECT_LE(result.bound, 2 * kTolerance);
  EXPECT_LT(result.hulls.size(), 1000u) << "pieces that were not merged";
  EXPECT_NE(result.reason.find("more pieces than a mesh is divided into; raise it to what the hulls keep"), std::string::npos)
      << result.reason;
}

TEST(CertifiedHulls, RefusesWhatItCannotCertify) {
  const TriangleMesh box = test_shapes::box(1, 2, 3);
  expectError(ErrorCode::kEmptyMesh, "no triangles", [] { certifiedHulls(TriangleMesh(), within(0.1)); });
  for (const Method method : allMethods())
    for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
      expectError(ErrorCode::kBadOption, "tolerance", [&] { certifiedHulls(box, within(tolerance, method)); });
  const double finest = 1e-6 * diagonal(box);
  for (const Method method : allMethods())
    expectError(ErrorCode::kBadOption, "millionth", [&] { certifiedHulls(box, within(0.99 * finest, method)); });
  EXPECT_TRUE(certifiedHulls(box, within(1.01 * finest)).within_tolerance);
  TriangleMesh wrong = box;
  wrong.triangles[0][0] = 99;
  expectError(ErrorCode::kIndexOutOfRange, "", [&] { certifiedHulls(wrong, within(0.1)); });
  const TriangleMesh far = test_shapes::moved(box, {1e6, 0, 0}), vast = scaled(box, Eigen::Vector3d::Constant(1e39));
  expectError(ErrorCode::kTooFarFromOrigin, "move the mesh to its origin", [&] { certifiedHulls(far, within(0.1)); });
  expectError(ErrorCode::kNonFiniteCoordinate, "single precision", [&] { certifiedHulls(vast, within(1e38)); });
  const RunControl control;
  control.cancel();
  expectError(ErrorCode::kCancelled, "", [&] { certifiedHulls(box, within(0.1), control); });
}

TEST(CertifiedHulls, RefuseAPreparedMeshThatIsNotSound) {
  const TriangleMesh box = test_shapes::box(1, 1, 1);
  const RepairedMesh repaired = repair(box);
  const Solid solid(repaired);
  TriangleMesh endless = box, wrong = box;
  endless.vertices[2].y() = std::nan("");
  wrong.triangles[0][0] = 99;
  expectError(ErrorCode::kNonFiniteCoordinate, "vertex 2", [&] {
    certifiedHulls({endless, repaired, solid, 0, nullptr, ""}, within(0.1));
  });
  expectError(ErrorCode::kIndexOutOfRange, "vertex 99", [&] { certifiedHulls({wrong, repaired, solid, 0, nullptr, ""}, within(0.1)); });
  const std::vector<ConvexHull> hulls{convexHull(box.vertices)};
  expectError(ErrorCode::kNonFiniteCoordinate, "vertex 2", [&] { expectCovered(endless, hulls, ""); });
}

/// A bound that includes less than how far the surfaces may be apart is none.
TEST(CertifiedHulls, RefuseMarginsThatAreTooSmall) {
  TriangleMesh mesh = channel();
  const auto corner = static_cast<int>(mesh.vertices.size());
  mesh.vertices.emplace_back(mesh.vertices[0] + Eigen::Vector3d(1e-7, 0, 0));  // is welded
  mesh.triangles[0][0] = mesh.triangles[0][0] == 0 ? corner : mesh.triangles[0][0];
  const RepairedMesh repaired = repair(mesh);
  const Solid solid(repaired);
  const auto with = [&](double margin) { certifiedHulls({mesh, repaired, solid, margin, nullptr, ""}, within(0.01)); };
  const double least = repaired.counts.weld_distance;
  ASSERT_GT(least, 0);
  for (const double margin : {0.999 * least, -1e-3, std::nan(""), std::numeric_limits<double>::infinity()})
    expectError(ErrorCode::kBadOption, "margin is", [&] { with(margin); });
  EXPECT_NO_THROW(with(least));
  const std::vector<ConvexHull> hulls{convexHull(mesh.vertices)};
  for (const double margin : {-0.05, std::nan("")})
    expectError(ErrorCode::kBadOption, "margin is", [&] { certificate(hulls, solid, margin, 0.01); });
  expectError(ErrorCode::kBadOption, "tolerance is", [&] { certificate(hulls, solid, 0, -0.01); });
}

TEST(CertifiedHulls, OfOneTriangleAndOfOnePoint) {
  for (const TriangleMesh& mesh :
       {TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, TriangleMesh{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{0, 1, 2}}}}) {
    const CertifiedHulls result = certifiedHulls(mesh, within(0.01));
    ASSERT_EQ(result.hulls.size(), 1u);
    EXPECT_EQ(uncovered(mesh, result.hulls), 0);
    EXPECT_GT(result.thickness, 0);
    EXPECT_LT(result.bound, 1e-4);
    EXPECT_TRUE(result.within_tolerance) << result.reason;
  }
}

TEST(CertifiedHulls, KeepThePromiseForEveryMethod) {
  const TriangleMesh mesh = channel();
  for (const Method method : allMethods()) {
    SCOPED_TRACE(name(method));
    expectPromise(mesh, certifiedHulls(mesh, within(0.01, method)), 0.01);
  }
}

TEST(CertifiedHulls, SayHowFarASingleHullProtrudes) {
  const CertifiedHulls result = certifiedHulls(channel(), within(0.01, Method::kSingleHull));
  EXPECT_NEAR(result.found, kHalfGap, 1e-4);
  EXPECT_GE(result.bound, kHalfGap);
  EXPECT_LE(result.bound, kHalfGap + 2e-4);
  EXPECT_FALSE(result.within_tolerance);
  EXPECT_EQ(result.reason,
            "the hulls protrude by up to 80.04 mm, more than the tolerance of 10 mm: single_hull ignores the tolerance; "
            "if that is too far, use certified, and if it is not, raise the tolerance");
}

TEST(CertifiedHulls, AreThreeForAChannel) {
  const CertifiedHulls result = certifiedHulls(channel(), within(0.01));
  EXPECT_EQ(result.hulls.size(), 3u);
  EXPECT_TRUE(result.within_tolerance) << result.reason;
  const CertifiedHulls coarse = certifiedHulls(channel(), within(kHalfGap + 0.001));
  EXPECT_EQ(coarse.hulls.size(), 1u);
  EXPECT_TRUE(coarse.within_tolerance) << coarse.reason;
}

// A tolerance that the bound exceeds only by the search's gap must not count as exceeded: the gap is narrowed there. A single hull
// protrudes by half the gap exactly, and by rounding.
/// Where hulls lie in the faces of a part, all of its surface is nearly as far from them; the bound comes down to the gap all the same.
TEST(CertifiedHulls, OfFlatCutsAreCertifiedClosely) {
  for (const TriangleMesh& mesh : {test_shapes::lBracket(0.1, 0.012, 0.05), channel()}) {
    const double tolerance = 0.001 * diagonal(mesh);
    const CertifiedHulls result = certifiedHulls(mesh, within(tolerance));
    EXPECT_LE(result.found, 0.001 * tolerance);
    EXPECT_LE(result.bound, 0.003 * tolerance);
  }
}

TEST(CertifiedHulls, NarrowTheGapWhereItDecides) {
  const double tolerance = kHalfGap * (1 + 0.3 * kCertificateGap);
  const CertifiedHulls result = certifiedHulls(channel(), within(tolerance, Method::kSingleHull));
  EXPECT_TRUE(result.within_tolerance) << result.reason;
  EXPECT_LE(result.bound - result.found, 0.3 * kCertificateGap * tolerance);
}

TEST(CertifiedHulls, ReasonsNameTheCause) {
  const TriangleMesh mesh = channel();
  const auto reason = [&](Method method, int max_hulls) {
    DecomposeOptions options = within(0.01, method);
    options.max_hulls = max_hulls;
    return certifiedHulls(mesh, options).reason;
  };
  EXPECT_NE(reason(Method::kBoundingBox, 0).find("bounding_box ignores the tolerance"), std::string::npos);
  EXPECT_NE(reason(Method::kCertified, 1).find("the limit (max-hulls 1) made the hulls coarser; raise it"), std::string::npos);
  EXPECT_NE(reason(Method::kHacd, 0).find("hacd measures concavity along rays"), std::string::npos);
  EXPECT_NE(reason(Method::kAcd, 1).find("the limits (max-hulls 1, max-vertices 64) made the hulls coarser; raise them"),
            std::string::npos);
}

// Welding moves points: the hulls must cover them where they were, and the bound must include by how much the solid is uncertain.
TEST(CertifiedHulls, CoverTheMeshAsGivenAndNotAsWelded) {
  TriangleMesh mesh = test_shapes::box(1, 1, 1);
  mesh.vertices.push_back(mesh.corner(11, 0) + Eigen::Vector3d::Constant(4e-6));  // a copy of a corner, off by a little
  mesh.triangles[11][0] = static_cast<int>(mesh.vertices.size()) - 1;
  const double moved = repair(mesh).counts.weld_distance;
  ASSERT_GT(moved, 5e-6);
  const CertifiedHulls result = certifiedHulls(mesh, within(0.001));
  ASSERT_EQ(result.hulls.size(), 1u);
  EXPECT_EQ(uncovered(mesh, result.hulls), 0);
  EXPECT_GE(result.nudge, moved);
  EXPECT_GE(result.bound, result.found + moved);
  const CertifiedHulls loose = certifiedHulls(mesh, within(result.found + moved / 2));
  EXPECT_FALSE(loose.within_tolerance);
  EXPECT_NE(loose.reason.find("no point was found further out than "), std::string::npos) << loose.found << " " << loose.reason;
}

// Single precision is coarse far from the origin. What rounding adds there is not known beforehand, so the first attempt exceeds the
// tolerance, and another has to aim lower.
TEST(CertifiedHulls, TryAgainWhereRoundingExceedsTheTolerance) {
  const TriangleMesh ring = test_shapes::moved(test_shapes::torus(1, 0.3, 24, 12), {30000, 0, 0});
  const CertifiedHulls result = certifiedHulls(ring, within(0.1));
  EXPECT_GT(result.nudge, 0.005);
  EXPECT_TRUE(result.within_tolerance) << result.reason;
  EXPECT_EQ(uncovered(ring, result.hulls), 0);
}

/// Rings of six points, joined by walls and closed at both ends, but for three triangles.
TriangleMesh barrelWithHoles() {
  constexpr int kAround = 6;
  TriangleMesh barrel;
  for (const auto& [radius, z] : {std::pair{0.3, 0.0}, {0.6, 0.4}, {0.9, 0.8}, {0.5, 1.2}})
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2 * std::acos(-1) * i / kAround;
      barrel.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  for (int i = 0; i < 3 * kAround; ++i) {
    const int beside = i % kAround == kAround - 1 ? i + 1 - kAround : i + 1;
    barrel.triangles.push_back({i, beside, beside + kAround});
    barrel.triangles.push_back({i, beside + kAround, i + kAround});
  }
  const int top = 3 * kAround;
  for (int i = 1; i + 1 < kAround; ++i) {
    barrel.triangles.push_back({0, i + 1, i});
    barrel.triangles.push_back({top, top + i, top + i + 1});
  }
  for (const int hole : {43, 32, 27}) barrel.triangles.erase(barrel.triangles.begin() + hole);
  return barrel;
}

// At openings the distance to the solid jumps, so that hulls as they are written may protrude further than those that were looked for. An
// aim that is a little lower leads to the same hulls again; that is no reason to give up.
TEST(CertifiedHulls, TryAgainWhereALowerAimLedToTheSameHulls) {
  const TriangleMesh barrel = barrelWithHoles();
  const CertifiedHulls result = certifiedHulls(barrel, within(0.12));
  EXPECT_TRUE(result.within_tolerance) << result.reason;
  expectPromise(barrel, result, 0.12);
}

// What is found may keep the tolerance although what is proved does not.
TEST(CertifiedHulls, TheBoundDecides) {
  const TriangleMesh mesh = channel();
  const RepairedMesh repaired = repair(mesh);
  const Solid solid(repaired);
  const CertifiedHulls result = certifiedHulls({mesh, repaired, solid, 0.001, nullptr, ""}, within(kHalfGap + 0.0005, Method::kSingleHull));
  EXPECT_LT(result.found, kHalfGap + 0.0005);
  EXPECT_GT(result.bound, kHalfGap + 0.0005);
  EXPECT_FALSE(result.within_tolerance);
}

TEST(CertifiedHulls, OfAPreparedMeshAreTheSame) {
  const TriangleMesh mesh = channel();
  const RepairedMesh repaired = repair(mesh);
  const Solid solid(repaired);
  const CertifiedHulls one = certifiedHulls(mesh, within(0.01));
  const CertifiedHulls other = certifiedHulls({mesh, repaired, solid, repaired.counts.weld_distance, nullptr, ""}, within(0.01));
  EXPECT_EQ(toBytes(one.hulls), toBytes(other.hulls));
  EXPECT_EQ(one.bound, other.bound);
  EXPECT_GT(one.seconds.repair, 0);
  EXPECT_EQ(other.seconds.repair, 0);
  EXPECT_GT(other.seconds.decompose * other.seconds.certify, 0);
}

TEST(CertifiedHulls, IncludeTheMarginInTheBoundAndInTheHulls) {
  const TriangleMesh mesh = channel();
  const RepairedMesh repaired = repair(mesh);
  const Solid solid(repaired);
  const double margin = 1e-3;
  const CertifiedHulls result = certifiedHulls({mesh, repaired, solid, margin, nullptr, ""}, within(0.01));
  EXPECT_TRUE(result.within_tolerance) << result.reason;
  EXPECT_GE(result.bound, result.found + margin);
  EXPECT_GE(result.nudge, margin);
  for (const Eigen::Vector3d& v : mesh.vertices) {
    const auto holdsWithMargin = [&](const ConvexHull& hull) { return planeDistance(hull, v) <= -0.999 * margin; };
    EXPECT_TRUE(std::any_of(result.hulls.begin(), result.hulls.end(), holdsWithMargin)) << v.transpose();
  }
}

TEST(CertifiedHulls, AreACutThroughATree) {
  const TriangleMesh mesh = channel();
  const RepairedMesh repaired = repair(mesh);
  const Solid solid(repaired);
  const HullTree tree = hullTree(repaired, within(0.001));
  const auto cut = [&](double tolerance, int max_hulls) {
    DecomposeOptions options = within(tolerance);
    options.max_hulls = max_hulls;
    const CertifiedHulls result = certifiedHulls({mesh, repaired, solid, 0, &tree, ""}, options);
    expectPromise(mesh, result, tolerance);
    return result;
  };
  EXPECT_EQ(cut(0.01, 0).hulls.size(), 3u);
  EXPECT_EQ(cut(0.09, 0).hulls.size(), 1u);
  EXPECT_NE(cut(0.01, 1).reason.find("max-hulls 1"), std::string::npos);
  const HullTree coarse = hullTree(repaired, within(0.09));
  const CertifiedHulls fine = certifiedHulls({mesh, repaired, solid, 0, &coarse}, within(0.001));
  EXPECT_NE(fine.reason.find("the leaves of the hull tree are made for 90 mm; give that tolerance, or make a tree"), std::string::npos)
      << fine.reason;
}

TEST(CertifiedHulls, ReportProgressThatNeverDecreasesAndEndsAtOne) {
  const TriangleMesh torus = test_shapes::torus(0.1, 0.03, 24, 12);
  TriangleMesh far = torus;
  for (Eigen::Vector3d& v : far.vertices) v = (v + Eigen::Vector3d(2000, 0, 0)).cast<float>().cast<double>();
  // The last takes a second attempt, as single precision is coarse there.
  for (const auto& [mesh, options] : {std::pair{channel(), within(0.001)}, {torus, within(0.004)}, {far, within(8e-4)}}) {
    RunControl control;
    double last = 0;
    control.progress = [&](double fraction) {
      EXPECT_GE(fraction, last);
      last = fraction;
    };
    certifiedHulls(mesh, options, control);
    EXPECT_EQ(last, 1);
  }
}

TEST(ExpectCovered, NamesTheMesh) {
  const TriangleMesh box = test_shapes::box(1, 1, 1);
  const std::vector<ConvexHull> half = {convexHull(test_shapes::box(1, 1, 0.5).vertices)};
  expectError(ErrorCode::kInternal, "uncovered by up to 500 mm; the limit is 0. Please report the mesh 'box.stl'",
              [&] { expectCovered(box, half, "box.stl"); });
  EXPECT_NO_THROW(expectCovered(box, {convexHull(box.vertices)}, "box.stl"));
}

// Deadlines. That of an hour never passes here; that of now has passed when the search begins.

RunControl::Time soon(int hours) {
  return std::chrono::steady_clock::now() + std::chrono::hours(hours);
}

TEST(Deadline, ThatIsFarChangesNothing) {
  RunControl control;
  control.deadline = soon(1);
  for (const TriangleMesh& mesh : {channel(), test_shapes::torus(0.1, 0.03, 24, 12)}) {
    const CertifiedHulls free = certifiedHulls(mesh, within(0.004)), result = certifiedHulls(mesh, within(0.004), control);
    EXPECT_EQ(toBytes(result.hulls), toBytes(free.hulls));
    EXPECT_EQ(result.untried, "");
  }
}

TEST(Deadline, ThatHasPassedLeavesAHullThatCovers) {
  RunControl control;
  control.deadline = soon(0);
  const CertifiedHulls result = certifiedHulls(channel(), within(0.004), control);
  expectPromise(channel(), result, 0.004);
  EXPECT_EQ(result.hulls.size(), 1u);
  EXPECT_GE(result.bound, kHalfGap);
  EXPECT_NE(result.untried.find("the division of all of the surface"), std::string::npos) << result.untried;
  EXPECT_NE(result.reason.find("raise the time limit"), std::string::npos) << result.reason;
}

}  // namespace
}  // namespace collision_hulls
