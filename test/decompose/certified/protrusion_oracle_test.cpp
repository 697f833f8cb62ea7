// Also tests src/decompose/certified/rough_hull.cpp.
#include "decompose/certified/protrusion_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "collision_hulls/decompose/reduce_vertices.h"
#include "subject.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

/// The largest distance of a vertex of `hull` from `inner`, which `hull` contains.
double shrinkage(const ConvexHull& inner, const ConvexHull& hull) {
  double most = 0;
  for (const Eigen::Vector3d& v : hull.vertices) most = std::max(most, distance(inner, v));
  return most;
}

TEST(RoughHull, ContainsItsPoints) {
  RandomPoints random(1);
  for (double place : {0.0, 100.0}) {
    std::vector<Eigen::Vector3d> points = random.cloud(200);
    for (Eigen::Vector3d& p : points) p += Eigen::Vector3d::Constant(place);
    const ConvexHull rough = roughHull(points);
    for (const Eigen::Vector3d& p : points) EXPECT_LE(planeDistance(rough, p), 1e-12 * (1 + place));
    EXPECT_NEAR(volume(rough), volume(convexHull(points)), 1e-9);
  }
}

// Hulls of overlapping sets then have facets in common, bit by bit.
TEST(RoughHull, ItsVerticesAreItsPoints) {
  RandomPoints random(2);
  for (std::vector<Eigen::Vector3d> points : {random.cloud(100), flange(40, 0.4, 1, 0.01, 0.15, 20).vertices}) {
    for (Eigen::Vector3d& p : points) p += Eigen::Vector3d(0.1, 10. / 3, 7);
    for (const Eigen::Vector3d& v : roughHull(points).vertices) EXPECT_EQ(std::count(points.begin(), points.end(), v), 1);
  }
}

TEST(RoughHull, IsABodyEvenForDegeneratePoints) {
  EXPECT_GT(volume(roughHull({{1, 2, 3}})), 0);
  EXPECT_GT(volume(roughHull({{0, 0, 0}, {1, 0, 0}})), 0);
  EXPECT_GT(volume(roughHull(sheet().vertices)), 0);
}

TEST(Thinned, KeepsSmallAndFlatHulls) {
  const ConvexHull small = hullOf(sphere(1, 3)), plate = hullOf(sheet(1, 1, 20));
  EXPECT_EQ(thinned(small, 100).vertices, small.vertices);
  EXPECT_EQ(thinned(plate, 2).vertices, plate.vertices);
}

TEST(Thinned, StaysInsideAndClose) {
  for (const TriangleMesh& mesh : {sphere(1, 30), flange(40, 0.4, 1, 0.01, 0.15, 20)}) {
    const ConvexHull hull = hullOf(mesh);
    double last = std::numeric_limits<double>::infinity();
    for (std::size_t most : {50, 200, 700}) {
      const ConvexHull thin = thinned(hull, most);
      EXPECT_LE(thin.vertices.size(), most);
      for (const Eigen::Vector3d& v : thin.vertices) EXPECT_LE(planeDistance(hull, v), 1e-9);
      const double shrunk = shrinkage(thin, hull);
      EXPECT_LT(shrunk, last);
      last = shrunk;
    }
    EXPECT_LE(last, 0.02);
  }
}

