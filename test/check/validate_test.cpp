// Also tests src/check/pair_model.cpp and src/check/validate_pair.cpp.
#include "collision_hulls/check/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "shapes.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;
using test_shapes::boxHull;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// An L-bracket and the two boxes that make it up.
ValidationPair bracket(const std::string& name = "bracket") {
  return {name, test_shapes::lBracket(1, 0.1, 1, 3), {boxHull({0, 0, 0}, {1, 0.1, 1}), boxHull({0, 0, 0}, {0.1, 1, 1})}, 0};
}

ValidationPair moved(ValidationPair pair, double scale, const Vector3d& offset) {
  for (Vector3d& v : pair.original.vertices) v = v * scale + offset;
  for (ConvexHull& hull : pair.hulls) {
    for (Vector3d& v : hull.vertices) v = v * scale + offset;
    hull = convexHull(hull.vertices);
  }
  pair.protrusion *= scale;
  return pair;
}

Validation run(const std::vector<ValidationPair>& pairs, int queries = 1000) {
  ValidationOptions options;
  options.queries_per_pair = queries;
  return validate(pairs, options);
}

std::string remarks(const Validation& validation) {
  std::string text;
  for (const std::string& remark : validation.remarks) text += remark + "\n";
  return text;
}

void expectClean(const Validation& validation) {
  EXPECT_EQ(validation.missed, 0u) << remarks(validation);
  EXPECT_EQ(validation.phantom, 0u) << remarks(validation);
  EXPECT_EQ(validation.exceptions, 0u) << remarks(validation);
  EXPECT_EQ(validation.nan, 0u) << remarks(validation);
  EXPECT_EQ(validation.disagreements, 0u) << remarks(validation);
}

// Degenerate input.

TEST(Validate, NothingToCheck) {
  const Validation none = run({});
  EXPECT_EQ(none.queries, 0u);
  const Validation empty = run({{"empty", {}, {}, 0}});
  EXPECT_EQ(empty.queries, 0u);
  ASSERT_EQ(empty.remarks.size(), 1u);
  EXPECT_NE(empty.remarks[0].find("empty: not checked"), std::string::npos);
  EXPECT_EQ(run({bracket()}, 0).queries, 0u);
}

TEST(Validate, RejectsANegativeNumberOfQueries) {
  try {
    run({bracket()}, -1);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadOption);
  }
}

TEST(Validate, RejectsAnIndexOutOfRange) {
  ValidationPair pair = bracket("broken");
  pair.original.triangles.push_back({0, 1, 1000000});
  try {
    run({bracket(), pair});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kIndexOutOfRange);
    EXPECT_NE(std::string(error.what()).find("broken"), std::string::npos);
  }
}

TEST(Validate, NonFiniteNumbersAreCountedAndReported) {
  ValidationPair vertex = bracket("vertex"), hull = bracket("hull"), face = bracket("face"), protrusion = bracket("protrusion");
  vertex.original.vertices[0].x() = kNan;
  hull.hulls[1].vertices[0].y() = std::numeric_limits<double>::infinity();
  face.hulls[0].faces[0].offset = kNan;
  protrusion.protrusion = kNan;
  const Validation validation = run({vertex, bracket(), hull, face, protrusion}, 50);
  EXPECT_EQ(validation.queries, 250u);
  EXPECT_EQ(validation.nan, 200u);
  EXPECT_EQ(validation.missed + validation.phantom, 0u) << remarks(validation);
  ASSERT_EQ(validation.remarks.size(), 4u);
  EXPECT_NE(validation.remarks[0].find("vertex: not checked"), std::string::npos);
}

TEST(Validate, UnusedVerticesDoNotMatter) {
  ValidationPair pair = bracket();
  pair.original.vertices.emplace_back(kNan, 0, 0);
  pair.original.vertices.emplace_back(1e9, 0, 0);
  expectClean(run({pair}));
}

TEST(Validate, OriginalsWithoutArea) {
  const TriangleMesh point{{Vector3d(1, 2, 3)}, {{0, 0, 0}}};
  const TriangleMesh line{{Vector3d(0, 0, 0), Vector3d(1, 1, 1), Vector3d(0.3, 0.3, 0.3)}, {{0, 1, 2}}};
  for (const TriangleMesh& mesh : {point, line, test_shapes::merged({point, line})}) {
    const ConvexHull hull = convexHull(mesh.vertices);
    expectClean(run({{"degenerate", mesh, {hull}, 3}}));
    EXPECT_GT(run({{"degenerate", mesh, {}, 0}}).missed, 0u);
  }
}

