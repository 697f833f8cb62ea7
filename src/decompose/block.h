// What planes cut a mesh into: a piece of surface, and the solid behind it where that is to be covered as well.
#pragma once

#include <vector>

#include "collision_hulls/check/solid.h"
#include "decompose/convex_polygon.h"
#include "decompose/surface_piece.h"

namespace collision_hulls {

/// A convex part of space that planes divide.
class Region {
 public:
  Region() = default;  ///< of no interest: nothing but the surface is to be covered
  Region(const Eigen::AlignedBox3d& box, const Solid& solid);

  bool matters() const { return solid_ != nullptr; }
  bool isCut() const { return is_cut_; }

  /// The same for a part of the mesh that shares no vertex with the others.
  Region about(const Eigen::AlignedBox3d& box) const { return matters() ? Region(box, *solid_) : Region(); }

  /// Takes away what lies above the plane. Returns those corners of the section that the region's part of the solid ends at, each at least
  /// once.
  std::vector<Eigen::Vector3d> cut(const HalfSpace& plane);

 private:
  Eigen::Vector3d middle() const;

  const Solid* solid_ = nullptr;
  bool is_cut_ = false;
  std::vector<ConvexPolygon> faces_;
};

/// If the region matters, the surface holds its corners in the solid as points of their own. A point of the solid within the region
/// that lies in no segment of it is one of the surface or a corner: so the hull of a closed surface's piece holds all of the solid there.
struct Block {
  SurfacePiece surface;
  Region region;
};

/// Both parts of a block, or the block alone where the plane does not divide its surface; see cut() of a piece.
std::vector<Block> parted(const Block& block, const HalfSpace& plane, double tolerance);

/// The same by middlePlane().
std::vector<Block> halves(const Block& block, double tolerance);

/// The parts that share no vertex; not of a solid that was cut, where what holds two parts together may lie inside.
std::vector<Block> components(const Block& block);

}  // namespace collision_hulls
