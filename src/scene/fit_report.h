// What is known about a fitted model, from the samples that verify it.
#pragma once

#include <map>
#include <utility>

#include "scene/fitting.h"

namespace collision_hulls {

using PartIndices = std::pair<std::size_t, std::size_t>;  // the first one less

/// All that a report is made of.
struct FittedModel {
  const FitProblem& problem;
  const FitOptions& options;
  const Assembly& assembly;
  const Originals& originals;
  const PairRules& rules;
  const Fitting& fitting;

  std::size_t samples() const { return problem.configurations.empty() ? options.samples : problem.configurations.size(); }
};

/// Hits of all pairs that are looked at or proved, over the samples that verify.
struct Hits {
  std::map<PartIndices, PairHits> pairs;
  std::size_t scene = 0;  ///< samples in which the original hits the scene
};
Hits countHits(const FittedModel& model, const RunControl& control);

FitReport fitReport(const FittedModel& model, const Hits& hits, const RunControl& control);

/// The pairs that a robot's SRDF would leave out, with how that is known. What is known of given configurations or of few samples alone is
/// not among them.
std::vector<DisabledPair> disabledPairs(const FittedModel& model, const Hits& hits);

/// The number that, with 95 % confidence, a rate times `samples` does not exceed when `found` were seen: 3 for none.
double upperBound(std::size_t found);

}  // namespace collision_hulls
