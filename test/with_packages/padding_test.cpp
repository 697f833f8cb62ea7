// The table of geometric_shapes' issue 76, with 10 cm of padding asked for, by geometric_shapes as MoveIt uses it, and by ours. Until 0.7.5
// geometric_shapes moves vertices away from their mean, then along their normals: either way a side grows by less, and the table's
// underside by nothing or less than nothing. The rows in doc/options.md are those of the former, which Debian has.
#include <geometric_shapes/bodies.h>
#include <geometric_shapes/mesh_operations.h>
#include <geometric_shapes/shapes.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "collision_hulls/decompose/certified_hulls.h"
#include "random_points.h"
#include "shapes.h"
#include "with_packages/written.h"

namespace collision_hulls {
namespace {

constexpr double kPadding = 0.1, kTolerance = 0.03;                              // [m]
constexpr double kLength = 1.8, kWidth = 0.6, kThickness = 0.04, kHeight = 0.7;  // [m] of the table; its top's upper side is at z = 0
const Eigen::Vector2d kUnderTheTop(0.2, 0.1);                                    // [m] no leg is there

using Meshes = std::vector<TriangleMesh>;

TriangleMesh table() {
  std::vector<TriangleMesh> parts = {
      test_shapes::moved(test_shapes::box(kLength, kWidth, kThickness), {-kLength / 2, -kWidth / 2, -kThickness})};
  const double leg = 0.05, x = kLength / 2 - leg, y = kWidth / 2 - leg;
  for (const double at_x : {-x, x})
    for (const double at_y : {-y, y})
      parts.push_back(test_shapes::moved(test_shapes::box(leg, leg, kHeight - kThickness), {at_x - leg / 2, at_y - leg / 2, -kHeight}));
  return test_shapes::merged(parts);
}

std::unique_ptr<shapes::Mesh> shapeOf(const TriangleMesh& mesh) {
  EigenSTL::vector_Vector3d corners;
  for (const Triangle& t : mesh.triangles)
    for (const int v : t) corners.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
  return std::unique_ptr<shapes::Mesh>(shapes::createMeshFromVertices(corners));
}

/// As MoveIt pads an object or a link for FCL.
TriangleMesh paddedByMoveit(const TriangleMesh& mesh) {
  const std::unique_ptr<shapes::Mesh> shape = shapeOf(mesh);
  shape->padd(kPadding);
  TriangleMesh padded;
  for (unsigned int v = 0; v < shape->vertex_count; ++v)
    padded.vertices.emplace_back(shape->vertices[3 * v], shape->vertices[3 * v + 1], shape->vertices[3 * v + 2]);
  for (unsigned int t = 0; t < shape->triangle_count; ++t)
    padded.triangles.push_back({static_cast<int>(shape->triangles[3 * t]), static_cast<int>(shape->triangles[3 * t + 1]),
                                static_cast<int>(shape->triangles[3 * t + 2])});
  return padded;
}

Meshes surfaces(const std::vector<ConvexHull>& hulls) {
  Meshes all;
  for (const ConvexHull& hull : hulls) all.push_back({hull.vertices, hull.triangles});
  return all;
}

double farthest(const Meshes& meshes, const Eigen::Vector3d& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const TriangleMesh& mesh : meshes)
    for (const Eigen::Vector3d& v : mesh.vertices) most = std::max(most, direction.dot(v));
  return most;
}

/// [m] The lowest z of the meshes at (x, y).
double underside(const Meshes& meshes, const Eigen::Vector2d& at) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const TriangleMesh& mesh : meshes) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      Eigen::Matrix3d corners, flat;
      for (int k = 0; k < 3; ++k) corners.col(k) = flat.col(k) = mesh.corner(static_cast<int>(t), k);
      flat.row(2).setOnes();
      if (std::abs(flat.determinant()) < 1e-12) continue;
      const Eigen::Vector3d shares = flat.inverse() * Eigen::Vector3d(at.x(), at.y(), 1);
      if (shares.minCoeff() >= -1e-9) lowest = std::min(lowest, corners.row(2).dot(shares));
    }
  }
  return lowest;
}

