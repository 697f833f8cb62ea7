// Test cases for the method `certified` and its trees.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "collision_hulls/decompose/certified.h"
#include "collision_hulls/decompose/round_outward.h"
#include "collision_hulls/measure/measures.h"
#include "mesh/loose_segments.h"
#include "solids.h"

namespace collision_hulls {
namespace test_shapes {

constexpr double kGap = 0.001;  // as a share of the tolerance: between the bounds of a protrusion

inline DecomposeOptions within(double tolerance, Effort effort = Effort::kQuick, int max_vertices = 64) {
  DecomposeOptions options;
  options.method = Method::kCertified;
  options.tolerance = tolerance;
  options.effort = effort;
  options.max_vertices = max_vertices;
  return options;
}

inline double sizeOf(const RepairedMesh& mesh) {
  const Eigen::AlignedBox3d box = boundingBox(mesh);
  return box.diagonal().norm() + box.center().norm();
}

/// The surface as triangles, including loose segments.
inline TriangleMesh surfaceOf(const RepairedMesh& mesh) {
  TriangleMesh all = mesh.mesh;
  for (const Segment& segment : mesh.loose) {
    const int i = static_cast<int>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), segment.begin(), segment.end());
    all.triangles.push_back({i, i + 1, i + 1});
  }
  return all;
}

/// The promise of decompose.h and round_outward.h: the hulls cover, up to rounding as they are and strictly as they are written.
inline RoundedHulls expectCovers(const RepairedMesh& mesh, const std::vector<ConvexHull>& hulls, int max_vertices = 0) {
  const TriangleMesh all = surfaceOf(mesh);
  EXPECT_LE(uncovered(all, hulls), 1e-12 * sizeOf(mesh));
  const RoundedHulls fitted = roundOutward(hulls, all, 0, max_vertices);
  EXPECT_EQ(uncovered(all, fitted.hulls), 0);
  EXPECT_EQ(fitted.completed, 0u);
  return fitted;
}

/// A quarter of a ring with its bore, as a closed surface.
inline TriangleMesh bentTube(int around = 12, int across = 10, double ring = 1, double outer = 0.3, double inner = 0.22) {
  const auto at = [&](double tube, int i, int j) {
    const double a = kPi / 2 * i / around, b = 2 * kPi * (j % across) / across;
    const double r = ring + tube * std::cos(b);
    return Eigen::Vector3d(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
  };
  MeshBuilder builder;
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < around; ++i) {
      builder.quad(at(outer, i, j), at(outer, i + 1, j), at(outer, i + 1, j + 1), at(outer, i, j + 1));
      builder.quad(at(inner, i, j), at(inner, i, j + 1), at(inner, i + 1, j + 1), at(inner, i + 1, j));
    }
    builder.quad(at(inner, 0, j), at(outer, 0, j), at(outer, 0, j + 1), at(inner, 0, j + 1));
    builder.quad(at(outer, around, j), at(inner, around, j), at(inner, around, j + 1), at(outer, around, j + 1));
  }
  return builder.mesh();
}

}  // namespace test_shapes
}  // namespace collision_hulls
