// What is known about a fitted model from its verification samples.
#pragma once

#include <map>
#include <utility>

#include "fit/fitting.h"
#include "fit/near_problem.h"

namespace collision_hulls {

/// Everything that a report is made from.
struct FittedModel {
  const NearProblem& near;
  const FitOptions& options;
  const Assembly& assembly;
  const Originals& originals;
  const PairRules& rules;
  const Fitting& fitting;

  std::size_t samples() const { return near.problem.configurations.empty() ? options.samples : near.problem.configurations.size(); }
};

/// Hits of all pairs that are checked or proved, over the verification samples.
struct Hits {
  std::map<PartIndices, PairHits> pairs;
  std::size_t scene = 0;       ///< samples in which the original collides with the scene
  std::string first_in_scene;  ///< FitReport::first_scene_hit
};
Hits countHits(const FittedModel& model, const RunControl& control);

FitReport fitReport(const FittedModel& model, const Hits& hits, const RunControl& control);

/// The pairs that an SRDF should disable, and how that is known. For a pair that is not in contact, neither given configurations nor a
/// few samples are enough.
std::vector<DisabledPair> disabledPairs(const FittedModel& model, const Hits& hits);

/// Upper bound on the expected count when `found` were seen, wrong with this probability: at 5 %, 3 for none.
double upperBound(std::size_t found, double risk);

/// Upper bound on the rate of what was found in the samples of a batch, the `batch`-th (from 1) of those that were tried until one was
/// clear. Some batch's bound is wrong with a probability of 5 % at most, however many there are.
double rateBound(std::size_t found, std::size_t samples, std::size_t batch);

}  // namespace collision_hulls
