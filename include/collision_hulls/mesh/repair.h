// From a mesh as read to a mesh with topology: weld, drop, orient, count.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

struct RepairOptions {
  /// Vertices closer than this share of the mesh's extent (longest side of the bounding box) are one vertex.
  double weld_tolerance = 1e-5;
};

/// What was found and done, as counts.
struct RepairCounts {
  std::size_t welded = 0;             ///< vertices that were joined to another one
  std::size_t degenerate = 0;         ///< triangles without area, dropped (what is left of them is in `loose`)
  std::size_t duplicate = 0;          ///< triangles with the corners of an earlier one, in either order, dropped
  std::size_t flipped = 0;            ///< triangles turned over
  std::size_t components = 0;         ///< edge-connected components
  std::size_t open_edges = 0;         ///< edges of one triangle
  std::size_t nonmanifold_edges = 0;  ///< edges of more than two triangles
  double weld_distance = 0;           ///< [m] furthest that a vertex was moved; at most the tolerance
};

/// Which rule says what lies inside a component.
enum class Interior {
  kClosed,   ///< no open edge but of fins: inside is what the surface encloses
  kWinding,  ///< small openings: inside is where the generalized winding number exceeds 1/2 by enough (check/solid.h)
  kSurface   ///< a sheet: nothing is inside, the solid is the surface alone
};
const char* name(Interior interior);  ///< "closed", "winding", "surface"

/// [m] Both ends; a point where they are equal.
using Segment = std::array<Eigen::Vector3d, 2>;

struct RepairedMesh {
  TriangleMesh mesh;               ///< welded, without degenerate or duplicate triangles, each component consistently oriented
  std::vector<int> component;      ///< per triangle: its component, 0 .. counts.components - 1, in order of first triangle
  std::vector<Interior> interior;  ///< per component
  std::vector<char> sheet;         ///< per triangle: 1 where it encloses nothing, in a component that is kSurface or in a fin
  std::vector<Segment> loose;      ///< what is left of dropped degenerate triangles and is no side of a kept one; part of the surface
  RepairCounts counts;
};

/// Repairs a mesh. Welding joins each vertex to the nearest one before it that stands for itself and lies within the tolerance,
/// so none moves further than that, however long a chain of close vertices is. A triangle is degenerate when two of its corners
/// were welded, or when its height over its longest edge is nil in double precision.
///
/// Orientation is made consistent across manifold edges. A component may fall into patches that meet at non-manifold edges
/// only. Each patch is made consistent by turning over the smaller part of its area; then a component whose patches, closed by
/// a fan over each boundary loop, enclose a negative volume in sum is turned over as a whole; last, a patch that is closed on
/// its own (its fans are below a tenth of its area) and encloses a negative volume is turned over, so that solids which share
/// an edge, and a cavity's own wall, are outward each. A volume that is nil for the area decides nothing: a flat sheet stays as
/// it was.
///
/// A patch that is a sheet by itself (it has open edges, and its fans are a tenth of its area or more) and hangs, at non-manifold edges, on
/// triangles that are balanced without it (run along those edges equally often in both directions) is a fin: part of the surface that takes
/// no part in telling inside from outside. So is a wall that two solids share, of triangles that were there facing either way equally
/// often, where what it hangs on is balanced without all such walls. An open component, fins apart, is kWinding where the area that would
/// close its boundary loops (fan of each loop about its centre) is below a tenth of its own area, else kSurface. A mesh of degenerate
/// triangles alone gives an empty mesh and `loose` segments. Near-linear in time; about 90 bytes a triangle beside the input.
/// Deterministic. Thread safe. Throws kIndexOutOfRange, kNonFiniteCoordinate, kCancelled, and kBadOption for a weld tolerance outside [0,
/// 0.1].
RepairedMesh repair(const TriangleMesh& mesh, const RepairOptions& options = {}, const RunControl& control = {});

/// The rule of the whole mesh, as it stands in reports: kClosed if every component is, kSurface if every one is, else kWinding.
Interior interiorOf(const RepairedMesh& mesh);

}  // namespace collision_hulls
