// The solid S that a mesh stands for, and the distance to it: what protrusion is measured against.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

/// S: the surface, and the points inside what of it is no sheet: generalized winding number > 1/2. With openings it is > 0.55, since what
/// computes such numbers errs by some hundredths, here by 0.02 at most. Components are oriented outward, so that a closed cavity within a
/// housing is inside. Cracks of the surface no wider than vertices are welded over by default (1e-5 of the extent) count as closed.
/// Immutable, thread safe.
class Solid {
 public:
  explicit Solid(const RepairedMesh& mesh, const RunControl& control = {});
  ~Solid();
  Solid(Solid&&) noexcept;

  bool contains(const Eigen::Vector3d& p) const;                   ///< inside by the winding rule (the surface itself: either)
  double distanceToSurface(const Eigen::Vector3d& p) const;        ///< [m] exact
  double distance(const Eigen::Vector3d& p) const;                 ///< [m] to S; 0 inside. Outside to its surface, also by openings
  bool isWithin(double distance, const Eigen::Vector3d& p) const;  ///< whether distance(p) is smaller, or p inside
  /// [m] distance(p) outside; inside, the negative radius of a ball about p that lies within S: the distance to the surface, less four
  /// times the widest crack, or less near openings. `to_surface`: distanceToSurface(p).
  double signedDistance(const Eigen::Vector3d& p, double to_surface) const;
  /// [m] What a distance to the surface may tell too much by inside, and off the surface about where inside and outside meet, for cracks
  /// that count as closed; 0 without such.
  double crackSlack() const;
  /// [m] No point within `radius` of one at this signedDistance() has a larger distance(). Near openings a step out of the ball may lead
  /// to the far side of a border that is no surface, where the nearest wall counts.
  double distanceWithin(double radius, double signed_distance, double to_surface) const;
  /// [m] No point of a patch is further from the surface: where it lies over one flat part of a sheet, and no more than `slack` [m]
  /// beyond, its height above that and the slack, else infinite. `near`: the point of the surface nearest to one of the patch.
  double heightAboveSheet(const std::array<Eigen::Vector3d, 3>& patch, const TriangleBvh::Nearest& near, double slack) const;
  /// [m] No path from p to a border of S that is no surface is shorter, unless it crosses the surface.
  double wayToBorder(const Eigen::Vector3d& p) const;
  bool hasOpenings() const;  ///< whether S has borders that are no surface: distance() then jumps where they are crossed
  double volume() const;     ///< [m^3] of the components that have an inside (sum)
  Interior interior() const;
  /// The rotation into a frame along whose axes much of the surface lies flat; see geometry/own_axes.h.
  const Eigen::Matrix3d& axes() const;
  double weldDistance() const;                                  ///< [m] furthest that repair moved a point of the surface
  const std::vector<Eigen::Vector3d>& componentPoints() const;  ///< a point of each component of the surface and of each loose segment

  /// Its triangles are those of the mesh, then one for each loose segment. Where it facesOneWay(p, distanceToSurface(p) + 2 * radius)
  /// and wayToBorder(p) is longer than that, no point within `radius` of p is a local maximum of the distance to S, S itself apart:
  /// all that could be nearest to it is surface that faces one way, so that the distance grows in a common direction. Assumes that a
  /// region of negative winding, if there is one, is met by one of 5,000 probes over the surface.
  const TriangleBvh& surface() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace collision_hulls
