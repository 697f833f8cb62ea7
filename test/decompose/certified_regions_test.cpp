// Regions, checked from outside: what hulls do in them, and what is said about it.
#include <gtest/gtest.h>

#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/error.h"
#include "geometry/bytes.h"
#include "solids.h"

namespace collision_hulls {
namespace {

Eigen::Isometry3d at(const Eigen::Vector3d& place) {
  return Eigen::Isometry3d(Eigen::Translation3d(place));
}

/// Two channels 0.2 wide and high, 0.4 long, with walls of 0.02: their gaps are 0.16 wide.
TriangleMesh twoChannels() {
  const TriangleMesh one = test_shapes::uChannel(0.2, 0.2, 0.02, 0.4);
  return test_shapes::merged({one, test_shapes::moved(one, {1, 0, 0})});
}

/// In the first channel's gap, 1 cm away from its walls.
Region inFirstGap() {
  const Eigen::AlignedBox3d box = boundingBox(test_shapes::uChannel(0.2, 0.2, 0.02, 0.4));
  Region region = boxRegion({0.14, 0.3, 0.6}, at(box.center() + Eigen::Vector3d(0, 0.08, 0)), kRegionSlack);
  region.name = "gap";
  return region;
}

DecomposeOptions within(double tolerance, const std::vector<Region>& regions) {
  DecomposeOptions options;
  options.tolerance = tolerance;
  options.regions = regions;
  return options;
}

bool isDeepIn(const Region& region, const Eigen::Vector3d& p) {
  for (const HalfSpace& side : region.sides)
    if (side.distance(p) > -kRegionRim) return false;
  return true;
}

/// The largest distance from the solid among points of hulls in the region; negative: no point is there.
double sampled(const std::vector<ConvexHull>& hulls, const Region& region, const Solid& solid) {
  test_shapes::RandomPoints random(7);
  double most = -1;
  for (const ConvexHull& hull : hulls) {
    for (int i = 0; i < 3000; ++i) {
      const Eigen::Vector3d p = i % 2 ? random.on(surface(hull)) : test_shapes::inHull(hull, random);
      if (isDeepIn(region, p)) most = std::max(most, solid.distance(p));
    }
  }
  return most;
}

TEST(CertifiedRegions, AGapIsKeptClearWithFewerHullsThanByAToleranceForAll) {
  const TriangleMesh mesh = twoChannels();
  const Solid solid = test_shapes::solidOf(mesh);
  const CertifiedHulls coarse = certifiedHulls(mesh, within(0.1, {}));
  EXPECT_EQ(coarse.hulls.size(), 2u);
  EXPECT_GT(sampled(coarse.hulls, inFirstGap(), solid), 0.05) << "the gap is filled where nobody asks for it";

  const CertifiedHulls clear = certifiedHulls(mesh, within(0.1, {inFirstGap()}));
  EXPECT_TRUE(clear.within_tolerance) << clear.reason;
  EXPECT_EQ(clear.hulls.size(), 4u) << "three walls, and the other channel whole";
  EXPECT_LT(sampled(clear.hulls, inFirstGap(), solid), 0) << "no hull is in the gap";
  EXPECT_EQ(clear.regions.at(0).bound, 0);
  EXPECT_EQ(uncovered(mesh, clear.hulls), 0);

  const CertifiedHulls fine = certifiedHulls(mesh, within(0.03, {}));
  EXPECT_EQ(fine.hulls.size(), 6u);
}

TEST(CertifiedRegions, AFinerToleranceOnOneSide) {
  const TriangleMesh mesh = test_shapes::torus(1, 0.3, 48, 24);
  const Solid solid = test_shapes::solidOf(mesh);
  const Region right = halfSpaceRegion({1, 0, 0}, 0.5, 0.02);
  const CertifiedHulls some = certifiedHulls(mesh, within(0.15, {right}));
  const CertifiedHulls none = certifiedHulls(mesh, within(0.15, {}));
  const CertifiedHulls all = certifiedHulls(mesh, within(0.02, {}));
  EXPECT_TRUE(some.within_tolerance) << some.reason;
  EXPECT_LT(none.hulls.size(), some.hulls.size());
  EXPECT_LT(some.hulls.size(), all.hulls.size());
  const RegionProof proof = some.regions.at(0);
  EXPECT_LE(proof.bound, 0.02);
  EXPECT_LE(proof.found, proof.bound);
  EXPECT_GT(proof.found, 0.9 * sampled(some.hulls, right, solid));
  EXPECT_LE(sampled(some.hulls, right, solid), proof.bound);
  EXPECT_GT(some.bound, 0.02) << "elsewhere the hulls protrude further";
}

TEST(CertifiedRegions, ABoundIsTruthfulWhereTheToleranceIsExceeded) {
  DecomposeOptions options = within(0.1, {inFirstGap()});
  options.method = Method::kSingleHull;
  const TriangleMesh mesh = test_shapes::uChannel(0.2, 0.2, 0.02, 0.4);
  const CertifiedHulls result = certifiedHulls(mesh, options);
  const double seen = sampled(result.hulls, inFirstGap(), test_shapes::solidOf(mesh));
  EXPECT_LE(result.bound, 0.1);
  EXPECT_FALSE(result.within_tolerance) << "because of the region alone";
  EXPECT_GT(seen, 0.05);
  EXPECT_LE(seen, result.regions.at(0).bound);
  EXPECT_NE(result.reason.find("in region 'gap' the hulls protrude by up to"), std::string::npos) << result.reason;
  EXPECT_NE(result.reason.find("if that is too far, use certified"), std::string::npos) << result.reason;
}

/// Of the hull of a channel, between 1 and 5 cm above its floor and in the middle between its walls, which are further away.
TEST(CertifiedRegions, TheBoundIsTheHeightAboveTheFloorAndTheMargin) {
  const TriangleMesh mesh = test_shapes::uChannel(0.2, 0.2, 0.02, 0.4);
  const RepairedMesh repaired = repair(mesh);
  const Solid solid(repaired);
  DecomposeOptions options = within(0.1, {boxRegion({0.1, 0.04, 0.2}, at({0.1, 0.05, 0.2}), 0.05)});
  options.method = Method::kSingleHull;
  for (const double margin : {0.0, 0.01}) {
    const RegionProof proof = certifiedHulls({mesh, repaired, solid, margin, nullptr, ""}, options).regions.at(0);
    EXPECT_NEAR(proof.found, 0.05, 1e-4);
    EXPECT_GE(proof.bound, 0.05 - kRegionRim + margin);
    EXPECT_LE(proof.bound, 0.0502 + margin);
  }
}

TEST(CertifiedRegions, LimitsAreNamedWhereTheyAreToBlame) {
  DecomposeOptions options = within(0.1, {inFirstGap()});
  options.max_hulls = 2;
  const CertifiedHulls result = certifiedHulls(twoChannels(), options);
  EXPECT_EQ(result.hulls.size(), 2u);
  EXPECT_FALSE(result.within_tolerance);
  EXPECT_NE(result.reason.find("max-hulls 2"), std::string::npos) << result.reason;
}

TEST(CertifiedRegions, WhatIsFarAwayOrCoarserChangesNothing) {
  const TriangleMesh mesh = twoChannels();
  const std::string plain = toBytes(certifiedHulls(mesh, within(0.05, {})).hulls);
  const Region far = boxRegion({1, 1, 1}, at({9, 9, 9}), kRegionSlack);
  EXPECT_EQ(toBytes(certifiedHulls(mesh, within(0.05, {far})).hulls), plain);
  Region coarse = inFirstGap();
  coarse.tolerance = 0.2;
  EXPECT_EQ(toBytes(certifiedHulls(mesh, within(0.05, {coarse})).hulls), plain);
}

// The search for such hulls has no end.
TEST(CertifiedRegions, AToleranceFinerThanCoordinatesIsRefused) {
  const TriangleMesh mesh = twoChannels();
  Region gap = inFirstGap();
  gap.tolerance = 0.99e-6 * diagonal(mesh);
  try {
    certifiedHulls(mesh, within(0.05, {gap}));
    ADD_FAILURE() << "it is taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
    EXPECT_NE(std::string(error.what()).find("the tolerance of region 'gap' of"), std::string::npos) << error.what();
  }
  const TriangleMesh hall = test_shapes::box(300, 300, 300);
  const Region clear = halfSpaceRegion({1, 0, 0}, 1000, kRegionSlack);
  EXPECT_NO_THROW(certifiedHulls(hall, within(0.05, {clear}))) << "what keeps a region clear is fine enough for a mesh of any size";
}

TEST(CertifiedRegions, APlaneThatTheMeshStandsOnCostsNothing) {
  const TriangleMesh ring = test_shapes::moved(test_shapes::torus(0.1, 0.03, 32, 16), {0, 0, 0.03});
  DecomposeOptions options = within(0.05, {});
  options.max_vertices = 0;  // fewer vertices make hulls larger, also below the plane
  const std::size_t free = certifiedHulls(ring, options).hulls.size();
  options.regions = {halfSpaceRegion({0, 0, -1}, 0, kRegionSlack)};
  const CertifiedHulls standing = certifiedHulls(ring, options);
  EXPECT_TRUE(standing.within_tolerance) << standing.reason;
  EXPECT_EQ(standing.hulls.size(), free);
}

}  // namespace
}  // namespace collision_hulls
