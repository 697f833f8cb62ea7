// How far a surface is from a union of bodies, with proof.
#pragma once

#include <memory>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/measure/solid.h"
#include "collision_hulls/verify/verify.h"
#include "verify/link_bodies.h"

namespace collision_hulls {

/// The bodies of a link as a set of points. Immutable, thread safe.
class BodySet {
 public:
  explicit BodySet(const LinkBodies& bodies, const RunControl& control = {});

  /// [m] From p to the nearest body, 0 inside.
  double distance(const Eigen::Vector3d& p) const;

  const std::vector<ConvexHull>& hulls() const { return hulls_; }           ///< boxes included
  const std::vector<GeometryElement>& rounds() const { return rounds_; }    ///< spheres and cylinders
  const std::vector<ConvexHull>& inner() const { return inner_; }           ///< the hulls, and polyhedra inside the round ones
  const std::vector<Eigen::AlignedBox3d>& boxes() const { return boxes_; }  ///< of the hulls, then of the round ones
  double convexDistance(std::size_t body,
                        const Eigen::Vector3d& p) const;  ///< [m] to a hull or, after these, a round one; a convex function
  const Solid* rest() const { return rest_.get(); }       ///< of the meshes that are not convex; null: none
  const Solid* whole() const { return whole_.get(); }     ///< of these and inner() as one; null without rest()
  double innerError() const { return inner_error_; }      ///< [m] of the polyhedra inside round ones

 private:
  std::vector<ConvexHull> hulls_, inner_;
  std::vector<GeometryElement> rounds_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::unique_ptr<const Solid> rest_, whole_;
  double inner_error_ = 0;
};

/// The largest distance of a point of the surface from the bodies. The bound exceeds what was found by 1 %, or by `gap` [m] if that is
/// more, unless the search does not converge.
Largest furthestFrom(const BodySet& bodies, const TriangleMesh& surface, double gap, const RunControl& control = {});

}  // namespace collision_hulls
