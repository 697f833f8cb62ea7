// Proves, by branch and bound, which pairs of bodies can never come near each other, whatever the
// joints do.
//
// For example:
//
//     const ReachProver prover(kinematics, hull_of_each_link, scene);
//     const Reach reach = prover.betweenLinkAndBody(3, 0, 0.01);  // within 1 cm?
//     const bool never = reach.outcome == Reach::Outcome::kProved;
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/robot/kinematics.h"
#include "collision_hulls/scene/scene.h"

namespace collision_hulls {

struct ReachOptions {
  std::size_t evaluations = 2000;  ///< distance computations per pair, at most; 1 or more
  /// In (0, 1): after the proof, the bound is raised until it reaches this share of the smallest
  /// distance found, or the evaluations run out.
  double tightness = 0.8;
};

/// What is known about a pair. Distances [m] are between hulls that enclose the links' geometry: a
/// proof holds for the geometry, too; a witness may not.
struct Reach {
  enum class Outcome {
    kProved,   ///< never within the clearance, for any joint values within the limits
    kTouched,  ///< `witness` brings the pair within the clearance
    kUnknown   ///< the evaluations ran out
  };
  Outcome outcome = Outcome::kUnknown;
  /// proved lower bound on the distance: above the clearance for kProved; infinite if either has no
  /// geometry
  double bound = 0;
  /// smallest distance found, at `witness`; infinite if either has no geometry
  double found = 0;
  Configuration witness;  ///< variables that do not move the pair are at rest
  std::size_t evaluations = 0;
};

/// Bounds the distance between pairs of links, and between links and bodies of a scene. Joints move
/// within their limits, mimic joints follow their masters, continuous joints turn all the way
/// round.
///
/// If a pair is a distance d apart at the middle of a box of joint values, it is at least d - m
/// apart everywhere in the box, where m bounds how far points of the pair move towards each other:
/// for a revolute joint at most the chord of its angle at their distance from the axis, for a
/// prismatic joint its travel; joints add up. If both bodies are convex, only movement along the
/// normal of a separating plane counts: near the smallest distance that movement grows only with
/// the square of the angle. Boxes are halved along the variable that moves the pair most.
///
/// The last links of a chain are first replaced by swept bodies, the hull of everywhere their last
/// joints can take them, which leaves fewer joints to halve. Only where a swept body is too near
/// does the next joint become part of the box. A separating plane proves each distance, whatever
/// rounding does to the search for the plane.
///
/// Immutable after construction. Deterministic.
class ReachProver {
 public:
  /// `links`: per link a hull that encloses all of it, in the link's frame; without vertices if the
  /// link has no geometry. Throws kIndexOutOfRange unless there is one for each link.
  ReachProver(const Kinematics& kinematics, const std::vector<ConvexHull>& links,
              const Scene& scene);
  ~ReachProver();
  ReachProver(ReachProver&&) noexcept;

  /// Two links (indices); `clearance` [m] >= 0. For links that never move relative to each other, a
  /// single distance decides. Throws kBadOption for a clearance or an option out of range,
  /// kIndexOutOfRange for a link that is not there, kCancelled.
  Reach betweenLinks(std::size_t link, std::size_t other, double clearance,
                     const ReachOptions& options = {}, const RunControl& control = {}) const;

  /// A link and a body of the scene (indices). Throws as betweenLinks().
  Reach betweenLinkAndBody(std::size_t link, std::size_t body, double clearance,
                           const ReachOptions& options = {}, const RunControl& control = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace collision_hulls
