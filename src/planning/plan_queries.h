// What is planned: starts and goals, drawn once for all models.
#pragma once

#include <cstdint>
#include <vector>

#include "planning/joint_space.h"
#include "planning/planner.h"

namespace collision_hulls {

struct PlanQuery {
  JointValues start, goal;
};

/// Independent random states within the joints' limits that are free, in pairs; the straight motion from one to the other, looked at with
/// this `step`, is not, since there would be nothing to plan. The same seed gives the same queries, and more of them begin with the same
/// ones. Throws kBadOption where 100,000 draws in a row are not free, or no pair of 10,000.
std::vector<PlanQuery> drawQueries(const Kinematics& kinematics, const JointSpace& space, const IsFree& is_free, double step,
                                   std::size_t count, std::uint64_t seed);

/// How many of the states are not free.
std::size_t hits(const std::vector<JointValues>& states, const IsFree& is_free);

}  // namespace collision_hulls
