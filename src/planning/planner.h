// A sampling planner, as planners use collision models: OMPL's RRT-Connect (Kuffner and LaValle, ICRA 2000).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "planning/joint_space.h"

namespace collision_hulls {

struct PlannerSettings {
  double time_limit = 5;  ///< [s] > 0
  /// Motions are checked where no joint has moved further than this share of its range; in (0, 1). MoveIt's Setup Assistant writes 0.005.
  double step = 0.005;
  std::uint32_t seed = 1;  ///< > 0
};

struct Plan {
  enum class Outcome {
    kSolved,
    kTimeout,
    kLost  ///< the start or the goal is not free
  };
  Outcome outcome = Outcome::kTimeout;
  double seconds = 0;             ///< of the search, with the checks of start and goal
  std::vector<JointValues> path;  ///< from start to goal, as found: neither shortened nor smoothed; empty unless solved
};
const char* name(Plan::Outcome outcome);  ///< "solved", "timeout", "lost"

using IsFree = std::function<bool(const JointValues&)>;

/// Plans from `start` to `goal`. The same seed gives the same path, unless time runs out. OMPL's random numbers are global: one thread at a
/// time may plan.
Plan plan(const std::vector<JointVariable>& joints, const JointValues& start, const JointValues& goal, const IsFree& is_free,
          const PlannerSettings& settings);

}  // namespace collision_hulls
