// No one score for planes wins on all meshes, and leaves that use all of the tolerance leave merging no room. So several ways are tried,
// those that gain less only where hulls are few and each of them counts.
#include "decompose/certified/plan.h"

namespace collision_hulls {

namespace {

// Share of the tolerance used for splitting leaves: a small one leaves merging some room, a large one makes leaves as large as possible.
constexpr double kLeafShare = 0.7, kLargeLeafShare = 0.93;
// Kinds of score: in favour of one large finished side, of any finished side, and with little weight on volume.
constexpr ScoreWeights kLargeSides{0.5, 0.3, 0}, kAnySide{0.5, 0, 0.1}, kLittleVolume{0.1, 0, 0};
constexpr std::size_t kFew = 24, kVeryFew = 10;  // hulls, beyond which quick leaves out the second and the third way
// The most leaves of a part that is split on its own, for Effort::kInstant and for others; and how many times as many a mesh may have.
constexpr std::size_t kMostForInstant = 1000, kMostLeaves = 5000, kMostInAll = 2;
// Evaluations of the search, and for Effort::kBest the elements that leaves are halved into and the evaluations after each way of
// splitting.
constexpr long kQuickEvaluations = 400, kBestEvaluations = 10'000, kFirstEvaluations = 200;
constexpr std::size_t kBestElements = 150;

/// Without ways.
SearchPlan planOf(std::size_t elements, long first_evaluations, long evaluations, std::size_t most_leaves = kMostLeaves) {
  return {{}, elements, first_evaluations, evaluations, most_leaves, kMostInAll * most_leaves};
}

}  // namespace

SearchPlan planFor(Effort effort) {
  if (effort == Effort::kInstant) {
    SearchPlan plan = planOf(0, 0, 0, kMostForInstant);
    plan.ways = {{kLargeSides, kLeafShare}};
    return plan;
  }
  if (effort == Effort::kQuick) {
    SearchPlan plan = planOf(0, 0, kQuickEvaluations);
    plan.ways = {{kLargeSides, kLeafShare}, {kAnySide, kLeafShare, kFew}, {kLargeSides, kLargeLeafShare, kVeryFew, true}};
    return plan;
  }
  SearchPlan plan = planOf(kBestElements, kFirstEvaluations, kBestEvaluations);
  for (const double share : {kLeafShare, kLargeLeafShare})
    for (const ScoreWeights& weights : {kLargeSides, kAnySide, kLittleVolume}) plan.ways.push_back({weights, share});
  plan.ways.push_back({kLargeSides, kLargeLeafShare, Way::kAnyNumber, true});
  return plan;
}

}  // namespace collision_hulls
