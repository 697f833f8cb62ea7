// The solid S that a mesh represents, and the distance to it: the reference for protrusion.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

/// S consists of the surface and of the points inside the parts of it that are not sheets: those
/// whose generalized winding number exceeds 1/2. If there are openings the limit is 0.55, because
/// computed winding numbers err by some hundredths (here by at most 0.02). Components face outward,
/// so a closed cavity in a housing counts as inside. Cracks no wider than the default weld
/// tolerance (1e-5 of the extent) count as closed. Immutable, thread safe.
class Solid {
 public:
  explicit Solid(const RepairedMesh& mesh, const RunControl& control = {});
  ~Solid();
  Solid(Solid&&) noexcept;

  /// inside by the winding rule (on the surface itself: either answer)
  bool contains(const Eigen::Vector3d& p) const;
  double distanceToSurface(const Eigen::Vector3d& p) const;  ///< [m] exact
  /// [m] to S: 0 inside, distanceToSurface() outside, also near openings
  double distance(const Eigen::Vector3d& p) const;
  /// whether distance(p) is smaller, or p is inside
  bool isWithin(double distance, const Eigen::Vector3d& p) const;
  /// [m] Outside, distance(p). Inside, minus the radius of a ball about p that lies within S: the
  /// distance to the surface, less four times the width of the widest crack; less than that near
  /// openings. `to_surface`: distanceToSurface(p).
  double signedDistance(const Eigen::Vector3d& p, double to_surface) const;
  /// [m] How far cracks that count as closed can mislead: inside, the border of S may be nearer
  /// than the surface by this much, and inside may meet outside this far off the surface. 0 if
  /// there are no cracks.
  double crackSlack() const;
  /// [m] An upper bound on distance() within `radius` of a point with this signedDistance(). Near
  /// openings, a step out of the ball inside S may cross a border that is not surface; then only
  /// the nearest surface counts.
  double distanceWithin(double radius, double signed_distance, double to_surface) const;
  /// [m] An upper bound on the distance of a patch's points from the surface. If the patch lies
  /// over one flat part of a sheet, or sticks out sideways by at most `slack` [m], it is the
  /// patch's height above that part plus the slack, else infinite. `near`: the point of the surface
  /// nearest to a point of the patch.
  double heightAboveSheet(const std::array<Eigen::Vector3d, 3>& patch,
                          const TriangleBvh::Nearest& near, double slack) const;
  /// [m] A lower bound on the length of any path from p to a border of S that is not surface, among
  /// paths that do not cross the surface.
  double wayToBorder(const Eigen::Vector3d& p) const;
  /// whether S has borders that are not surface; distance() jumps where they are crossed
  bool hasOpenings() const;
  double volume() const;  ///< [m^3] sum over the components that have an inside
  Interior interior() const;
  /// The rotation into a frame in which much of the surface is axis-aligned; see
  /// geometry/own_axes.h.
  const Eigen::Matrix3d& axes() const;
  /// [m] furthest that repair() moved a point of the surface
  double weldDistance() const;
  /// a point of each component of the surface and of each loose segment
  const std::vector<Eigen::Vector3d>& componentPoints() const;

  /// The triangles of the mesh, followed by one for each loose segment. If surface().facesOneWay(p,
  /// distanceToSurface(p) + 2 * radius) and wayToBorder(p) is longer than that, then no point
  /// within `radius` of p is a local maximum of the distance to S, S itself apart. Why: whatever
  /// could be nearest to such a point is surface that faces one way, so the distance grows in a
  /// common direction. This assumes that a region of negative winding, if there is one, is met by
  /// one of 5,000 probes over the surface.
  const TriangleBvh& surface() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace collision_hulls
