// geometric_shapes, which filters a robot's own points from depth images, takes each mesh of a description for its convex hull. With one
// mesh for a link, obstacles in the link's cavity are taken for the robot and disappear (MoveIt #2611); with several hulls they stay.
#include <geometric_shapes/bodies.h>
#include <geometric_shapes/mesh_operations.h>
#include <gtest/gtest.h>

#include <memory>

#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/measure/solid.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/robot/robot_description.h"
#include "random_points.h"
#include "with_packages/written.h"

namespace collision_hulls {
namespace {

constexpr double kPadding = 0.001;  // [m] so that rounding does not decide on points of a face

/// As the filter makes it of one `<collision>` element.
void addTo(bodies::BodyVector& filter, const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles) {
  EigenSTL::vector_Vector3d corners;
  for (const Triangle& t : triangles)
    for (const int v : t) corners.push_back(vertices[static_cast<std::size_t>(v)]);
  const std::unique_ptr<shapes::Mesh> mesh(shapes::createMeshFromVertices(corners));
  filter.addBody(mesh.get(), Eigen::Isometry3d::Identity(), kPadding);
}

class SelfFilter : public ::testing::Test {
 protected:
  SelfFilter() : fork_(scaled(readMesh(DEMO_ROBOT "/meshes/shoulder_fork.obj").mesh, Eigen::Vector3d::Constant(0.001))) {
    DecomposeOptions options;
    options.tolerance = 0.005;
    result_ = certifiedHulls(fork_, options);
    for (const ConvexHull& hull : result_.hulls) addTo(ours_, hull.vertices, hull.triangles);
    addTo(original_, fork_.vertices, fork_.triangles);
  }

  TriangleMesh fork_;
  CertifiedHulls result_;
  bodies::BodyVector ours_, original_;
};

/// What the filter takes for the robot is lost to the planner.
TEST_F(SelfFilter, ObstaclesBetweenTheProngsStay) {
  const Solid fork(repair(fork_));
  const ConvexHull around = convexHull(fork_.vertices);
  test_shapes::RandomPoints random(1);
  std::size_t in_cavity = 0, lost = 0, lost_by_original = 0;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d p = random.inBox(boundingBox(fork_));
    if (planeDistance(around, p) > 0 || fork.distance(p) <= result_.bound + 2 * kPadding) continue;  // padding moves vertices, faces less
    ++in_cavity;
    lost += ours_.containsPoint(p);
    lost_by_original += original_.containsPoint(p);
  }
  EXPECT_GT(in_cavity, 1000u);
  EXPECT_EQ(lost, 0u);
  EXPECT_EQ(lost_by_original, in_cavity);
}

TEST_F(SelfFilter, NoPointOfTheLinkIsTakenForAnObstacle) {
  test_shapes::RandomPoints random(2);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d p = random.on(fork_);
    EXPECT_TRUE(ours_.containsPoint(p)) << p.transpose();
  }
  for (const Eigen::Vector3d& v : fork_.vertices) EXPECT_TRUE(ours_.containsPoint(v)) << v.transpose();
}

/// Every hull, by geometric_shapes' own loader: it holds its vertices, with the padding.
TEST_F(SelfFilter, LoadsTheHullsOfTheSharedRobots) {
  if (fixtures::sharedRobots().empty()) GTEST_SKIP() << "no robots beside the repository";
  const fixtures::TempFolder folder;
  for (const std::string& robot : fixtures::sharedRobots()) {
    const std::string out = folder / std::filesystem::path(robot).filename().string();  // of no consumer's own files
    if (!fixtures::writeFor("bullet", robot, out, fixtures::kQuick)) continue;
    const RobotDescription written = readRobotDescription(std::filesystem::directory_iterator(out + "/urdf")->path().string());
    std::size_t hulls = 0;
    for (const LinkDescription& link : written.links) {
      for (const GeometryElement& element : link.collisions) {
        const std::size_t at = element.uri.find("/meshes/");
        if (element.kind != GeometryElement::Kind::kMesh || at == std::string::npos) continue;
        const std::unique_ptr<shapes::Mesh> mesh(shapes::createMeshFromResource("file://" + out + element.uri.substr(at)));
        ASSERT_TRUE(mesh) << element.uri;
        bodies::BodyVector filter;
        filter.addBody(mesh.get(), Eigen::Isometry3d::Identity(), kPadding);
        for (unsigned int v = 0; v < mesh->vertex_count; ++v)
          EXPECT_TRUE(filter.containsPoint(Eigen::Map<const Eigen::Vector3d>(mesh->vertices + 3 * v))) << element.uri;
        ++hulls;
      }
    }
    EXPECT_GT(hulls, 0u) << robot;
  }
}

}  // namespace
}  // namespace collision_hulls
