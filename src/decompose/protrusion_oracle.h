// The question that a decomposition asks again and again: how far does this hull protrude?
#pragma once

#include <limits>

#include "check/outside_distance.h"
#include "collision_hulls/check/solid.h"
#include "collision_hulls/control.h"

namespace collision_hulls {

/// Answers by an octree that finds deep intrusions at once and keeps what it computed, and by an exact search over the hull's
/// surface where the octree finds none. Not thread safe.
class ProtrusionOracle {
 public:
  /// `tolerance` [m] sets how finely is searched; `box` holds every hull that is asked about.
  ProtrusionOracle(const Solid& solid, const Eigen::AlignedBox3d& box, double tolerance, const RunControl& control);

  /// An upper bound of the protrusion, within 2 % of the tolerance of the truth, where that does not pass the tolerance;
  /// infinite where it does. Protrusions up to `known`, a lower bound that the caller has, are not told apart.
  double within(const ConvexHull& hull, double known = 0);

  /// An upper bound of the protrusion however large, within 2 % of the tolerance or 5 % of itself.
  double however(const ConvexHull& hull);

  /// Points of the hull outside the solid by more than the tolerance, evenly spread; at least one, a few dozen where the
  /// hull protrudes much.
  std::vector<OutsideDistance::Intruder> intruders(const ConvexHull& hull);

  const Solid& solid() const { return solid_; }
  double tolerance() const { return tolerance_; }
  const RunControl& control() const { return control_; }

 private:
  OutsideDistance::Intruder furthest(const ConvexHull& hull) const;

  const Solid& solid_;
  double tolerance_;
  const RunControl& control_;
  OutsideDistance outside_;
};

}  // namespace collision_hulls
