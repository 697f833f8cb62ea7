// How far a triangle lies beneath a hull along its normal: the inner maximum of equation (6) of
// Mamou & Ghorbel 2009.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "collision_hulls/geometry/convex_hull.h"
#include "decompose/box_tree.h"

namespace collision_hulls {

/// The distance along a ray to a face's plane, as an affine function of where the ray starts,
/// relative to some origin.
struct ExitFunction {
  Eigen::Vector3d slope;
  double constant;
  double operator()(const Eigen::Vector3d& m) const { return slope.dot(m) + constant; }
};

/// The faces of a hull, arranged for finding where rays leave it. Keeps a reference to the hull.
/// Thread safe.
class ExitFaces {
 public:
  explicit ExitFaces(const ConvexHull& hull);

  /// The face through which the ray from origin + m along the unit vector `along` leaves the hull,
  /// the first one on a tie; -1 if no face looks that way. origin + m must lie in the hull, up to
  /// rounding. About sqrt(faces) steps on round hulls.
  int firstExit(const Eigen::Vector3d& origin, const Eigen::Vector3d& m, const Eigen::Vector3d& along) const;

  /// Only for a face that looks along the ray.
  ExitFunction exitFunction(int face, const Eigen::Vector3d& origin, const Eigen::Vector3d& along) const;

 private:
  using Planes = BoxTree<4, 8>;  // normal, offset

  const ConvexHull& hull_;
  Eigen::Vector3d centre_;
  double scale_, rounding_;
  Planes tree_;
};

/// The largest ||M - P(M)|| [m] over the points M of a triangle within the hull, where the half-ray
/// from M along `normal` (the triangle's unit normal) leaves the hull at P(M).
///
/// The exit distance is the minimum of one affine function of M per face that looks along the
/// normal. It is concave and piecewise linear over the triangle; its maximum is generally not at a
/// corner. Cutting planes find it exactly, up to rounding:
///
///   M <- centroid
///   repeat
///     f <- the face where the ray from M leaves                      its distance there is a lower
///     bound M <- maximum of f's function over the part of the triangle     its value there is an
///     upper bound
///          where f is below the faces found before
///   until the bounds meet, or the upper bound is at most `known`
///
/// Returns the lower bound, so any value up to `known` means "at most known". 0 if no face looks
/// along the normal.
double concavityOfTriangle(const ExitFaces& faces, const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& normal,
                           double known = 0);

}  // namespace collision_hulls
