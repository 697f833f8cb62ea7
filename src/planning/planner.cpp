// The only file that sees OMPL. Each joint is a space of its own: SO2 for a continuous one, else an interval; their distances add up. OMPL
// then counts steps joint by joint, each in shares of that joint's range.
#include "planning/planner.h"

#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "base/stopwatch.h"

namespace collision_hulls {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

using Joints = std::vector<JointVariable>;

ob::StateSpacePtr spaceOf(const JointVariable& joint) {
  if (joint.continuous) return std::make_shared<ob::SO2StateSpace>();
  const auto interval = std::make_shared<ob::RealVectorStateSpace>(1);
  interval->setBounds(joint.lower, joint.upper);
  return interval;
}

ob::StateSpacePtr spaceOf(const Joints& joints, double step) {
  const auto all = std::make_shared<ob::CompoundStateSpace>();
  for (const JointVariable& joint : joints) all->addSubspace(spaceOf(joint), 1);
  all->setLongestValidSegmentFraction(step);
  return all;
}

double& value(const JointVariable& joint, ob::State& part) {
  return joint.continuous ? part.as<ob::SO2StateSpace::StateType>()->value : part.as<ob::RealVectorStateSpace::StateType>()->values[0];
}

JointValues valuesOf(const Joints& joints, const ob::State& state) {
  const auto& parts = *state.as<ob::CompoundState>();
  JointValues values(joints.size());
  for (std::size_t i = 0; i < joints.size(); ++i) values[i] = value(joints[i], *parts.components[i]);
  return values;
}

ob::ScopedState<> stateOf(const Joints& joints, const JointValues& values, const ob::StateSpacePtr& space) {
  ob::ScopedState<> state(space);
  auto& parts = *state->as<ob::CompoundState>();
  for (std::size_t i = 0; i < joints.size(); ++i) value(joints[i], *parts.components[i]) = values[i];
  space->enforceBounds(state.get());  // limits may have been rounded; an angle belongs into (-pi, pi)
  return state;
}

/// Seeds the generators that the next problem will make.
void seedAll(std::uint32_t seed) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);  // it warns that earlier generators keep their seeds
  ompl::RNG::setSeed(seed);
}

}  // namespace

const char* name(Plan::Outcome outcome) {
  switch (outcome) {
    case Plan::Outcome::kSolved: return "solved";
    case Plan::Outcome::kTimeout: return "timeout";
    case Plan::Outcome::kLost: return "lost";
  }
  return "";
}

Plan plan(const Joints& joints, const JointValues& start, const JointValues& goal, const IsFree& is_free, const PlannerSettings& settings) {
  Plan result;
  Stopwatch clock;
  if (!is_free(start) || !is_free(goal)) {  // OMPL would wait for another goal until its time is up
    result.outcome = Plan::Outcome::kLost;
    return result;
  }
  result.seconds = clock.lap();
  seedAll(settings.seed);
  const ob::StateSpacePtr space = spaceOf(joints, settings.step);
  og::SimpleSetup problem(space);
  problem.setStateValidityChecker([&](const ob::State* state) { return is_free(valuesOf(joints, *state)); });
  problem.setStartAndGoalStates(stateOf(joints, start, space), stateOf(joints, goal, space));
  problem.setPlanner(std::make_shared<og::RRTConnect>(problem.getSpaceInformation()));
  problem.setup();
  clock.lap();
  // As MoveIt does: given seconds alone, OMPL starts a thread that watches the time, and waits a millisecond for its end.
  const ob::PlannerStatus status = problem.solve(ob::timedPlannerTerminationCondition(settings.time_limit));
  result.seconds += clock.lap();
  if (status != ob::PlannerStatus::EXACT_SOLUTION) return result;
  result.outcome = Plan::Outcome::kSolved;
  for (const ob::State* state : problem.getSolutionPath().getStates()) result.path.push_back(valuesOf(joints, *state));
  return result;
}

}  // namespace collision_hulls
