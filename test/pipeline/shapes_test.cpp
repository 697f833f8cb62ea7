// Also tests src/pipeline/shapes/bodies.cpp.
#include "pipeline/shapes/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/pipeline/output.h"
#include "collision_hulls/verify/verify.h"
#include "geometry/pi.h"
#include "pipeline/fixtures.h"
#include "random_points.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

/// A rod of 48 sides along z.
TriangleMesh rod(double radius, double length) {
  std::vector<Eigen::Vector3d> rims;
  for (int k = 0; k < 48; ++k)
    for (const double z : {-length / 2, length / 2}) rims.emplace_back(radius * std::cos(k * kPi / 24), radius * std::sin(k * kPi / 24), z);
  return surface(convexHull(rims));
}

/// A plate on a rod: a box and a cylinder do for it.
TriangleMesh plateOnRod() {
  return test_shapes::merged({rod(0.04, 0.3), test_shapes::moved(test_shapes::box(0.3, 0.3, 0.02), {-0.15, -0.15, 0.14})});
}

class ShapesTest : public ::testing::Test {
 protected:
  ShapesTest() { options_.tolerance = lengthOf(0.005); }

  RobotResult run(const TriangleMesh& mesh, Shapes shapes) {
    fixtures::write(folder_ / "part.obj", fixtures::obj(mesh));
    options_.shapes = shapes;
    const std::string element = "<visual><origin xyz=\"0.1 0.2 0.3\"/>" + fixtures::meshTag("part.obj") + "</visual>";
    file_ = fixtures::write(folder_ / "arm.urdf", fixtures::robot("arm", fixtures::link("base", element)));
    return decomposeRobot(readRobotDescription(file_), defaultPackageFinder(file_), options_, folder_ / "out");
  }

  /// The kinds of the elements that are written, and that verify, which knows nothing of how they were made, has nothing against them.
  std::vector<Kind> kinds(RobotResult result) {
    EXPECT_TRUE(writeOutput(result, folder_ / "out"));
    const ElementReport& row = result.report.links.front();
    EXPECT_EQ(result.report.validation.missed + result.report.validation.phantom, 0u);
    EXPECT_LE(result.report.validation.max_underestimate, row.protrusion);
    EXPECT_LE(row.protrusion_found, row.protrusion);
    const RobotDescription written = readRobotDescription(folder_ / "out/urdf/arm.urdf");
    VerifyOptions verifying;
    const Verification seen = verify({readRobotDescription(file_), defaultPackageFinder(file_)},
                                     {written, defaultPackageFinder(written.path, {"out=" + (folder_ / "out")})}, verifying);
    EXPECT_EQ(seen.links.at(0).uncovered.bound, 0) << seen.links.at(0).uncovered.found;
    EXPECT_LE(seen.links.at(0).protrusion.found, row.protrusion);
    EXPECT_EQ(seen.contradictions, 0u) << "a body inside the original is inside the result";
    std::vector<Kind> kinds;
    for (const GeometryElement& element : written.links.at(0).collisions) kinds.push_back(element.kind);
    std::sort(kinds.begin(), kinds.end());
    return kinds;
  }

  /// How much of a convex body's inside lies in the bodies of the result.
  static double shareWithin(const RobotResult& result, const TriangleMesh& body) {
    const ConvexHull hull = convexHull(body.vertices);
    test_shapes::RandomPoints random(3);
    int inside = 0, held = 0;
    while (inside < 1000) {
      const Eigen::Vector3d p = random.inBox(boundingBox(body));
      if (!holds(hull, p)) continue;
      const std::vector<ConvexHull>& bodies = result.elements.at(0).hulls;
      ++inside;
      held += std::any_of(bodies.begin(), bodies.end(), [&](const ConvexHull& one) { return holds(one, p); });
    }
    return held / 1000.;
  }

  std::string message(const TriangleMesh& mesh, Shapes shapes) {
    try {
      run(mesh, shapes);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadOption);
      return error.what();
    }
    return "";
  }

  fixtures::TempFolder folder_;
  Options options_;
  std::string file_;
};

