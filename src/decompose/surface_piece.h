// A piece of a mesh's surface, and what cutting does to it.
#pragma once

#include <utility>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Triangles with shared vertices, all of which triangles use. A point of the surface is a triangle of three equal corners, a segment one
/// of two.
using SurfacePiece = TriangleMesh;

/// The parts of a piece beneath and above a plane. Triangles are divided where they cross it; vertices within `tolerance` [m]
/// of the plane count as on it, and triangles that lie in it go beneath. No cap is added: the plane's section of the solid
/// lies in the hull of each part by itself.
std::pair<SurfacePiece, SurfacePiece> cut(const SurfacePiece& piece, const HalfSpace& plane, double tolerance);

/// Both parts by cut(), or the piece alone where the plane does not divide it.
std::vector<SurfacePiece> parted(const SurfacePiece& piece, const HalfSpace& plane, double tolerance);

/// The plane in the middle of the longest side, which divides whatever has an extent.
HalfSpace middlePlane(const SurfacePiece& piece);

/// The parts of a piece that share no vertex, in order of their first triangle.
std::vector<SurfacePiece> components(const SurfacePiece& piece);

/// A stand-in of at most `vertices` vertices: those in one cell of a grid become one. For choosing among cuts, not for hulls.
SurfacePiece simplified(const SurfacePiece& piece, std::size_t vertices);

/// The edges of a piece's triangles, each once, as pairs of vertices in ascending order.
std::vector<std::pair<int, int>> edgesOf(const SurfacePiece& piece);

}  // namespace collision_hulls
