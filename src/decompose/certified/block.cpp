// Splits surfaces together with the cell of space around them, for hulls that are to fill the solid (DecomposeOptions::fill).
//
// A surface alone needs no such thing: where a plane splits a closed part, its section of the solid lies in the hull of the rim that it
// leaves. But that is so for each plane by itself. After several splits a piece of the inside may have no surface near it at all. So each
// block keeps its cell, a convex polytope that starts as the mesh's box. A plane's section of the cell is a convex polygon; its corners
// inside the solid are added to both sides as points of their surface. The extreme points of solid in a cell are points of the surface or
// such corners, hence the sides' hulls hold all of the solid on their side.
//
// Linear in the cell's faces, of which there is one per split. Corners on the surface itself are decided a little inward (kInward).
#include "decompose/certified/block.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/loose_segments.h"

namespace collision_hulls {

namespace {

// As a share of the way to the cell's middle. A corner on the surface counts if the solid is on the cell's side of it.
constexpr double kInward = 1e-7;

/// Sorts the corners of a convex polygon in a plane with this normal around their mean.
ConvexPolygon ordered(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& normal) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : corners) middle += p / static_cast<double>(corners.size());
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<std::pair<double, std::size_t>> angles;
  for (std::size_t i = 0; i < corners.size(); ++i)
    angles.push_back({std::atan2(v.dot(corners[i] - middle), u.dot(corners[i] - middle)), i});
  std::sort(angles.begin(), angles.end());
  ConvexPolygon polygon;
  for (const auto& [angle, i] : angles) polygon.push_back(corners[i]);
  return polygon;
}

Block beneath(SurfacePiece surface, Cell cell, const HalfSpace& plane) {
  if (cell.matters())
    for (const Eigen::Vector3d& p : cell.keepBelow(plane)) addSegment(surface, {p, p});
  return {std::move(surface), std::move(cell)};
}

}  // namespace

Cell::Cell(const Eigen::AlignedBox3d& box, const Solid& solid) : solid_(&solid) {
  const auto corner = [&](int bits) { return box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(bits)); };
  for (const std::array<int, 4>& face :
       {std::array<int, 4>{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}})
    faces_.push_back({corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3])});
}

std::vector<Eigen::Vector3d> Cell::keepBelow(const HalfSpace& plane) {
  is_divided_ = true;
  std::vector<Eigen::Vector3d> corners;
  ConvexPolygon scratch;
  for (ConvexPolygon& face : faces_) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Eigen::Vector3d &a = face[i], &b = face[i + 1 < face.size() ? i + 1 : 0];
      const double at_a = plane.distance(a), at_b = plane.distance(b);
      if ((at_a > 0) != (at_b > 0)) corners.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    clip(
        face, [&](const Eigen::Vector3d& p) { return -plane.distance(p); }, scratch);
  }
  faces_.erase(std::remove_if(faces_.begin(), faces_.end(), [](const ConvexPolygon& face) { return face.empty(); }), faces_.end());
  if (corners.size() > 2) faces_.push_back(ordered(corners, plane.normal));
  const Eigen::Vector3d inner = middle();
  const auto ends_solid = [&](const Eigen::Vector3d& p) { return solid_->contains(p + kInward * (inner - p)); };
  corners.erase(std::remove_if(corners.begin(), corners.end(), [&](const auto& p) { return !ends_solid(p); }), corners.end());
  return corners;
}

/// Mean of all corners, counted once per face.
Eigen::Vector3d Cell::middle() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  for (const ConvexPolygon& face : faces_)
    for (const Eigen::Vector3d& p : face) sum += p, ++count;
  return sum / std::max(1.0, count);
}

std::vector<Block> parted(const Block& block, const HalfSpace& plane, double tolerance, const RunControl& control) {
  std::vector<SurfacePiece> parts = parted(block.surface, plane, tolerance, control);
  if (parts.size() < 2) return {block};
  return {beneath(std::move(parts[0]), block.cell, plane), beneath(std::move(parts[1]), block.cell, {-plane.normal, -plane.offset})};
}

std::vector<Block> halves(const Block& block, double tolerance, const RunControl& control) {
  return parted(block, middlePlane(block.surface), tolerance, control);
}

std::vector<Block> components(const Block& block, const RunControl& control) {
  if (block.cell.isDivided()) return {block};
  std::vector<Block> blocks;
  for (SurfacePiece& part : components(block.surface, control)) {
    const Cell cell = block.cell.about(boundingBox(part));
    blocks.push_back({std::move(part), cell});
  }
  return blocks;
}

}  // namespace collision_hulls
