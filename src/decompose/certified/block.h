// A *block* is what planes split a mesh into: a piece of surface and, if the solid is to be filled,
// the convex *cell* of space behind it.
#pragma once

#include <vector>

#include "collision_hulls/measure/solid.h"
#include "decompose/convex_polygon.h"
#include "decompose/surface_piece.h"

namespace collision_hulls {

/// A convex part of space, made smaller by planes.
class Cell {
 public:
  Cell() = default;  ///< irrelevant: only the surface is to be covered
  Cell(const Eigen::AlignedBox3d& box, const Solid& solid);

  bool matters() const { return solid_ != nullptr; }
  bool isDivided() const { return is_divided_; }

  /// The corresponding cell for a part of the mesh that shares no vertex with the others.
  Cell about(const Eigen::AlignedBox3d& box) const { return matters() ? Cell(box, *solid_) : Cell(); }

  /// Removes everything above the plane. Returns the corners of the section where the cell's part
  /// of the solid ends, each at least once.
  std::vector<Eigen::Vector3d> keepBelow(const HalfSpace& plane);

 private:
  Eigen::Vector3d middle() const;

  const Solid* solid_ = nullptr;
  bool is_divided_ = false;
  std::vector<ConvexPolygon> faces_;
};

/// If the cell matters, the surface includes the cell's corners inside the solid as separate
/// points. Every extreme point of the solid within the cell is then a point of the surface or a
/// corner, so the hull of a piece of a closed surface contains all of the solid there.
struct Block {
  SurfacePiece surface;
  Cell cell;
};

/// Both parts of a block, or the block alone if the plane does not divide its surface; see split()
/// of a surface piece.
std::vector<Block> parted(const Block& block, const HalfSpace& plane, double tolerance, const RunControl& control = {});

/// The same, by middlePlane().
std::vector<Block> halves(const Block& block, double tolerance, const RunControl& control = {});

/// The parts that share no vertex. A solid that was split stays in one part: its parts may be
/// connected on the inside.
std::vector<Block> components(const Block& block, const RunControl& control = {});

}  // namespace collision_hulls
