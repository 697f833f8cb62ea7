// A piece of a mesh's surface, and operations to split it.
#pragma once

#include <utility>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Triangles that share vertices; there are no unused vertices. A point of the surface is a triangle with three equal corners, a segment
/// one with two.
using SurfacePiece = TriangleMesh;

// Where there is a control, they throw what its check() throws.

/// The parts of a piece below and above a plane. Triangles that cross the plane are divided; vertices within `tolerance` [m] of it count as
/// on it, and triangles that lie in it go below. No cap is added: the plane's section of the solid lies in each part's hull anyway.
std::pair<SurfacePiece, SurfacePiece> split(const SurfacePiece& piece, const HalfSpace& plane, double tolerance,
                                            const RunControl& control = {});

/// Both parts by split(), or the piece alone if the plane does not divide it.
std::vector<SurfacePiece> parted(const SurfacePiece& piece, const HalfSpace& plane, double tolerance, const RunControl& control = {});

/// The plane across the middle of the longest side, which divides anything that has an extent.
HalfSpace middlePlane(const SurfacePiece& piece);

/// The parts of a piece that share no vertex, in order of first triangle.
std::vector<SurfacePiece> components(const SurfacePiece& piece, const RunControl& control = {});

/// A stand-in with at most `vertices` vertices: those in one grid cell become one. For choosing splits, not for hulls.
SurfacePiece simplified(const SurfacePiece& piece, std::size_t vertices, const RunControl& control = {});

/// The edges of a piece's triangles, each once, as ascending pairs of vertices.
std::vector<std::pair<int, int>> edgesOf(const SurfacePiece& piece);

}  // namespace collision_hulls
