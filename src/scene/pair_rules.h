// Which pairs of parts are looked at, which are not, and why.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "scene/originals.h"

namespace collision_hulls {

/// What is proved about a pair: its parts never come nearer than `bound` [m], whatever the joints do.
struct ProvedPair {
  std::size_t a = 0, b = 0;
  double bound = 0;
};

struct PairRules {
  std::vector<PartPair> pairs;  ///< looked at
  std::vector<LeftOutPair> left_out;
  std::vector<std::pair<std::size_t, std::size_t>> ignored;  ///< the same, as parts
  std::vector<ProvedPair> proved;                            ///< never within the clearance, nor are their roots' hulls
  std::vector<std::string> notes;
};

/// The pairs that are looked at, and those that are proved: primitives may touch where hulls never do.
std::vector<PartPair> lookedAtAndProved(const PairRules& rules, double clearance);

/// As planners have them that use the SRDF that is written: pairs of links that are proved apart are ignored, too.
PairRules withSrdf(PairRules rules, const Assembly& assembly);

/// A survey of the first samples and of the robot at rest.
PairRules pairRules(const FitProblem& problem, const Assembly& assembly, const Originals& originals, double clearance,
                    const RunControl& control);

}  // namespace collision_hulls
