// The question that a decomposition asks over and over: does this hull protrude further than the
// tolerance? A hull that does not, and whose parts in regions keep the regions' tolerances, is said
// to *fit*. An *intruder* is a point of a hull whose
// distance from the solid exceeds the tolerance: it refutes every hull that contains it. The
// *share* is the part of the tolerance from which on points count as intruders while leaves are
// split. A hull's *reach* is the octree's upper bound on its protrusion; a *pocket* is a place
// inside a hull that is further from the solid than the hull's whole surface.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/decompose/region.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/measure/solid.h"
#include "decompose/certified/known_facets.h"
#include "decompose/certified/rough_hull.h"
#include "measure/outside_distance.h"

namespace collision_hulls {

/// The hull of about `most` of a hull's vertices, the support points in as many directions: close
/// to the original where that is round. Returns the hull itself if it does not have many more
/// vertices.
ConvexHull thinned(const ConvexHull& hull, std::size_t most);

/// Answers by tests in order of cost: intruders (points outside the solid by more than the
/// tolerance) that refuted earlier hulls; an octree of distances shared by all hulls; and, where
/// its bound leaves the answer open, searches over those of the hull's facets that no earlier hull
/// had, and for pockets inside it.
/// Not thread safe.
class ProtrusionOracle {
 public:
  /// `box` should contain the solid and most of the hulls; proofs take longer for hulls that reach
  /// outside it.
  ProtrusionOracle(const Solid& solid, const Eigen::AlignedBox3d& box, double tolerance, const RunControl& control,
                   const std::vector<Region>& regions = {});

  /// An oracle for hulls within `part` of the box, which starts with what this one knows there; for
  /// use in parallel to this one.
  ProtrusionOracle forPart(const Eigen::AlignedBox3d& part) const;

  /// Takes over what an oracle for a part has learned.
  void learn(const ProtrusionOracle& part);

  /// Whether the hull of the points, which is not built for that, holds one of the intruders that
  /// refuted most hulls before. False says nothing.
  bool refutes(const std::vector<Eigen::Vector3d>& points);

  /// False: the hull does not fit. True: it most likely does.
  bool mayFit(const ConvexHull& hull);

  /// The same, more thoroughly.
  bool mayWellFit(const ConvexHull& hull);

  /// [m] upper bound on the distance of the hull's points from the solid, down to the octree's
  /// finest cells; infinite: the hull does not fit.
  double reach(const ConvexHull& hull);

  /// True: no point of the hull's surface is further from the solid than 99.9 % of the tolerance,
  /// provably, and no pocket came to light. After provePockets(): no point of the hull is further
  /// than the tolerance, provably.
  bool fits(const ConvexHull& hull) { return fitsWithin(hull, reach(hull)); }

  /// The same for a hull whose reach() is known.
  bool fitsWithin(const ConvexHull& hull, double reach);

  /// The same for several hulls, searched in parallel.
  std::vector<char> fit(const std::vector<const ConvexHull*>& hulls);

  /// Whether a hull that fits may still hold a pocket further from the solid than the tolerance, by
  /// a thorough search.
  bool mayHoldPocket(const ConvexHull& hull);

  /// The same for several hulls, in parallel.
  std::vector<char> mayHoldPockets(const std::vector<ConvexHull>& hulls);

  /// Makes fits(), fitsWithin() and fit() search each hull so. That takes long, and pockets that a
  /// glance does not find are rare: first do without, and ask about the hulls that remain.
  void provePockets();

  /// [m] An upper bound on the largest protrusion of any hulls, within a few per cent of it or of
  /// the tolerance. What protrudes in a region counts for more, by as much as its tolerance is
  /// smaller. Of hulls that protrude less than others nothing closer is asked, so one call for all
  /// takes far less than one for each.
  double bound(const std::vector<ConvexHull>& hulls);

  /// [m] For one hull, the bound for its surface, or the distance of an inner point if a larger one
  /// came to light: a pocket may be deeper.
  double estimate(const ConvexHull& hull);

  /// Points of the hull outside the solid by more than the tolerance, evenly spread: at least one,
  /// at most twice `wanted`.
  std::vector<OutsideDistance::Intruder> intruders(const ConvexHull& hull, std::size_t wanted);

  const Solid& solid() const { return solid_; }
  const RunControl& control() const { return control_; }
  double tolerance() const { return tolerance_; }
  void setTolerance(double tolerance);  ///< [m] keeps what was learned about the solid

  /// Points count as intruders from this share of the tolerance on; proofs always refer to the
  /// whole tolerance.
  void setShare(double share);

 private:
  /// A region, with an oracle for the parts of hulls in it.
  struct Watch {
    Region region;
    double ratio = 1;  // of its tolerance to the oracle's
    std::unique_ptr<ProtrusionOracle> oracle;
  };
  using Question = std::function<bool(ProtrusionOracle& oracle, const ConvexHull& part)>;
  bool holdsInRegions(const ConvexHull& hull, const Question& question);
  bool fitsInRegions(const ConvexHull& hull);
  bool holdsKnownIntruder(const ConvexHull& hull);
  template <typename Holds>
  bool isKnownIntruder(std::size_t most, const Holds& holds);
  std::optional<bool> fitsByOctree(const ConvexHull& hull, double reach) const;
  Protrusion onSurface(const ConvexHull& hull, double limit, double gap) const;
  Protrusion onSurfaceAsWritten(const ConvexHull& hull) const;
  ConvexHull written(const ConvexHull& hull) const;
  /// Of a look at the known intruders and into the octree.
  struct Descent {
    double reach = 0;      // upper bound on the distance; infinite: the hull contains an intruder
    bool gave_up = false;  // before it reached the finest cells
  };
  Descent descend(const ConvexHull& hull, double resolution);
  bool mayFit(const ConvexHull& hull, const Descent& descent);
  bool concluded(const ConvexHull& hull, const Protrusion& on_surface);
  OutsideDistance::Largest summit(const ConvexHull& hull, double surface_bound, std::size_t most_visits);
  bool isTooSmallForPockets(const ConvexHull& hull) const;
  void askForPockets(const std::vector<ConvexHull>& hulls, const std::vector<std::size_t>& some, std::vector<char>& may_hold);
  void remember(const Eigen::Vector3d& intruder);
  void rememberOnSurface(const Eigen::Vector3d& intruder, const ConvexHull& hull);
  double intrusion() const;
  /// A hull as it is written, and what its surface tells.
  struct Skin {
    ConvexHull hull;
    double found = 0, bound = 0, gap = 0;  // [m] of the distance from the solid: at a point; on the surface; and how close bounds are
    double floor() const { return std::max(found, bound) + gap; }
  };
  Skin skinOf(const ConvexHull& exact);
  double boundWithin(const Skin& skin, double floor);

  const Solid& solid_;
  const RunControl& control_;
  const Eigen::AlignedBox3d box_;
  double tolerance_, share_ = 1;
  bool proves_pockets_ = false;
  OutsideDistance outside_;
  std::vector<Eigen::Vector3d> known_;  // intruders, the most useful ones first
  KnownFacets facets_;
  std::vector<Watch> watches_;
};

}  // namespace collision_hulls