TEST(Validate, APartWithoutAreaBesideOneThatHasSome) {
  const TriangleMesh line{{Vector3d(2, 0, 0), Vector3d(2, 1, 1), Vector3d(2, 0.3, 0.3)}, {{0, 1, 2}}};
  const ConvexHull cube = boxHull({0, 0, 0}, {1, 1, 1}), about_line = convexHull(line.vertices);
  expectClean(run({{"cube and line", test_shapes::merged({surface(cube), line}), {cube, about_line}, about_line.thickness}}));
}

// Shapes with a known answer.

TEST(Validate, ExactHulls) {
  const Validation validation = run({bracket()});
  EXPECT_EQ(validation.queries, 1000u);
  expectClean(validation);
  EXPECT_LT(validation.max_underestimate, 1e-9);
  EXPECT_EQ(validation.timeouts, 0u);
  EXPECT_TRUE(validation.remarks.empty());
  EXPECT_GT(validation.mesh_query_us, 0);
  EXPECT_GT(validation.hull_query_us, 0);
}

TEST(Validate, DetectsAMissingHull) {
  ValidationPair pair = bracket();
  pair.hulls.pop_back();
  const Validation validation = run({pair}, 200);
  EXPECT_GT(validation.missed, 20u);
  EXPECT_NE(remarks(validation).find("missed"), std::string::npos);
  EXPECT_EQ(validation.remarks.size(), 20u);
  pair.hulls.clear();
  EXPECT_GT(run({pair}, 200).missed, 50u);
}

TEST(Validate, DetectsAHullThatIsTooSmall) {
  ValidationPair pair = bracket();
  pair.hulls[1] = boxHull({0, 0, 0}, {0.1, 1, 0.999});
  EXPECT_GT(run({pair}).missed, 0u);
}

/// A unit cube with a tip this high on its top.
ConvexHull tipped(double height) {
  return convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0.5, 0.5, 1 + height}});
}

TEST(Validate, VerdictsAllowForTheAccuracyOfDistancesAndNoMore) {
  const ConvexHull cube = boxHull({0, 0, 0}, {1, 1, 1});
  for (const double height : {0.3e-6, 5e-6}) {
    const Validation validation = run({{"tip", surface(tipped(height)), {cube}, 0}});
    EXPECT_EQ(validation.missed > 0, height > 1e-6) << height;
  }
  for (const double share : {0.97, 1.0}) {
    const Validation validation = run({{"cube", surface(cube), {tipped(0.1)}, 0.1 * share}});
    EXPECT_EQ(validation.phantom > 0, share < 1) << share;
    EXPECT_NEAR(validation.max_underestimate, 0.1, 1e-9);
  }
}

TEST(Validate, DetectsAFilledChannel) {
  const TriangleMesh channel = test_shapes::uChannel(1, 1, 0.1, 2, 2);
  ValidationPair pair{"channel", channel, {convexHull(channel.vertices)}, 0};
  const Validation lie = run({pair}, 200);
  EXPECT_GT(lie.phantom, 5u);
  EXPECT_FALSE(lie.holds());
  EXPECT_EQ(lie.missed, 0u);
  EXPECT_EQ(lie.disagreements, 0u);
  pair.protrusion = 0.4;
  const Validation truth = run({pair});
  expectClean(truth);
  EXPECT_GT(truth.max_underestimate, 0.3);
  EXPECT_LE(truth.max_underestimate, 0.4 + 1e-9);
  pair.protrusion = 0.35;
  EXPECT_GT(run({pair}, 5000).phantom, 0u) << "an eighth below the truth";
}

TEST(Validate, ProbesInsideASolid) {
  const TriangleMesh cube = test_shapes::box(1, 1, 1, 2);
  const Validation filled = run({{"cube", cube, {boxHull({0, 0, 0}, {1, 1, 1})}, 0}});
  expectClean(filled);
  EXPECT_LT(filled.max_underestimate, 1e-9);
  // Six plates cover the surface and leave the middle empty: that is not a miss either.
  std::vector<ConvexHull> plates;
  for (int axis = 0; axis < 3; ++axis) {
    Vector3d low = Vector3d::Zero(), high = Vector3d::Ones();
    low[axis] = 0.95;
    plates.push_back(boxHull(low, Vector3d::Ones()));
    high[axis] = 0.05;
    plates.push_back(boxHull(Vector3d::Zero(), high));
  }
  expectClean(run({{"cube", cube, plates, 0}}));
}

