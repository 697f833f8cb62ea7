#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/pipeline/output.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace {

using fixtures::count;
using fixtures::TempFolder;

TEST(DecomposeMesh, HasOneRow) {
  const TempFolder folder;
  const std::string path = fixtures::write(folder / "my part.obj", fixtures::obj(test_shapes::lBracket()));
  RobotResult result = decomposeMesh(path, {});
  ASSERT_EQ(result.report.links.size(), 1u);
  EXPECT_EQ(result.report.links[0].link, "my part");
  EXPECT_EQ(result.report.input_sha256, result.report.links[0].sha256);
  EXPECT_TRUE(result.single_mesh);
  writeOutput(result, folder / "out");
  EXPECT_TRUE(std::filesystem::exists(folder / "out/hull_0.stl"));
  EXPECT_EQ(count("\n" + fixtures::read(folder / "out/my_part_hulls.obj"), "\no "), result.report.links[0].hulls);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/package.xml"));
}

// As a node's parameter, which holds for requests of any method.
TEST(DecomposeMesh, AnEffortThatOnlyCertifiedHasDoesNotKeepOthersFromTheirWork) {
  const TempFolder folder;
  const std::string path = fixtures::write(folder / "part.obj", fixtures::obj(test_shapes::lBracket()));
  for (const Method method : allMethods()) {
    Options options;
    options.method = method;
    options.effort = Effort::kInstant;
    EXPECT_NE(decomposeMesh(path, options).report.links[0].status, Status::kFailed) << name(method);
  }
}

TEST(DecomposeMesh, SegmentsStandBesideTheHulls) {
  const TempFolder folder;
  const std::string path = fixtures::write(folder / "part.obj", fixtures::obj(test_shapes::lBracket()));
  Options options;
  options.method = Method::kHacd;
  options.segments = true;
  RobotResult result = decomposeMesh(path, options);
  writeOutput(result, folder / "out");
  EXPECT_EQ(fixtures::read(folder / "out/segments.ply").substr(0, 4), "ply\n");
  EXPECT_EQ(fixtures::read(folder / "out/hierarchy.csv").substr(0, 23), "concavity,clusters\n0,2\n");
  writeOutput(result, folder / "out");  // they are known as part of an earlier output
}

TEST(DecomposeMesh, Degenerate) {
  const TempFolder folder;
  const std::string point = fixtures::write(folder / "point.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n");
  EXPECT_EQ(decomposeMesh(point, {}).report.links[0].status, Status::kFailed);
  const std::string triangle = fixtures::write(folder / "triangle.obj", fixtures::obj(test_shapes::singleTriangle()));
  const ElementReport flat = decomposeMesh(triangle, {}).report.links[0];
  EXPECT_EQ(flat.status, Status::kOk) << flat.reason;
  EXPECT_EQ(flat.interior, "surface");
  EXPECT_EQ(flat.uncovered, 0);
  EXPECT_GT(flat.thickness, 0);
  const std::string missing = folder / "missing.obj";
  EXPECT_EQ(decomposeMesh(missing, {}).report.links[0].error, "FileNotFound");
}

/// How far the corners of a file's box are rounded outward, all three coordinates of each by half a unit in the last place, nearly; and the
/// row of the report. Numbers in the file are smaller by the scale.
struct RoundedBox {
  double furthest = 0;  ///< [m] of the hulls' vertices
  ElementReport row;
};
RoundedBox roundedBox(double unit, double from, double scale) {
  const double low = from + 0.4999 * unit, high = from + 6 - 0.4999 * unit;
  TriangleMesh box = test_shapes::box(1, 1, 1);
  for (Eigen::Vector3d& v : box.vertices)
    v = (v.array() > 0.5).select(Eigen::Vector3d::Constant(high / scale), Eigen::Vector3d::Constant(low / scale));
  const TempFolder folder;
  Options options;
  options.tolerance = lengthOf(0.05);
  options.scale = scale;
  const RobotResult result = decomposeMesh(fixtures::write(folder / "far.obj", fixtures::obj(box)), options);
  RoundedBox rounded{0, result.report.links.at(0)};
  for (const ConvexHull& hull : result.elements.at(0).hulls)
    for (const Eigen::Vector3d& v : hull.vertices)
      rounded.furthest = std::max(rounded.furthest, (v.array() - high).max(low - v.array()).max(0).matrix().norm());
  return rounded;
}

// A corner moves by more than half a unit.
TEST(DecomposeMesh, TheBoundHoldsForTheNumbersInTheFile) {
  constexpr double kUnit = 0x1p-9, kFrom = 16384;  // single precision's, from there on
  for (const double scale : {1.0, 16.0}) {
    const RoundedBox rounded = roundedBox(kUnit, kFrom, scale);
    ASSERT_EQ(rounded.row.status, Status::kOk) << rounded.row.reason;
    EXPECT_GT(rounded.furthest, kUnit) << "or it tells nothing";
    EXPECT_LE(rounded.furthest, rounded.row.protrusion) << "scale " << scale;
  }
}

TEST(DecomposeMesh, TheBoundIncludesHowFarVerticesWereWelded) {
  TriangleMesh box = test_shapes::box(1, 1, 1);
  box.vertices.push_back(box.corner(11, 0) + Eigen::Vector3d::Constant(4e-6));  // a copy of a corner, off by a little
  box.triangles[11][0] = static_cast<int>(box.vertices.size()) - 1;
  const TempFolder folder;
  Options options;
  options.tolerance = lengthOf(0.001);
  const ElementReport row = decomposeMesh(fixtures::write(folder / "box.obj", fixtures::obj(box)), options).report.links.at(0);
  ASSERT_EQ(row.status, Status::kOk) << row.reason;
  EXPECT_NEAR(row.repair.weld_distance, std::sqrt(3.0) * 4e-6, 2e-7);
  EXPECT_GE(row.protrusion, row.protrusion_found + row.repair.weld_distance);
}

TEST(DecomposeMesh, NoToleranceFinerThanItsCoordinates) {
  const TempFolder folder;
  const std::string path = fixtures::write(folder / "part.obj", fixtures::obj(test_shapes::lBracket()));
  const double size = diagonal(test_shapes::lBracket());
  Options options;
  options.tolerance = lengthOf(0.99e-6 * size);
  const ElementReport row = decomposeMesh(path, options).report.links[0];
  EXPECT_EQ(row.error, "BadOption");
  EXPECT_NE(row.reason.find("part.obj"), std::string::npos) << row.reason;
  options.tolerance = lengthOf(1.01e-6 * size);
  EXPECT_EQ(decomposeMesh(path, options).report.links[0].status, Status::kOk);
}

}  // namespace
}  // namespace collision_hulls
