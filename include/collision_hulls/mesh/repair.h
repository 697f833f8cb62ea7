// From a mesh as read to a mesh with topology: weld, drop degenerate and duplicate triangles,
// orient, count.
//
// For example:
//
//     const RepairedMesh part = repair(mesh);
//     if (part.counts.open_edges > 0)
//       std::cout << "not closed: " << name(interiorOf(part)) << '\n';
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

struct RepairOptions {
  /// Vertices closer than this share of the mesh's extent (longest side of the bounding box) are
  /// welded; see repair() for seams.
  double weld_tolerance = 1e-5;
};

/// What was found and done.
struct RepairCounts {
  std::size_t welded = 0;  ///< vertices welded to another one
  /// triangles without area, dropped (`loose` holds what remains of them)
  std::size_t degenerate = 0;
  /// triangles with the same corners as an earlier one, in either order, dropped
  std::size_t duplicate = 0;
  std::size_t flipped = 0;            ///< triangles whose orientation was reversed
  std::size_t components = 0;         ///< edge-connected components
  std::size_t open_edges = 0;         ///< edges with one triangle
  std::size_t nonmanifold_edges = 0;  ///< edges with more than two triangles
  double weld_distance = 0;           ///< [m] furthest that a vertex moved
};

/// How to tell the inside of a component.
enum class Interior {
  kClosed,  ///< no open edge except on fins: the inside is what the surface encloses
  /// small openings, or slits: the inside is where the generalized winding number clearly exceeds
  /// 1/2 (see measure/solid.h)
  kWinding,
  kSurface  ///< a sheet: it has no inside, and the solid is the surface alone
};
const char* name(Interior interior);  ///< "closed", "winding", "surface"

/// [m] Two end points; equal for a point.
using Segment = std::array<Eigen::Vector3d, 2>;

struct RepairedMesh {
  /// welded, without degenerate or duplicate triangles, each component consistently oriented
  TriangleMesh mesh;
  /// per triangle: its component, 0 .. counts.components - 1, in order of first triangle
  std::vector<int> component;
  std::vector<Interior> interior;  ///< per component
  /// per triangle: 1 if it encloses nothing because it is in a kSurface component, in a fin or in a
  /// wall inside
  std::vector<char> sheet;
  /// remains of dropped degenerate triangles that are not on a side of a kept one; part of the
  /// surface
  std::vector<Segment> loose;
  RepairCounts counts;
};

/// Repairs a mesh. Welding joins each vertex to the nearest earlier representative within the
/// tolerance; no vertex moves further than that, however long a chain of close vertices is. Seams
/// are welded as well if that leaves at most half of the open edges: open edges that run along each
/// other in opposite directions, both ends within ten times the tolerance; then vertices may move
/// by up to twenty times the tolerance. A triangle is degenerate if two of its corners were welded
/// together or if its height over its longest edge is below 1e-14 of the extent, as in double
/// precision three points on a line may have.
///
/// Orientation is made consistent across manifold edges. A component may consist of several patches
/// that meet only at non-manifold edges. (1) Each patch is made consistent by flipping the part of
/// it with the smaller area. (2) A component is flipped as a whole if its patches, closed by a fan
/// over each boundary loop, together enclose a negative volume. (3) A patch that is closed on its
/// own (its fans are below a tenth of its area) and encloses a negative volume is flipped: solids
/// that share an edge, and the wall of a cavity, each end up facing outward. A volume that is
/// negligible for its area decides nothing, so a flat sheet stays as it was.
///
/// A fin is a patch that is a sheet by itself (it has open edges, and its fans are a tenth of its
/// area or more) and hangs, at non-manifold edges, on triangles that are balanced without it, i.e.
/// use each of those edges equally often in both directions. A fin is part of the surface but plays
/// no part in telling inside from outside. The same goes for a wall shared by two solids: a patch
/// whose triangles occur equally often facing either way, if the triangles it hangs on are balanced
/// without any such wall. What hangs only on these, or on itself, is none of them.
///
/// Walls inside, such as a partition across a box: if a component has open edges on fins only, but
/// is not balanced where patches meet, the patches are left out that do not border its outer space,
/// or do so on both sides. What remains, turned to face the outer space, is closed, and encloses
/// all that the component separates from the outer space. A wall that crosses the skin makes one
/// space of both, so the same is tried without patches, smallest first, that leave fewer edges with
/// an odd number of triangles, and what encloses more counts. Parts of the skin may cross each
/// other at an edge that they share. A component that so encloses only a negligible volume, or less
/// than a tenth of what its triangles do as they are, stays as it was.
///
/// An open component without its fins is kWinding if the fans that close its boundary loops (each
/// about the loop's centre) are below a tenth of its area, or would be if rims that run along each
/// other were joined (slits); else kSurface. A mesh with only degenerate triangles gives an empty
/// mesh and `loose` segments, one without triangles an empty mesh alone.
///
/// Time is near-linear; memory is about 90 bytes per triangle on top of the input. Deterministic.
/// Throws kIndexOutOfRange, kNonFiniteCoordinate, kCancelled, and kBadOption for a weld tolerance
/// outside [0, 0.1].
RepairedMesh repair(const TriangleMesh& mesh, const RepairOptions& options = {},
                    const RunControl& control = {});

/// The rule for the whole mesh, as used in reports: kClosed or kSurface if all components agree on
/// it, else kWinding.
Interior interiorOf(const RepairedMesh& mesh);

}  // namespace collision_hulls
