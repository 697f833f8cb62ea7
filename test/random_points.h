// Seeded random points for the tests of all rooms; the same numbers with every standard library.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {
namespace test_shapes {

class RandomPoints {
 public:
  explicit RandomPoints(std::uint32_t seed) : engine_(seed) {}

  double number(double low = -1, double high = 1) { return low + (high - low) * engine_() / 4294967296.0; }
  int index(std::size_t count) { return static_cast<int>(engine_() % count); }

  Eigen::Vector3d inCube(double half = 1) {
    const double x = number(-half, half), y = number(-half, half), z = number(-half, half);
    return {x, y, z};
  }
  Eigen::Vector3d inBox(const Eigen::AlignedBox3d& box) { return box.center() + box.sizes().cwiseProduct(inCube(0.5)); }
  Eigen::Vector3d onSphere() {
    for (;;) {
      const Eigen::Vector3d p = inCube();
      if (p.norm() > 0.1 && p.norm() <= 1) return p.normalized();
    }
  }
  Eigen::Vector3d inTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double u = std::sqrt(number(0, 1)), v = number(0, 1);
    return (1 - u) * a + u * (1 - v) * b + u * v * c;
  }
  Eigen::Vector3d on(const TriangleMesh& mesh) {
    const int t = index(mesh.triangles.size());
    return inTriangle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
  }
  std::vector<Eigen::Vector3d> cloud(std::size_t count, double half = 1) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(inCube(half));
    return points;
  }
  Eigen::Matrix3d rotation() {
    const Eigen::Vector3d axis = onSphere();
    return Eigen::AngleAxisd(number(-3.14, 3.14), axis).toRotationMatrix();
  }
  /// Unrelated triangles.
  TriangleMesh soup(int triangles, double size = 0.3) {
    TriangleMesh mesh;
    for (int t = 0; t < triangles; ++t) {
      const Eigen::Vector3d middle = inCube();
      for (int k = 0; k < 3; ++k) mesh.vertices.push_back(middle + inCube(size));
      mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return mesh;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace test_shapes
}  // namespace collision_hulls