TEST(Validate, AProbeThatEntersThroughAnOpeningIsNotAPhantom) {
  ValidationPair pair{"window", test_shapes::boxWithWindow(0.3), {boxHull({0, 0, 0}, {1, 1, 0.93})}, 0.02};
  for (const double low : {0.0, 0.8}) {  // beside the window
    pair.hulls.push_back(boxHull({low, 0, 0.93}, {low + 0.2, 1, 1}));
    pair.hulls.push_back(boxHull({0, low, 0.93}, {1, low + 0.2, 1}));
  }
  expectClean(run({pair}, 2000));
}

TEST(Validate, AnOpenSheetHasNoInside) {
  const TriangleMesh tub = test_shapes::openBox(1, 1, 1, 0.01);
  EXPECT_GT(run({{"tub", tub, {boxHull({0, 0, 0}, {1, 1, 1})}, 0}}).phantom, 0u);
}

TEST(Validate, ProbesThatContainAWholeComponent) {
  std::vector<TriangleMesh> parts;
  std::vector<ConvexHull> hulls;
  for (const Vector3d& at : {Vector3d(0, 0, 0), Vector3d(1, 0.2, 0.1), Vector3d(0.4, 0.9, 0.5)}) {
    parts.push_back(test_shapes::moved(test_shapes::box(0.002, 0.002, 0.002), at));
    hulls.push_back(boxHull(at, at + Vector3d::Constant(0.002)));
  }
  const Validation validation = run({{"dust", test_shapes::merged(parts), hulls, 0}}, 2000);
  expectClean(validation);
  EXPECT_LT(validation.max_underestimate, 1e-9);
}

TEST(Validate, FlatHulls) {
  const TriangleMesh sheet = test_shapes::sheet(1, 0.6, 3);
  const ConvexHull plate = convexHull(sheet.vertices);
  ASSERT_GT(plate.thickness, 0);
  const Validation validation = run({{"sheet", sheet, {plate}, plate.thickness}});
  expectClean(validation);
  EXPECT_LE(validation.max_underestimate, plate.thickness + 1e-6);
}

TEST(Validate, AnyScaleAndPosition) {
  const TriangleMesh channel = test_shapes::uChannel(1, 1, 0.1, 2, 2);
  const ValidationPair filled{"channel", channel, {convexHull(channel.vertices)}, 0.4};
  for (double scale : {1e-6, 1e-3, 10.0, 1e4}) {
    for (const Vector3d& offset : {Vector3d(0, 0, 0), Vector3d(-3e5, 2e5, 7e4)}) {
      if (scale < 1e-3 && !offset.isZero()) continue;  // double precision does not resolve it that far out
      SCOPED_TRACE(std::to_string(scale) + " at " + std::to_string(offset.norm()));
      const Validation validation = run({moved(bracket(), scale, offset), moved(filled, scale, offset)}, 300);
      expectClean(validation);
      EXPECT_LE(validation.max_underestimate, 0.4 * scale * (1 + 1e-6));
      EXPECT_GT(validation.max_underestimate, 0.2 * scale);
    }
  }
}

TEST(Validate, UsesHullsOfNeighboursAsProbes) {
  const ValidationPair base{"base", test_shapes::box(1, 1, 1), {}, 0};
  const ValidationPair arm{
      "arm", test_shapes::moved(test_shapes::box(0.2, 0.2, 2), {0.4, 0.4, 0.9}), {boxHull({0.4, 0.4, 0.9}, {0.6, 0.6, 2.9})}, 0};
  const std::string text = remarks(run({base, arm}, 10));
  EXPECT_NE(text.find("base: hull of arm at (0.5"), std::string::npos) << text;
  const ValidationPair far{"far", test_shapes::moved(test_shapes::box(1, 1, 1), {9, 0, 0}), {boxHull({9, 0, 0}, {10, 1, 1})}, 0};
  EXPECT_EQ(remarks(run({base, far}, 10)).find("hull of"), std::string::npos);
}

TEST(Validate, TheSamePartTwiceInOnePlace) {
  expectClean(run({bracket("one"), bracket("other")}));
}

// Execution.

