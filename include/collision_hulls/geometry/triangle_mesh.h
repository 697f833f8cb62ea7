// A triangle mesh: the value that the stages exchange.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "collision_hulls/control.h"

namespace collision_hulls {

using Triangle = std::array<int, 3>;

/// Indexed triangles; coordinates in metres, in the caller's frame (a link's, unless noted
/// otherwise). Corners run counter-clockwise seen from outside, where the mesh has an outside.
///
/// No invariant: a caller's mesh may hold anything. Functions that list kIndexOutOfRange and
/// kNonFiniteCoordinate, as repair() and certifiedHulls() do, refuse one that is not sound; all
/// others expect what check() lets pass.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;

  const Eigen::Vector3d& corner(int triangle, int k) const {
    return vertices[static_cast<std::size_t>(
        triangles[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(k)])];
  }
};

/// Throws kIndexOutOfRange for a triangle that names a vertex that is not there,
/// kNonFiniteCoordinate for one whose corner is NaN or infinite, kCancelled.
void check(const TriangleMesh& mesh, const RunControl& control = {});

/// The axis-aligned box [m] of the vertices used by triangles; empty for a mesh without triangles.
Eigen::AlignedBox3d boundingBox(const TriangleMesh& mesh);

/// The diagonal of boundingBox() [m], D in the paper; 0 for a mesh without triangles.
double diagonal(const TriangleMesh& mesh);

/// The sum of the triangles' areas [m^2].
double area(const TriangleMesh& mesh);

/// The volume [m^3] that a closed, outward mesh encloses; negative for an inward one. Of any other
/// mesh, the sum of the signed tetrahedra from its triangles to the first triangle's first corner.
/// 0 without triangles.
double signedVolume(const TriangleMesh& mesh);
double signedVolume(const std::vector<Eigen::Vector3d>& vertices,
                    const std::vector<Triangle>& triangles);

/// The mesh with every vertex scaled per axis. For a mirroring scale (negative product) the
/// triangles are flipped, which keeps the outside outside. Throws kBadScale for a zero or
/// non-finite factor.
TriangleMesh scaled(TriangleMesh mesh, const Eigen::Vector3d& scale);

/// The mesh moved by a rigid transform.
TriangleMesh transformed(TriangleMesh mesh, const Eigen::Isometry3d& pose);

/// Adds the vertices and triangles of another mesh. Nothing is welded.
void append(TriangleMesh& mesh, const TriangleMesh& more);

}  // namespace collision_hulls
