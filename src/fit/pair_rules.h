// Which pairs of parts are checked, which are not, and why.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "fit/originals.h"

namespace collision_hulls {

/// A proved pair: its parts never come nearer to each other than `bound` [m], whatever the joints do.
struct ProvedPair {
  std::size_t a = 0, b = 0;
  double bound = 0;
};

struct PairRules {
  std::vector<PartPair> pairs;  ///< to check
  std::vector<LeftOutPair> left_out;
  std::vector<std::pair<std::size_t, std::size_t>> ignored;  ///< the pairs left out, as parts
  std::vector<ProvedPair> proved;                            ///< never within the clearance, not even their roots' hulls
  std::vector<std::string> notes;
};

/// "block inside base", where a body of the scene that does not touch a link, or a component of it, lies in the link's mesh; empty: none
/// does. What lies in a body that is convex touches it, as that is checked as a solid.
std::string nesting(const Assembly& assembly, const Originals& originals, std::size_t link, std::size_t body, const Places& places);

/// [1/s] How often the pair is not clear, over how long it takes to tell. Of several pairs that all have to be clear, the most urgent is
/// checked first.
double urgency(const PartPair& pair);

/// The pairs to check and the pairs proved: primitives may touch where hulls never do.
std::vector<PartPair> lookedAtAndProved(const PairRules& rules, double clearance);

/// The rules of a planner that uses the written SRDF: it also ignores pairs of links proved apart, unless joints are held.
PairRules withSrdf(PairRules rules, const FitProblem& problem, const Assembly& assembly);

/// Decides about all pairs, from a survey of the first samples and of the robot at rest.
PairRules pairRules(const FitProblem& problem, const Assembly& assembly, const Originals& originals, double clearance,
                    const RunControl& control);

}  // namespace collision_hulls