TEST(Validate, SameAnswersForTheSameSeed) {
  ValidationPair holed = bracket("holed");
  holed.hulls.pop_back();
  const TriangleMesh channel = test_shapes::uChannel(1, 1, 0.1, 2, 2);
  const std::vector<ValidationPair> pairs{holed, bracket(), {"channel", channel, {convexHull(channel.vertices)}, 0.1}, bracket("last")};
  const Validation a = run(pairs, 200), b = run(pairs, 200);
  EXPECT_EQ(a.queries, b.queries);
  EXPECT_EQ(a.missed, b.missed);
  EXPECT_EQ(a.phantom, b.phantom);
  EXPECT_EQ(a.max_underestimate, b.max_underestimate);
  EXPECT_EQ(a.disagreements, b.disagreements);
  EXPECT_EQ(a.remarks, b.remarks);
  ValidationOptions other;
  other.seed = 2;
  EXPECT_NE(validate(pairs, other).remarks, a.remarks);
}

TEST(Validate, ProgressNeverDecreasesAndEndsAtOne) {
  std::vector<double> seen;
  RunControl control;
  control.progress = [&](double fraction) { seen.push_back(fraction); };
  validate({bracket(), bracket(), bracket()}, {}, control);
  ASSERT_EQ(seen.size(), 3u);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1);
}

TEST(Validate, CanBeCancelledBeforeAndDuring) {
  RunControl before;
  before.cancel();
  EXPECT_THROW(validate({bracket()}, {}, before), Error);
  RunControl within;
  within.progress = [&](double) { within.cancel(); };
  try {
    validate(std::vector<ValidationPair>(50, bracket()), {}, within);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
}

TEST(Validate, UsesASolidFromTheCaller) {
  ValidationPair pair = bracket();
  const auto solid = std::make_shared<const Solid>(repair(pair.original));
  pair.solid_pose = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.3, Vector3d(1, 2, 2).normalized());
  pair.original = transformed(pair.original, pair.solid_pose);
  for (ConvexHull& hull : pair.hulls) {
    for (Vector3d& v : hull.vertices) v = pair.solid_pose * v;
    hull = convexHull(hull.vertices);
  }
  pair.hulls.push_back(boxHull({1, 2, 3}, {1.2, 2.2, 3.2}));  // so that there is something to find
  const Validation made = run({pair});
  pair.solid = solid;
  const Validation given = run({pair});
  EXPECT_GT(made.phantom, 0u);
  EXPECT_EQ(given.phantom, made.phantom);
  EXPECT_NEAR(given.max_underestimate, made.max_underestimate, 1e-9);
  EXPECT_EQ(given.remarks, made.remarks);
}

/// A ball of 720 triangles, the sphere about it, and a polyhedron about that.
ValidationPair ball(double radius) {
  ValidationPair pair{"ball", test_shapes::sphere(1, 6), {}, 0};
  std::vector<Vector3d> points;
  for (const Vector3d& v : test_shapes::sphere(1, 2).vertices) points.push_back(1.3 * radius * v);
  pair.hulls = {convexHull(points)};
  pair.spheres = {{Vector3d::Zero(), radius}};
  pair.protrusion = 0.03;  // of the sphere beyond the triangles
  return pair;
}

TEST(Validate, SpheresCountInPlaceOfTheirPolyhedra) {
  expectClean(run({ball(1)}));
  ValidationPair polyhedron = ball(1);
  polyhedron.spheres.clear();
  EXPECT_GT(run({polyhedron}).phantom, 0u);
}

TEST(Validate, SpheresThatAreTooSmallOrTooLarge) {
  EXPECT_GT(run({ball(0.98)}).missed, 0u);
  EXPECT_GT(run({ball(1.05)}).phantom, 0u);
}

TEST(Validate, ASphereBesideAHull) {
  ValidationPair pair = bracket();
  const TriangleMesh other = test_shapes::moved(test_shapes::sphere(0.2, 6), {2, 0, 0});
  pair.original = test_shapes::merged({pair.original, other});
  pair.hulls.push_back(boxHull({1.7, -0.3, -0.3}, {2.3, 0.3, 0.3}));
  pair.spheres = {{Vector3d(2, 0, 0), 0.2}};
  pair.protrusion = 0.006;
  expectClean(run({pair}));
  pair.spheres = {{Vector3d(2, 0, 0), 0.19}};
  EXPECT_GT(run({pair}).missed, 0u);
}

TEST(Validate, RejectsASphereWithoutAHullOrWithoutASize) {
  ValidationPair pair = ball(1);
  pair.hulls.clear();
  EXPECT_GT(run({pair}).nan, 0u);
  pair = ball(1);
  pair.spheres[0].radius = kNan;
  EXPECT_GT(run({pair}).nan, 0u);
}

}  // namespace
}  // namespace collision_hulls
