// A *block* is what planes split a mesh into: a piece of surface and, if the solid is to be filled,
// the convex *region* of space behind it.
#pragma once

#include <vector>

#include "collision_hulls/measure/solid.h"
#include "decompose/convex_polygon.h"
#include "decompose/surface_piece.h"

namespace collision_hulls {

/// A convex region of space, made smaller by planes.
class Region {
 public:
  Region() = default;  ///< irrelevant: only the surface is to be covered
  Region(const Eigen::AlignedBox3d& box, const Solid& solid);

  bool matters() const { return solid_ != nullptr; }
  bool isDivided() const { return is_divided_; }

  /// The corresponding region for a part of the mesh that shares no vertex with the others.
  Region about(const Eigen::AlignedBox3d& box) const { return matters() ? Region(box, *solid_) : Region(); }

  /// Removes everything above the plane. Returns the corners of the section where the region's part
  /// of the solid ends, each at least once.
  std::vector<Eigen::Vector3d> keepBelow(const HalfSpace& plane);

 private:
  Eigen::Vector3d middle() const;

  const Solid* solid_ = nullptr;
  bool is_divided_ = false;
  std::vector<ConvexPolygon> faces_;
};

/// If the region matters, the surface includes the region's corners inside the solid as separate
/// points. Every extreme point of the solid within the region is then a point of the surface or a
/// corner, so the hull of a piece of a closed surface contains all of the solid there.
struct Block {
  SurfacePiece surface;
  Region region;
};

/// Both parts of a block, or the block alone if the plane does not divide its surface; see split()
/// of a surface piece.
std::vector<Block> parted(const Block& block, const HalfSpace& plane, double tolerance);

/// The same, by middlePlane().
std::vector<Block> halves(const Block& block, double tolerance);

/// The parts that share no vertex. A solid that was split stays in one part: its parts may be
/// connected on the inside.
std::vector<Block> components(const Block& block);

}  // namespace collision_hulls