TEST_F(ShapesTest, PrimitivesTakeThePlaceOfHulls) {
  const TriangleMesh part = test_shapes::merged({plateOnRod(), test_shapes::moved(test_shapes::lBracket(0.2, 0.03, 0.1), {0.5, 0, 0})});
  const std::vector<Kind> seen = kinds(run(part, Shapes::kMixed));
  EXPECT_EQ(std::count(seen.begin(), seen.end(), Kind::kCylinder), 1);
  EXPECT_EQ(std::count(seen.begin(), seen.end(), Kind::kBox), 3);
  EXPECT_EQ(seen.size(), 4u);
}

TEST_F(ShapesTest, AHullStaysWhereNoPrimitiveDoes) {
  TriangleMesh wedge = test_shapes::box(0.2, 0.2, 0.2);
  for (Eigen::Vector3d& v : wedge.vertices)
    if (v.z() > 0.1) v.x() *= 0.2;
  const RobotResult result = run(wedge, Shapes::kMixed);
  EXPECT_EQ(result.report.links.at(0).hulls, 1u);
  EXPECT_EQ(result.report.links.at(0).primitives, 0u);
  EXPECT_EQ(kinds(result), std::vector<Kind>{Kind::kMesh});
}

TEST_F(ShapesTest, ThePolyhedronAboutACylinderCounts) {
  options_.tolerance = lengthOf(0.0003);  // the cylinder keeps it, 0.1 mm, but what stands for it in queries is 0.4 mm larger
  const RobotResult result = run(rod(0.04, 0.3), Shapes::kMixed);
  const ElementReport& row = result.report.links.at(0);
  EXPECT_EQ(row.status, Status::kOk) << row.reason;
  EXPECT_EQ(row.primitives, 0u);
}

TEST_F(ShapesTest, PrimitivesAlone) {
  const RobotResult result = run(plateOnRod(), Shapes::kPrimitives);
  EXPECT_EQ(result.report.links.at(0).status, Status::kOk) << result.report.links.at(0).reason;
  EXPECT_EQ(kinds(result), (std::vector<Kind>{Kind::kBox, Kind::kCylinder}));
  EXPECT_EQ(result.report.links.at(0).hulls, 0u);
  EXPECT_LE(result.report.links.at(0).protrusion, 0.005);
}

TEST_F(ShapesTest, MorePrimitivesThanTheLimitAreSaidToBe) {
  options_.max_hulls = 2;
  EXPECT_EQ(run(plateOnRod(), Shapes::kPrimitives).report.links.at(0).status, Status::kOk);
  options_.max_hulls = 1;
  const ElementReport row = run(plateOnRod(), Shapes::kPrimitives).report.links.at(0);
  EXPECT_EQ(row.status, Status::kDegraded);
  EXPECT_NE(row.reason.find("it takes 2 primitives, more than max-hulls 1"), std::string::npos) << row.reason;
}

TEST_F(ShapesTest, WhereNoPrimitiveStandsForAHullTheSurfaceInItIsDivided) {
  TriangleMesh wedge = test_shapes::box(0.2, 0.2, 0.2);
  for (Eigen::Vector3d& v : wedge.vertices)
    if (v.z() > 0.1) v.x() = 0;
  for (const double tolerance : {0.03, 0.01}) {
    options_.tolerance = lengthOf(tolerance);
    const RobotResult result = run(wedge, Shapes::kPrimitives);
    EXPECT_EQ(result.report.links.at(0).status, Status::kOk) << result.report.links.at(0).reason;
    EXPECT_GT(result.report.links.at(0).primitives, 2u);
    EXPECT_LE(result.report.links.at(0).primitives, 60u);
    EXPECT_EQ(kinds(result).size(), result.report.links.at(0).primitives);
    EXPECT_GT(shareWithin(result, wedge), 0.95) << "a body inside would not be seen";
  }
}

// A part of the surface on both sides of which there is none takes a body that reaches half the tolerance beyond it.
TEST_F(ShapesTest, ASheetThatIsBentTakesPrimitives) {
  const RobotResult result = run(test_shapes::openBox(0.2, 0.15, 0.1, 0.001), Shapes::kPrimitives);
  EXPECT_EQ(result.report.links.at(0).status, Status::kOk) << result.report.links.at(0).reason;
  EXPECT_EQ(kinds(result), std::vector<Kind>(5, Kind::kBox));
}

