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

class Winding;

/// S consists of the surface and of the points inside the parts of it that are not sheets: those
/// whose generalized winding number exceeds 1/2. Components face outward, so a closed cavity in a
/// housing counts as inside. Cracks no wider than the default weld tolerance (1e-5 of the extent)
/// count as closed. If there are openings, a computed winding number may err (by 0.01 at most,
/// proved; see TriangleBvh), so only points with 0.55 or more are treated as inside. Immutable. A
/// mesh without triangles and loose segments has an empty S, from which everything is infinitely
/// far.
///
/// What distances and bounds assume of the mesh: finite coordinates, nothing else. It may be open,
/// cross itself, or be inside out in places. Rounding is allowed for, too; what is left of it is
/// below 1e-12 of the coordinates' size, which protrusion() adds to its bound.
class Solid {
 public:
  explicit Solid(const RepairedMesh& mesh, const RunControl& control = {});
  /// The same for a mesh that was moved and turned: `before` is its solid where it was. What was
  /// proved of its triangles is not proved again.
  Solid(const RepairedMesh& moved, const Solid& before, const RunControl& control = {});
  ~Solid();
  Solid(Solid&&) noexcept;

  /// inside by the winding rule (on the surface itself: either answer)
  bool contains(const Eigen::Vector3d& p) const;
  double distanceToSurface(const Eigen::Vector3d& p) const;  ///< [m] exact
  /// [m] to S: 0 inside, distanceToSurface() outside, also near openings
  double distance(const Eigen::Vector3d& p) const;
  /// whether distance(p) is smaller, or p is inside
  bool isWithin(double distance, const Eigen::Vector3d& p) const;
  /// [m] A lower bound on the distance of p to S, for proofs that a hull that holds p protrudes;
  /// the other functions err upward. Allows for cracks, openings, and the blur of the surface.
  /// `to_surface`: distanceToSurface(p).
  double leastDistance(const Eigen::Vector3d& p, double to_surface) const;
  /// Whether p is proved to be further than `distance` [m, >= 0] from S: wherever
  /// leastDistance() is larger, and hardly anywhere else, but much faster near openings.
  bool isFurther(double distance, const Eigen::Vector3d& p, double to_surface) const;
  /// [m] Outside, distance(p). Inside, minus the radius of a ball about p that lies within S: the
  /// distance to the surface apart from sheets, less what cracks and rounding may hide; less than
  /// that near openings.
  /// `to_surface`: distanceToSurface(p).
  double signedDistance(const Eigen::Vector3d& p, double to_surface) const;
  /// [m] The same for a point of which the side is known: outside, or without openings.
  double signedDistance(const Eigen::Vector3d& p, double to_surface, bool inside) const;
  /// Whether all points within `radius` [m] of p are on its side, inside or outside. May answer no
  /// where the answer is yes, but never the reverse. `to_surface`: distanceToSurface(p).
  bool isOneSide(const Eigen::Vector3d& p, double to_surface, double radius) const;

  /// For the library itself: several questions about one point take less time together. Winding is
  /// in measure/walls.h, which is not installed.
  Winding windingAt(const Eigen::Vector3d& p) const;
  double signedDistance(Winding& at, double to_surface) const;
  /// isOneSide() for the points of a patch. `near`: of a point in its plane, best its centre.
  /// `met`, if given, receives the corners of a triangle of the surface that it meets; null if
  /// there is none.
  bool isOneSide(const std::array<Eigen::Vector3d, 3>& patch, Winding& near,
                 const std::array<Eigen::Vector3d, 3>** met = nullptr) const;

  /// [m] An upper bound on distance() within `radius` of a point with this signedDistance(). Near
  /// openings, a step out of the ball inside S may cross a border that is not surface; then only
  /// the nearest surface counts.
  double distanceWithin(double radius, double signed_distance, double to_surface) const;
  /// [m] An upper bound on the distance to S within `radius` of p: a few millionths of the extent
  /// where the surface lies in three planes at most and nothing is outside, as where parts touch;
  /// else infinite. `to_surface`: distanceToSurface(p).
  double distanceAmongWalls(const Eigen::Vector3d& p, double to_surface, double radius) const;
  /// [m] The same for local maxima of the distance to S. One of the planes may have the outside in
  /// front.
  double summitAmongWalls(const Eigen::Vector3d& p, double to_surface, double radius) const;
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
  /// [m] How far outside S a point may be that signedDistance() takes for one of S: 1e-9 of the
  /// extent if there are cracks or openings, else 0.
  double sideError() const;
  double volume() const;  ///< [m^3] sum over the components that have an inside
  Interior interior() const;
  /// The rotation into a frame in which much of the surface is axis-aligned; see
  /// geometry/own_axes.h.
  const Eigen::Matrix3d& axes() const;
  /// [m] furthest that repair() moved a point of the surface
  double weldDistance() const;
  /// a point of each component of the surface and of each loose segment
  const std::vector<Eigen::Vector3d>& componentPoints() const;

  /// Whether some point within `radius` [m] of p may be a local maximum (summit) of the distance to
  /// S, S itself apart. False only if it is proved that none is: whatever could be nearest to such
  /// a point is surface that faces one way, with nothing inside out in front of it, so the distance
  /// grows in a common direction. Always true if there are openings. `to_surface`:
  /// distanceToSurface(p).
  bool mayHoldSummit(const Eigen::Vector3d& p, double to_surface, double radius) const;
  /// The triangles of the mesh, followed by one for each loose segment. Two-sided are those whose
  /// back may be nearest to a point outside S: sheets, rims, and wherever the surface may be inside
  /// out.
  const TriangleBvh& surface() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace collision_hulls