TEST(Holds, PointsInside) {
  const ConvexHull cube = boxHull({0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(holds(cube, {0.5, 0.5, 0.5}));
  EXPECT_FALSE(holds(cube, {0.5, 0.5, 1.01}));
  RandomPoints random(3);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d p = random.inCube(2);
    EXPECT_EQ(holds(cube, p), p.minCoeff() >= 0 && p.maxCoeff() <= 1) << p.transpose();
  }
}

TEST(Oracle, ExactBoxesFit) {
  Subject subject(box(1, 2, 3), 0.01);
  const ConvexHull hull = hullOf(subject.mesh.mesh);
  EXPECT_TRUE(subject.oracle.mayFit(hull));
  EXPECT_TRUE(subject.oracle.mayWellFit(hull));
  EXPECT_TRUE(subject.oracle.fits(hull));
  EXPECT_LE(subject.oracle.bound({hull}), 0.02 * 0.01);
}

TEST(Oracle, TheHullOfAChannelDoesNotFitButItsWallsDo) {
  Subject subject(uChannel(), 0.05);
  EXPECT_FALSE(subject.oracle.fits(hullOf(subject.mesh.mesh)));
  EXPECT_FALSE(subject.oracle.mayFit(hullOf(subject.mesh.mesh)));
  for (const ConvexHull& wall : {boxHull({0, 0, 0}, {1, 0.1, 2}), boxHull({0, 0, 0}, {0.1, 1, 2}), boxHull({0.9, 0, 0}, {1, 1, 2})})
    EXPECT_TRUE(subject.oracle.fits(wall));
}

/// A lid at a known distance above the top of a box: the answer changes at the tolerance, less a small reserve.
TEST(Oracle, AnswerChangesAtTheTolerance) {
  const TriangleMesh cube = box(1, 1, 1);
  for (double tolerance : {0.2, 0.05, 0.01}) {
    const auto raised = [&](double share) { return boxHull({0.2, 0.2, 0}, {0.8, 0.8, 1 + share * tolerance}); };
    const RunControl control;
    const Solid solid = solidOf(cube);
    ProtrusionOracle oracle(solid, {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 2)}, tolerance, control);
    EXPECT_TRUE(oracle.fits(raised(0.95)));
    EXPECT_TRUE(oracle.fits(raised(0.998))) << "the reserve is small";
    EXPECT_FALSE(oracle.fits(raised(1.001)));
    EXPECT_TRUE(oracle.fits(raised(0.95))) << "even after it rejected another hull";
    EXPECT_FALSE(oracle.fits(raised(3)));
    oracle.setShare(0.5);
    EXPECT_TRUE(oracle.mayFit(raised(0.4)));
    EXPECT_FALSE(oracle.mayFit(raised(0.8)));
    oracle.setShare(1);
    oracle.setTolerance(4 * tolerance);
    EXPECT_TRUE(oracle.fits(raised(3)));
  }
}

TEST(Oracle, WhatRefutedAHullRefutesPointsWithoutOne) {
  Subject subject(uChannel(), 0.05);
  const std::vector<Eigen::Vector3d>& all = subject.mesh.mesh.vertices;
  EXPECT_FALSE(subject.oracle.refutes(all)) << "nothing is known yet";
  EXPECT_FALSE(subject.oracle.mayFit(hullOf(subject.mesh.mesh)));
  EXPECT_TRUE(subject.oracle.refutes(all));
  EXPECT_FALSE(subject.oracle.refutes(boxHull({0, 0, 0}, {0.1, 1, 2}).vertices));
}

/// Slightly above the tolerance: only a proof finds it, or an oracle that remembers what a proof found.
TEST(Oracle, IntrudersArePassedOn) {
  const ConvexHull raised = convexHull({{0.2, 0.2, 0}, {0.8, 0.2, 0}, {0.8, 0.8, 0}, {0.2, 0.8, 0}, {0.513, 0.471, 1.101}});
  Subject subject(box(1, 1, 1), 0.1);
  const Eigen::AlignedBox3d whole(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 2)), below(whole.min(), Eigen::Vector3d(1, 1, 0.5));
  const RunControl control;
  ProtrusionOracle oracle(subject.solid, whole, 0.1, control);
  ProtrusionOracle for_all = oracle.forPart(whole), for_part = oracle.forPart(below);
  EXPECT_TRUE(for_all.mayFit(raised));
  EXPECT_FALSE(for_all.fits(raised));
  EXPECT_FALSE(for_all.mayFit(raised));
  EXPECT_TRUE(oracle.mayFit(raised));
  oracle.learn(for_part);
  EXPECT_TRUE(oracle.mayFit(raised));
  oracle.learn(for_all);
  EXPECT_FALSE(oracle.mayFit(raised));
  EXPECT_FALSE(oracle.forPart(whole).mayFit(raised));
  EXPECT_TRUE(oracle.forPart(below).mayFit(raised)) << "intruders elsewhere are of no use there";
}

