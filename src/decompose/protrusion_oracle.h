// The question that a decomposition asks again and again: does this hull protrude further than the tolerance?
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "check/outside_distance.h"
#include "collision_hulls/check/measures.h"
#include "collision_hulls/check/solid.h"
#include "collision_hulls/control.h"
#include "geometry/quickhull.h"

namespace collision_hulls {

/// A hull of points near the origin with a face per triangle, as quickhull leaves it where it can: for hulls that are asked about once
/// and mostly thrown away. Where points lie in planes it is larger than theirs, by up to a millionth of its size.
ConvexHull roughHull(const std::vector<Eigen::Vector3d>& points, Corners corners = Corners::kNeeded);

/// The hull of about `most` of a hull's vertices, those furthest along as many directions: close to it where it is round. The hull
/// itself where it has not many more.
ConvexHull thinned(const ConvexHull& hull, std::size_t most);

/// Answers in tests, cheapest first: intruders (points outside the solid by more than the tolerance) that refuted earlier hulls, an
/// octree of distances that the hulls share, and, where its bound leaves something open, a search over the hull's surface and one for
/// pockets within. Not thread safe.
class ProtrusionOracle {
 public:
  /// `box` holds the solid and most hulls that are asked about; it takes longer to prove others.
  ProtrusionOracle(const Solid& solid, const Eigen::AlignedBox3d& box, double tolerance, const RunControl& control);

  /// One for hulls within `part` of the box, which knows what this one knows there: for use beside it.
  ProtrusionOracle forPart(const Eigen::AlignedBox3d& part) const;

  /// Takes over what one for a part has learned.
  void learn(const ProtrusionOracle& part);

  /// False: the hull protrudes too far. True: most likely it does not.
  bool mayFit(const ConvexHull& hull);

  /// The same, more thoroughly.
  bool mayWellFit(const ConvexHull& hull) { return !std::isinf(reach(hull)); }

  /// [m] No point of the hull is further from the solid, as far as the octree tells, whose finest cells are asked; infinite: it protrudes
  /// too far.
  double reach(const ConvexHull& hull);

  /// True: no point of the hull is further from the solid than the tolerance, none of its surface further than 99.8 % of it, by proof.
  bool fits(const ConvexHull& hull) { return fitsWithin(hull, reach(hull)); }

  /// The same of a hull whose reach() is known.
  bool fitsWithin(const ConvexHull& hull, double reach);

  /// The same of several hulls, searched at the same time.
  std::vector<char> fit(const std::vector<const ConvexHull*>& hulls);

  /// An upper bound of the protrusion of any hull, within a few per cent of it or of the tolerance.
  double bound(const ConvexHull& hull);

  /// Points of the hull outside the solid by more than the tolerance, evenly spread, two times `wanted` at most; at least one.
  std::vector<OutsideDistance::Intruder> intruders(const ConvexHull& hull, std::size_t wanted);

  const Solid& solid() const { return solid_; }
  const RunControl& control() const { return control_; }
  double tolerance() const { return tolerance_; }
  void setTolerance(double tolerance);  ///< [m] what was learned of the solid is kept

  /// Intruders count from this share of the tolerance on; proofs are of the whole tolerance always.
  void setShare(double share);

 private:
  bool holdsKnownIntruder(const ConvexHull& hull);
  std::optional<bool> fitsByOctree(const ConvexHull& hull, double reach) const;
  Protrusion onSurface(const ConvexHull& hull) const;
  ConvexHull written(const ConvexHull& hull) const;
  bool concluded(const ConvexHull& hull, const Protrusion& on_surface);
  bool mayHoldPocket(const ConvexHull& hull, double surface_bound);
  double reachByOctree(const ConvexHull& hull, double resolution);  // no point is further; infinite: it holds an intruder
  void remember(const Eigen::Vector3d& intruder);
  double intrusion() const;

  const Solid& solid_;
  const RunControl& control_;
  const Eigen::AlignedBox3d box_;
  double tolerance_, share_ = 1;
  OutsideDistance outside_;
  std::vector<Eigen::Vector3d> known_;  // intruders, the most useful ones first
};

}  // namespace collision_hulls
