// Also tests src/primitives/sphere_cover.cpp, src/primitives/sphere_candidates.cpp, src/primitives/set_cover.cpp,
// src/primitives/smallest_ball.cpp and src/primitives/tolerable_space.cpp.
#include "collision_hulls/primitives/spheres.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace collision_hulls {
namespace {

using namespace test_shapes;

SphereOptions within(double tolerance) {
  SphereOptions options;
  options.tolerance = tolerance;
  return options;
}

bool isIn(const std::vector<Sphere>& spheres, const Eigen::Vector3d& p, double slack) {
  for (const Sphere& sphere : spheres)
    if ((p - sphere.centre).norm() <= sphere.radius + slack) return true;
  return false;
}

/// Checks by sampling alone.
void expectKept(const TriangleMesh& mesh, const CertifiedSpheres& result, double tolerance) {
  RandomPoints random(1);
  const Solid solid = solidOf(mesh);
  for (int i = 0; i < 5000; ++i) EXPECT_TRUE(isIn(result.spheres, random.on(mesh), 1e-12 * diagonal(mesh)));
  for (const Eigen::Vector3d& v : mesh.vertices) EXPECT_TRUE(isIn(result.spheres, v, 1e-12 * diagonal(mesh)));
  ASSERT_EQ(result.bounds.size(), result.spheres.size());
  for (std::size_t s = 0; s < result.spheres.size(); ++s) {
    EXPECT_LE(result.bounds[s], result.bound);
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d p = result.spheres[s].centre + result.spheres[s].radius * random.onSphere();
      EXPECT_LE(solid.leastDistance(p, solid.distanceToSurface(p)), result.bounds[s]);
    }
  }
  EXPECT_LE(result.bound, tolerance);
  EXPECT_TRUE(result.within_tolerance);
  EXPECT_TRUE(covers(result.spheres, mesh));
}

TEST(CertifiedSpheres, CoverAndKeepTheTolerance) {
  for (const TriangleMesh& mesh :
       {box(1, 2, 0.5), lBracket(), uChannel(), flask(), torus(), flange(), sphere(), sheet(), boxWithWindow()}) {
    const double tolerance = 0.05 * diagonal(mesh);
    expectKept(mesh, certifiedSpheres(mesh, within(tolerance)), tolerance);
  }
}

}  // namespace
}  // namespace collision_hulls