TEST_F(ShapesTest, OneOfAKindHasTheBoundThatItHas) {
  for (const Shapes shapes : {Shapes::kSphere, Shapes::kBox, Shapes::kCylinder, Shapes::kCapsule}) {
    const RobotResult result = run(rod(0.04, 0.3), shapes);
    const ElementReport& row = result.report.links.at(0);
    const bool fits = shapes == Shapes::kCylinder;
    EXPECT_EQ(row.status, fits ? Status::kOk : Status::kDegraded) << name(shapes);
    EXPECT_EQ(row.reason.find(std::string("a single ") + name(shapes) + " does not fit better") != std::string::npos, !fits) << row.reason;
    const std::vector<Kind> seen = kinds(result);
    if (shapes == Shapes::kCapsule)
      EXPECT_EQ(seen, (std::vector<Kind>{Kind::kSphere, Kind::kSphere, Kind::kCylinder}));
    else
      EXPECT_EQ(seen.size(), 1u);
  }
}

TEST_F(ShapesTest, SpheresCover) {
  const RobotResult result = run(test_shapes::lBracket(0.2, 0.03, 0.1), Shapes::kSpheres);
  const ElementReport& row = result.report.links.at(0);
  EXPECT_EQ(row.status, Status::kOk) << row.reason;
  EXPECT_LE(row.protrusion, 0.005);
  EXPECT_GT(row.protrusion_found, 0.001);
  EXPECT_EQ(row.hulls, 0u);
  const std::vector<Kind> seen = kinds(result);
  EXPECT_EQ(static_cast<std::size_t>(std::count(seen.begin(), seen.end(), Kind::kSphere)), row.primitives);
}

TEST_F(ShapesTest, TooFewSpheresAreDegraded) {
  options_.max_hulls = 3;
  const RobotResult result = run(test_shapes::lBracket(0.2, 0.03, 0.1), Shapes::kSpheres);
  const ElementReport& row = result.report.links.at(0);
  EXPECT_EQ(row.status, Status::kDegraded);
  EXPECT_LE(row.primitives, 3u);
  EXPECT_GT(row.protrusion, 0.005);
  EXPECT_FALSE(row.reason.empty());
}

TEST_F(ShapesTest, TheCacheKnowsThem) {
  const RobotResult first = run(plateOnRod(), Shapes::kPrimitives), again = run(plateOnRod(), Shapes::kPrimitives);
  EXPECT_TRUE(again.report.links.at(0).cached);
  EXPECT_EQ(first.urdf, again.urdf);
  EXPECT_FALSE(run(plateOnRod(), Shapes::kMixed).report.links.at(0).cached);
}

TEST_F(ShapesTest, ContradictionsAreRefused) {
  const TriangleMesh box = test_shapes::box(0.1, 0.1, 0.1);
  options_.padding = 0.01;
  EXPECT_NE(message(box, Shapes::kSpheres).find("shapes 'spheres' contradicts padding '1cm'"), std::string::npos);
  options_.padding = 0;
  options_.method = Method::kHacd;
  EXPECT_NE(message(box, Shapes::kMixed).find("shapes 'mixed' contradicts method 'hacd'"), std::string::npos);
  options_.method = Method::kCertified;
  options_.fill = true;
  EXPECT_NE(message(box, Shapes::kBox).find("shapes 'box' contradicts fill"), std::string::npos);
  options_.fill = false;
  RegionRule region;
  region.pattern = "base";
  region.name = "mouth";
  region.shape = RegionHalfSpace{{0, 0, 1}, 0};
  options_.region_rules = {region};
  EXPECT_NE(message(box, Shapes::kSpheres).find("link 'base': shapes 'spheres' contradicts region 'mouth'"), std::string::npos);
}

TEST_F(ShapesTest, AMeshFileHoldsNone) {
  fixtures::write(folder_ / "box.obj", fixtures::obj(test_shapes::box(0.1, 0.1, 0.1)));
  options_.shapes = Shapes::kSpheres;
  try {
    decomposeMesh(folder_ / "box.obj", options_);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("mesh files hold no primitives"), std::string::npos);
  }
}

TEST(Shapes, LeavesOfTrees) {
  LinkOptions options;
  options.tolerance = lengthOf(0.01);
  EXPECT_DOUBLE_EQ(treeLeaves(options, 1), 0.0025);
  options.tree = lengthOf(0.004);
  EXPECT_DOUBLE_EQ(treeLeaves(options, 1), 0.004);
  options.tree = lengthOf(0.1);
  EXPECT_DOUBLE_EQ(treeLeaves(options, 1), 0.01);
}

}  // namespace
}  // namespace collision_hulls
