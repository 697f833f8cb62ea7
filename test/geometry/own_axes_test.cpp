#include "geometry/own_axes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "shapes.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

TriangleMesh turned(const TriangleMesh& mesh) {
  return transformed(mesh, Eigen::Isometry3d(Eigen::Quaterniond(0.8, 0.3, -0.4, 0.2).normalized()));
}

/// How many triangles are axis-aligned with respect to the rows of a rotation.
int flat(const TriangleMesh& mesh, const Eigen::Matrix3d& axes) {
  int count = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Eigen::Vector3d n = (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)).normalized();
    count += (axes * n).cwiseAbs().maxCoeff() > 1 - 1e-12;
  }
  return count;
}

TEST(OwnAxes, LeaveAlignedAndRoundMeshesAlone) {
  for (const TriangleMesh& mesh : {box(1, 2, 3), uChannel(), torus(), sphere(), turned(sphere()), turned(torus()), singleTriangle()})
    EXPECT_TRUE(ownAxes(mesh).isIdentity(0));
  EXPECT_TRUE(ownAxes(TriangleMesh()).isIdentity(0));
}

TEST(OwnAxes, AlignTheFlatFacesOfARotatedMesh) {
  for (const TriangleMesh& upright : {box(1, 2, 3), uChannel(), openBox(1, 1, 1, 0.05, 3), moved(lBracket(), {100, -20, 3})}) {
    const TriangleMesh mesh = turned(upright);
    const Eigen::Matrix3d axes = ownAxes(mesh);
    EXPECT_TRUE(axes.isUnitary(1e-12));
    EXPECT_NEAR(1, axes.determinant(), 1e-12);
    EXPECT_EQ(0, flat(mesh, Eigen::Matrix3d::Identity()));
    EXPECT_EQ(static_cast<int>(mesh.triangles.size()), flat(mesh, axes));
  }
}

// An open sheet.
TEST(OwnAxes, NeedOnlyOneFlatDirection) {
  const TriangleMesh mesh = turned(sheet(1, 2, 4));
  EXPECT_EQ(static_cast<int>(mesh.triangles.size()), flat(mesh, ownAxes(mesh)));
}

}  // namespace
}  // namespace collision_hulls
