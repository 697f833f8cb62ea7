// Draws states from the sequence of independent samples that fit_scene verifies its models with, and drops those that are not free.
#include "planning/plan_queries.h"

#include <algorithm>

#include "collision_hulls/error.h"
#include "collision_hulls/scene/configurations.h"

namespace collision_hulls {
namespace {

constexpr std::uint64_t kMostDraws = 100'000;  // in a row
constexpr std::size_t kMostPairs = 10'000;     // likewise

/// Draws one query after the other.
class Draws {
 public:
  Draws(const Kinematics& kinematics, const JointSpace& space, const IsFree& is_free, double step, std::uint64_t seed)
      : samples_(kinematics, seed, Sampling::kIndependent), space_(space), is_free_(is_free), step_(step) {}

  PlanQuery query() {
    for (std::size_t i = 0; i < kMostPairs; ++i) {
      const PlanQuery query{state(), state()};
      const std::vector<JointValues> straight = alongPath(space_.joints(), {query.start, query.goal}, step_);
      if (!std::all_of(straight.begin(), straight.end(), is_free_)) return query;
    }
    throw Error(ErrorCode::kBadOption,
                "the straight motions between " + std::to_string(kMostPairs) +
                    " pairs of states are all free, so there is nothing to plan; plan more joints (--joints), or give "
                    "another scene");
  }

 private:
  JointValues state() {
    for (const std::uint64_t end = index_ + kMostDraws; index_ < end;) {
      JointValues values = space_.values(samples_(index_++));
      if (is_free_(values)) return values;
    }
    throw Error(ErrorCode::kBadOption, "no free state in " + std::to_string(kMostDraws) +
                                           " draws, with the original meshes; give a scene in the frame of the robot's root link, and move "
                                           "joints that are not planned out of its way (--at)");
  }

  const ConfigurationSequence samples_;
  const JointSpace& space_;
  const IsFree& is_free_;
  const double step_;
  std::uint64_t index_ = 0;
};

}  // namespace

std::vector<PlanQuery> drawQueries(const Kinematics& kinematics, const JointSpace& space, const IsFree& is_free, double step,
                                   std::size_t count, std::uint64_t seed) {
  Draws draws(kinematics, space, is_free, step, seed);
  std::vector<PlanQuery> queries(count);
  for (PlanQuery& query : queries) query = draws.query();
  return queries;
}

std::size_t hits(const std::vector<JointValues>& states, const IsFree& is_free) {
  return static_cast<std::size_t>(std::count_if(states.begin(), states.end(), [&](const JointValues& state) { return !is_free(state); }));
}

}  // namespace collision_hulls
