// Elements and meshes for the tests of verify, and a distance in higher precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "collision_hulls/robot/robot_description.h"
#include "random_points.h"
#include "shapes.h"

namespace collision_hulls {
namespace test_shapes {

inline GeometryElement roundElement(GeometryElement::Kind kind, double radius, double length = 0) {
  GeometryElement element;
  element.kind = kind;
  element.size = {radius, length, 0};
  element.origin = Eigen::Translation3d(0.3, -0.2, 0.1) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  return element;
}

inline GeometryElement boxElement(const Eigen::Vector3d& size, const Eigen::Vector3d& place) {
  GeometryElement element;
  element.kind = GeometryElement::Kind::kBox;
  element.size = size;
  element.origin = Eigen::Translation3d(place);
  return element;
}

/// A mesh whose upper faces, at z = 1, have vertices of their own, higher by this, to which repair() welds them.
inline TriangleMesh withLooseTop(TriangleMesh mesh, double higher) {
  std::vector<Eigen::Vector3d>& vertices = mesh.vertices;
  for (Triangle& t : mesh.triangles) {
    if (std::any_of(t.begin(), t.end(), [&](int v) { return vertices[static_cast<std::size_t>(v)].z() < 1; })) continue;
    for (int& v : t) {
      vertices.emplace_back(vertices[static_cast<std::size_t>(v)] + higher * Eigen::Vector3d::UnitZ());
      v = static_cast<int>(vertices.size()) - 1;
    }
  }
  return mesh;
}

constexpr double kHigher = 5e-6;  // half of what is welded in a mesh of 1 m

using Exact = long double;
using ExactVector = Eigen::Matrix<Exact, 3, 1>;

/// A bracket that is turned and far away, and a tiny triangle near the middle of the outer side of its leg.
struct FarAway {
  explicit FarAway(std::uint32_t seed) {
    test_shapes::RandomPoints random(seed);
    const Eigen::Isometry3d pose =
        Eigen::Translation3d(1e6 * random.onSphere()) * Eigen::Isometry3d(random.rotation()) * Eigen::Translation3d(-0.5, 0, -0.5);
    bracket = transformed(lBracket(), pose);
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(0.6, -0.3, 0.4), Eigen::Vector3d(0.61, -0.3, 0.4), Eigen::Vector3d(0.6, -0.3, 0.41)})
      speck.vertices.push_back(pose * p);
    speck.triangles = {{0, 1, 2}};
    for (const Triangle& t : bracket.triangles)
      if (std::all_of(t.begin(), t.end(), [&](int v) { return std::abs((pose.inverse() * vertex(v)).y()) < 0.01; })) side.push_back(t);
  }
  const Eigen::Vector3d& vertex(int v) const { return bracket.vertices[static_cast<std::size_t>(v)]; }

  /// Of the speck, as its coordinates are, from the side, in higher precision: near the middle, planes are nearest.
  Exact distance() const {
    Exact most = 0;
    for (const Eigen::Vector3d& p : speck.vertices) {
      Exact least = std::numeric_limits<Exact>::infinity();
      for (const Triangle& t : side) {
        const ExactVector a = vertex(t[0]).cast<Exact>(), b = vertex(t[1]).cast<Exact>(), c = vertex(t[2]).cast<Exact>();
        least = std::min(least, std::abs((b - a).cross(c - a).normalized().dot(p.cast<Exact>() - a)));
      }
      most = std::max(most, least);
    }
    return most;
  }

  TriangleMesh bracket, speck;
  std::vector<Triangle> side;
};

}  // namespace test_shapes
}  // namespace collision_hulls
