// Collision queries over sampled configurations: the original and the result are asked the same.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_hulls/robot/kinematics.h"
#include "verify/compare_link.h"

namespace collision_hulls {

/// A link of the trials. `bounds`: its row, measured.
struct TrialLink {
  std::size_t link = 0;  ///< index in the original's description
  const LinkPair* pair = nullptr;
  const LinkVerification* bounds = nullptr;
};

struct TrialCounts {
  std::size_t queries = 0, hits = 0, missed = 0, phantom = 0;
};

/// Two links, by their indices as they were given, first < second.
struct TrialPair {
  std::size_t first = 0, second = 0;
  TrialCounts counts;
};

struct Trials {
  TrialCounts all;
  std::vector<TrialCounts> of_link;  ///< as the links were given
  std::vector<TrialPair> pairs;      ///< with a missed or a phantom query, in the links' order; none of more than 2,000 links
  std::size_t contradictions = 0;
  std::vector<std::string> remarks;  ///< on contradictions; a few
};

/// In each configuration, pairs of links that are not adjacent, and a box near one of the links with every link. A body inside another
/// counts as a collision, for FCL a mesh is a surface alone. Deterministic.
Trials tryConfigurations(const Kinematics& kinematics, const std::vector<TrialLink>& links, std::size_t configurations, std::uint64_t seed,
                         const RunControl& control = {});

}  // namespace collision_hulls
