// Adds up a chain's lengths as if it could be stretched: from the origin of its first joint to that of the next, and so on to the link.
#include "reach/reach_ball.h"

#include <algorithm>
#include <cmath>

#include "reach/sweep.h"

namespace collision_hulls {

ReachBall reachBall(const Chain& chain, const std::vector<JointVariable>& variables, double radius) {
  if (chain.joints.empty()) return {chain.end.translation(), radius};
  ReachBall ball{chain.joints.front().origin.translation(), chain.end.translation().norm() + radius};
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    const ChainJoint& joint = chain.joints[k];
    if (k > 0) ball.radius += joint.origin.translation().norm();
    if (joint.turns) continue;
    const JointRange range = rangeOf(joint, variables);
    ball.radius += std::max(std::abs(range.lower), std::abs(range.upper));
  }
  return ball;
}

}  // namespace collision_hulls