// Most facets of these hulls are those of the ball.
TEST(Oracle, WhatItLearnedOfFacetsChangesNoAnswer) {
  const TriangleMesh mesh = sphere(1, 12);
  const double tolerance = 0.05;
  const Eigen::AlignedBox3d around(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
  RandomPoints random(3);
  Subject learned(mesh, tolerance);
  int fit = 0;
  for (int i = 0; i < 60; ++i) {
    std::vector<Eigen::Vector3d> points = mesh.vertices;
    for (int k = 0; k < 2; ++k) points.push_back((1 + 2 * tolerance * (i % 10) / 9) * random.inBox(around).normalized());
    const ConvexHull hull = roughHull(points);
    Subject fresh(mesh, tolerance);
    const bool fits = fresh.oracle.fits(hull);
    EXPECT_EQ(learned.oracle.fits(hull), fits);
    EXPECT_LE(fits, learned.oracle.mayFit(hull));
    fit += fits;
  }
  EXPECT_GT(fit, 5);
  EXPECT_LT(fit, 55);
}

TEST(Oracle, SeveralHullsAtOnceGetTheSameAnswersAsEachAlone) {
  Subject subject(uChannel(), 0.05);
  const ConvexHull all = hullOf(subject.mesh.mesh), wall = boxHull({0, 0, 0}, {0.1, 1, 2}), thick = boxHull({0, 0, 0}, {0.16, 1, 2});
  EXPECT_EQ(subject.oracle.fit({&all, &wall, &thick, &wall}), (std::vector<char>{0, 1, 0, 1}));
  EXPECT_TRUE(subject.oracle.fit({}).empty());
}

TEST(Oracle, FitsIsAProof) {
  const unsigned seed = 4;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  RandomPoints random(seed);
  Subject subject(torus(1, 0.3, 16, 8), 0.1);
  int fit = 0;
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d p = random.on(subject.mesh.mesh);
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& v : subject.mesh.mesh.vertices)
      if ((v - p).norm() < 0.8) points.push_back(v);
    points.resize(std::min<std::size_t>(points.size(), static_cast<std::size_t>(4 + random.index(8))));
    const ConvexHull hull = roughHull(points);
    const bool fits = subject.oracle.fits(hull);
    const double found = protrusion({hull}, subject.solid, 0.001).found;
    EXPECT_TRUE(fits ? found <= 0.1 : found >= 0.09) << found;
    fit += fits;
  }
  EXPECT_GT(fit, 5);
  EXPECT_LT(fit, 95);
}

TEST(Oracle, BoundsAreAboveTheTruthAndClose) {
  Subject subject(lBracket(), 0.02);
  const ConvexHull hull = hullOf(subject.mesh.mesh);
  const double exact = protrusion({hull}, subject.solid, 1e-4).found;
  const double bound = subject.oracle.bound({hull});
  EXPECT_GE(bound, exact);
  EXPECT_LE(bound, 1.05 * exact + 0.05 * 0.02);
}

TEST(Oracle, ABoundForSeveralHullsIsThatOfTheWorst) {
  for (const std::vector<std::size_t>& order : {std::vector<std::size_t>{0, 1, 2}, {2, 1, 0}, {1, 0, 2}}) {
    Subject subject(lBracket(), 0.02);
    const ConvexHull whole = hullOf(subject.mesh.mesh);
    const std::vector<ConvexHull> all{whole, boxHull({0, 0, 0}, {0.2, 0.2, 0.2}), boxHull({0, 0, 0}, {0.3, 0.3, 0.3})};
    std::vector<ConvexHull> hulls;
    for (const std::size_t i : order) hulls.push_back(all[i]);
    const double exact = protrusion(hulls, subject.solid, 1e-4).found, bound = subject.oracle.bound(hulls);
    EXPECT_GE(bound, exact);
    EXPECT_LE(bound, 1.05 * exact + 0.05 * 0.02);
    for (const ConvexHull& hull : hulls) EXPECT_GE(bound, protrusion({hull}, subject.solid, 1e-4).found);
  }
  EXPECT_EQ(Subject(lBracket(), 0.02).oracle.bound({}), 0);
}

/// Cells are far larger than the hollow here, and off its middle, so that nothing comes to light by chance.
TEST(Oracle, ABoundForSeveralHullsHoldsForTheirPockets) {
  const ConvexHull hull = hullOf(flask());
  const Eigen::AlignedBox3d box = boundingBox(hull);
  const TriangleMesh mesh = merged({flask(), moved(test_shapes::box(1, 1, 1), {17, 13, 11})});
  const ConvexHull top = boxHull(box.max() - Eigen::Vector3d::Constant(0.1), box.max());
  for (const std::vector<ConvexHull>& hulls : {std::vector<ConvexHull>{hull, top}, {top, hull}}) {
    Subject subject(mesh, 20);
    const double exact = protrusion({hull}, subject.solid, 1e-3).found;
    EXPECT_LT(subject.oracle.estimate(hull), 0.9 * exact) << "an estimate, which misses the hollow";
    EXPECT_GE(subject.oracle.bound(hulls), exact);
  }
}