/// [m] By how much the table top grows: along, across, above, below.
std::array<double, 4> growth(const Meshes& padded) {
  return {farthest(padded, Eigen::Vector3d::UnitX()) - kLength / 2, farthest(padded, Eigen::Vector3d::UnitY()) - kWidth / 2,
          farthest(padded, Eigen::Vector3d::UnitZ()), -kThickness - underside(padded, kUnderTheTop)};
}

std::string row(const std::string& name, const std::array<double, 4>& grown) {
  std::string text = "| " + name + " |";
  for (const double metres : grown) {
    char cell[32];
    std::snprintf(cell, sizeof cell, " %.1f |", 100 * metres);
    text += cell;
  }
  return text;
}

class Padding : public ::testing::Test {
 protected:
  static CertifiedHulls ours() {
    DecomposeOptions options;
    options.tolerance = kTolerance;
    options.padding = kPadding;
    return certifiedHulls(table(), options);
  }
};

TEST_F(Padding, OursGrowsByWhatIsAskedEverywhere) {
  const CertifiedHulls padded = ours();
  EXPECT_TRUE(padded.within_tolerance) << padded.reason;
  for (const double grown : growth(surfaces(padded.hulls))) {
    EXPECT_GE(grown, kPadding);
    EXPECT_LE(grown, kPadding + kTolerance);
  }
}

TEST_F(Padding, MoveitsGrowsByLessThanIsAsked) {
  const auto [along, across, above, below] = growth({paddedByMoveit(table())});
  for (const double grown : {along, across, above}) EXPECT_LT(grown, 0.95 * kPadding);
  EXPECT_LT(across, 0.6 * kPadding);
  EXPECT_LT(above, 0.6 * kPadding);
  EXPECT_LT(below, 0.6 * kPadding);
}

/// The self-filter's bodies are convex hulls, of which it is the same.
TEST_F(Padding, PointsWithinThePaddingAreInOursAndNotInMoveitsBody) {
  const std::unique_ptr<shapes::Mesh> shape = shapeOf(table());
  bodies::BodyVector moveits, of_ours;
  moveits.addBody(shape.get(), Eigen::Isometry3d::Identity(), kPadding);
  const CertifiedHulls padded = ours();
  for (const ConvexHull& hull : padded.hulls)
    of_ours.addBody(shapeOf({hull.vertices, hull.triangles}).get(), Eigen::Isometry3d::Identity(), 0);
  std::size_t lost = 0;
  test_shapes::RandomPoints random(1);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d above =
        random.inBox({Eigen::Vector3d(-kLength / 2, -kWidth / 2, 0), Eigen::Vector3d(kLength / 2, kWidth / 2, kPadding)});
    EXPECT_TRUE(of_ours.containsPoint(above)) << above.transpose();
    lost += !moveits.containsPoint(above);
  }
  EXPECT_GT(lost, 1000u);
}

TEST_F(Padding, TheDocumentHasTheseRows) {
  const std::array<double, 4> moveits = growth({paddedByMoveit(table())});
  if (std::abs(moveits[1] - moveits[2]) > 0.005 || moveits[3] > 0) GTEST_SKIP() << "geometric_shapes of 0.7.6 or later";
  const std::string document = fixtures::read(DEMO_ROBOT "/doc/options.md");
  for (const std::string& each :
       {row("MoveIt's padding (geometric_shapes)", moveits), row("ours: `--padding 10cm -t 3cm`", growth(surfaces(ours().hulls)))})
    EXPECT_NE(document.find(each), std::string::npos) << "doc/options.md lacks this row:\n" << each;
}

}  // namespace
}  // namespace collision_hulls
