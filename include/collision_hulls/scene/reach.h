// Which pairs of bodies can never come near each other, whatever the joints do: proof by branch and bound.
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
  std::size_t evaluations = 2000;  ///< most distances that are computed for a pair
  /// In (0, 1): once proved, the bound is raised until it is this share of the smallest distance found, or evaluations run out.
  double tightness = 0.8;
};

/// What is known of a pair. Distances [m] between the hulls, which hold what they stand for: a proof holds for that too, a witness may not.
struct Reach {
  enum class Outcome {
    kProved,   ///< never within the clearance, for any values of the joints within their limits
    kTouched,  ///< `witness` brings them within it
    kUnknown   ///< the evaluations were used up
  };
  Outcome outcome = Outcome::kUnknown;
  double bound = 0;       ///< never nearer than that, proved: above the clearance for kProved; infinite where one has no geometry
  double found = 0;       ///< smallest distance found, at `witness`; infinite where one has no geometry
  Configuration witness;  ///< variables that do not move the pair are at rest
  std::size_t evaluations = 0;
};

/// Looks at pairs of a robot's links, and of links and a scene's bodies. Joints move within their limits, mimic joints as their masters
/// do, continuous joints all the way round.
///
/// A box of joint values whose middle keeps the pair a distance d apart keeps it d - m apart, where m is how far points of the pair move
/// towards each other within the box: for a revolute joint at most the chord of its angle at their distance from its axis, for a
/// prismatic one its way; joints add up. Towards each other is along the normal of a plane that parts the pair, where both are convex:
/// where the distance is least it changes with the square of the angle only. Boxes are halved along the variable that moves most.
/// Links at the end of a chain are first replaced by the hull of all places that their last joints take them to, which leaves fewer
/// joints to halve: a box is handed on to the next joint only where that hull is too near. Distances are proved by the separating plane,
/// whatever rounding does to the search for it.
///
/// Immutable after construction, thread safe. Deterministic.
class ReachProver {
 public:
  /// `links`: for each link a hull that holds all of it, in the link's frame; without vertices: a link without geometry.
  ReachProver(const Kinematics& kinematics, const std::vector<ConvexHull>& links, const Scene& scene);
  ~ReachProver();
  ReachProver(ReachProver&&) noexcept;

  /// Two links (indices), `clearance` [m] >= 0. Links that never move against each other are proved or touched by one distance.
  Reach betweenLinks(std::size_t link, std::size_t other, double clearance, const ReachOptions& options = {},
                     const RunControl& control = {}) const;

  /// A link and a body of the scene (indices).
  Reach betweenLinkAndBody(std::size_t link, std::size_t body, double clearance, const ReachOptions& options = {},
                           const RunControl& control = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace collision_hulls
