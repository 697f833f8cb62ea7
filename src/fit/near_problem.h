// Sets aside what is so far from a robot that no joint brings anything near it: a scene may be a whole building.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/fit/fit.h"

namespace collision_hulls {

struct NearProblem {
  FitProblem problem;          ///< without the bodies, and without the triangles of bodies, that are far from each link
  std::size_t far_bodies = 0;  ///< that are left out whole
  std::vector<double> far;     ///< [m] for each link: no nearer does it come to what is left out; infinite where nothing is
  std::size_t links = 0;       ///< that have geometry: each would be in a pair with each body
};

/// Far from a link is what lies outside of its ReachBall by more than the ball's radius and more than the clearance [m]; nothing is, where
/// the joints' ranges do not tell where the link gets (Kinematics::settled()). Throws kBadOption for a configuration of the wrong size,
/// kCancelled.
NearProblem nearProblem(const FitProblem& problem, double clearance, const RunControl& control);

}  // namespace collision_hulls
