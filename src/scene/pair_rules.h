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
  std::vector<ProvedPair> proved;                            ///< never within the clearance, nor their roots' hulls
  std::vector<std::string> notes;
};

/// A survey of the first samples and of the robot at rest.
PairRules pairRules(const FitProblem& problem, const Assembly& assembly, const Originals& originals, double clearance,
                    const RunControl& control);

}  // namespace collision_hulls