/// No point on the surface of the flask's hull is further from the flask than half the neck's width, but the middle of its hollow is.
TEST(Oracle, FindsPocketsBehindANarrowNeck) {
  Subject subject(flask(), 0.5);
  const ConvexHull hull = hullOf(subject.mesh.mesh);
  EXPECT_FALSE(subject.oracle.fits(hull));
  subject.oracle.setTolerance(1.1);
  EXPECT_TRUE(subject.oracle.fits(hull));
}

TEST(Oracle, AGlanceMissesAPocketThatAProofFinds) {
  Subject subject(flaskBesidePlates(), 0.95);
  const ConvexHull hull = hullOf(subject.mesh.mesh);
  EXPECT_TRUE(subject.oracle.fits(hull));
  EXPECT_TRUE(subject.oracle.mayHoldPocket(hull));
  EXPECT_FALSE(subject.oracle.mayHoldPocket(hullOf(moved(box(0.2, 3, 3), {3.3, -1.5, 0}))));
  Subject proving(flaskBesidePlates(), 0.95);
  proving.oracle.provePockets();
  EXPECT_FALSE(proving.oracle.fits(hull));
  EXPECT_FALSE(proving.oracle.forPart(boundingBox(hull)).fits(hull));
}

TEST(Oracle, ManyHullsAreAskedForPocketsLikeEachAlone) {
  std::vector<TriangleMesh> parts;
  std::vector<ConvexHull> hulls;
  std::vector<char> expected;
  for (std::size_t i = 0; i < 40; ++i) {
    const bool holds_one = i % 9 == 4;
    parts.push_back(moved(holds_one ? flask() : box(1, 1, 1), {4.0 * static_cast<double>(i % 8), 4.0 * static_cast<double>(i / 8), 0}));
    hulls.push_back(hullOf(parts.back()));
    expected.push_back(holds_one ? 1 : 0);
  }
  Subject subject(merged(parts), 0.95);
  EXPECT_EQ(subject.oracle.mayHoldPockets(hulls), expected);
  EXPECT_TRUE(subject.oracle.mayHoldPockets({}).empty());
}

TEST(Oracle, IntrudersAreInTheHullAndBeyondTheTolerance) {
  for (const TriangleMesh& mesh : {uChannel(), openBox(), torus(1, 0.3, 16, 8)}) {
    const double tolerance = 0.02 * diagonal(mesh);
    Subject subject(mesh, tolerance);
    const ConvexHull hull = hullOf(mesh);
    const auto intruders = subject.oracle.intruders(hull, 50);
    EXPECT_GE(intruders.size(), 25u);
    EXPECT_LE(intruders.size(), 100u);
    for (const OutsideDistance::Intruder& i : intruders) {
      EXPECT_LE(planeDistance(hull, i.p), 1e-9);
      EXPECT_NEAR(subject.solid.distance(i.p), i.distance, 1e-9);
      EXPECT_GT(i.distance, 0.98 * tolerance);  // required by a proof
      EXPECT_GT(i.weight, 0);
    }
  }
}

// Two distant clusters of points: a hull with few faces around theirs reaches far beyond them.
TEST(Oracle, JudgesHullsThatReachBeyondTheMesh) {
  int refuted = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    RandomPoints random(seed);
    std::vector<Eigen::Vector3d> points = random.cloud(30);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].z() = 0.6 * points[i].z() + (i % 2 ? 3 : -3);
    const ConvexHull hull = convexHull(points), reduced = reduceVertices(hull, 8);
    const TriangleMesh mesh = surface(hull);
    const Solid solid = solidOf(mesh);
    const double truth = protrusion({reduced}, solid, 1e-4).found;
    for (const double share : {0.65, 0.9, 1.1}) {
      const bool fits = ProtrusionOracle(solid, boundingBox(mesh), share * truth, {}).fits(reduced);
      EXPECT_EQ(share > 1, fits) << "seed " << seed << ", share " << share;
      refuted += !fits;
    }
  }
  EXPECT_EQ(16, refuted);
}

TEST(Oracle, CanBeCancelled) {
  Subject subject(uChannel(), 0.05);
  subject.control.cancel();
  const ConvexHull hull = hullOf(subject.mesh.mesh);
  EXPECT_THROW(subject.oracle.mayFit(hull), Error);
  EXPECT_THROW(subject.oracle.fits(hull), Error);
  EXPECT_THROW(subject.oracle.bound({hull}), Error);
  EXPECT_THROW(subject.oracle.intruders(hull, 10), Error);
}

}  // namespace
}  // namespace collision_hulls
