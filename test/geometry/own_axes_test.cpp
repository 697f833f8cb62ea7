#include "geometry/own_axes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
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

/// The vertices in the mesh's steady frame, about the middle of their box.
std::vector<Eigen::Vector3d> inFrame(TriangleMesh mesh) {
  const Eigen::Matrix3d axes = steadyAxes(mesh);
  EXPECT_TRUE(axes.isUnitary(1e-12));
  EXPECT_NEAR(1, axes.determinant(), 1e-12);
  for (Eigen::Vector3d& v : mesh.vertices) v = axes * v;
  const Eigen::Vector3d middle = boundingBox(mesh).center();
  for (Eigen::Vector3d& v : mesh.vertices) v -= middle;
  return mesh.vertices;
}

TEST(SteadyAxes, LayATurnedMeshAsTheOriginal) {
  for (const TriangleMesh& mesh : {scaled(lBracket(), {1, 2, 3}), merged({box(1, 1, 1), moved(box(2, 3, 4), {1, 1, 1})}),
                                   merged({scaled(sphere(), {1, 2, 3}), moved(sphere(0.5), {1, 0.3, 0.1})})}) {
    const std::vector<Eigen::Vector3d> still = inFrame(mesh), moving = inFrame(moved(turned(mesh), {5, 6, 7}));
    for (std::size_t i = 0; i < still.size(); ++i) EXPECT_LT((still[i] - moving[i]).norm(), 1e-9) << i << " of " << still.size();
  }
}

// Which of the frames that a symmetry leads to is open, but not how the shape lies in it.
TEST(SteadyAxes, LayATurnedSymmetricMeshAsASymmetryLeavesIt) {
  for (const TriangleMesh& mesh : {box(1, 2, 3), uChannel(), flange()}) {
    const std::vector<Eigen::Vector3d> still = inFrame(mesh), moving = inFrame(turned(mesh));
    for (const Eigen::Vector3d& v : still)
      EXPECT_TRUE(std::any_of(moving.begin(), moving.end(), [&](const Eigen::Vector3d& w) { return (v - w).norm() < 1e-9; })) << v;
  }
}

TEST(SteadyAxes, AreAlongFlatFaces) {
  const TriangleMesh mesh = turned(uChannel());
  EXPECT_EQ(static_cast<int>(mesh.triangles.size()), flat(mesh, steadyAxes(mesh)));
  EXPECT_TRUE(steadyAxes(TriangleMesh()).isIdentity(0));
  EXPECT_TRUE(steadyAxes(singleTriangle()).isUnitary(1e-12));
}

}  // namespace
}  // namespace collision_hulls
