// The paper's decimation, between any groups, with the true protrusion in place of ray concavity:
//
//   queue every pair of near groups under its cost
//   while the queue holds a pair: take the cheapest
//     if a group of it was merged meanwhile: drop it
//     if the hull of both protrudes too far: they are apart
//     else merge: the union is paired with the others, and is apart from what either part is apart from
//   then the same with the pairs of distant groups, unless there are very many: solid may lie between them
//
// A hull that protrudes too far does so as well when it grows: what is apart stays apart.
#include "decompose/merging.h"

#include <algorithm>
#include <array>
#include <queue>
#include <tuple>

#include "decompose/dice.h"

namespace collision_hulls {

namespace {

constexpr std::size_t kMany = 1000;         // groups: merging takes time by their number squared
constexpr double kTieBreak = 1e-3;          // of the union's size, for squares that cancel out
constexpr int kTrials = 8, kFewTrials = 2;  // of proving what was merged on trust; the latter where there are many groups

struct Pair {
  double cost;
  int a, b;

  bool operator<(const Pair& o) const { return std::tie(cost, a, b) > std::tie(o.cost, o.a, o.b); }  // cheapest on top
};

double costOf(const Group& a, const Group& b, const MergeCost& cost) {
  const double u = a.widths.merged(b.widths).mean(), wa = a.widths.mean(), wb = b.widths.mean();
  double value = u;
  if (cost.kind == MergeCost::kGrowth) value = u - std::max(wa, wb);
  if (cost.kind == MergeCost::kMeanGrowth) value = u - (wa + wb) / 2;
  if (cost.kind == MergeCost::kSquares) value = u * u - wa * wa - wb * wb + kTieBreak * u * u;
  if (cost.noise > 0) value += u * cost.noise * (unitInterval(mixed(a.key ^ b.key ^ cost.seed)) - 0.5);
  return value;
}

/// [b][a] for a < b: whether no hull is common to both.
using ApartPairs = std::vector<std::vector<char>>;

class Merging {
 public:
  /// `apart`: what is known of the groups in the cover; takes what is learned of them.
  Merging(Cover cover, SurfaceGroups& groups, const MergeCost& cost, Proof proof, ApartPairs& apart)
      : cover_(std::move(cover)), groups_(groups), cost_(cost), proof_(proof), given_(cover_.size()), apart_(apart) {}

  Cover run() {
    for (int b = 0; b < size(); ++b) pairWithEarlier(b, -1, -1);
    mergeQueued();
    if (live_.size() <= kMany) {
      all_pairs_ = true;
      for (const int b : live_)
        for (const int a : live_)
          if (a < b && !apart(a, b) && isFar(a, b)) queue(a, b);
      mergeQueued();
    }
    apart_.resize(given_);
    cover_.erase(std::remove_if(cover_.begin(), cover_.end(), [](const Group& g) { return !g.hull; }), cover_.end());
    return std::move(cover_);
  }

 private:
  int size() const { return static_cast<int>(cover_.size()); }
  Group& group(int i) { return cover_[static_cast<std::size_t>(i)]; }
  bool apart(int a, int b) const { return apart_[static_cast<std::size_t>(std::max(a, b))][static_cast<std::size_t>(std::min(a, b))] != 0; }

  bool isFar(int a, int b) { return farApart(group(a), group(b), groups_.tolerance()); }
  void queue(int a, int b) { queue_.push({costOf(group(a), group(b), cost_), a, b}); }

  void mergeQueued() {
    while (!queue_.empty()) {
      const Pair pair = queue_.top();
      queue_.pop();
      if (group(pair.a).hull && group(pair.b).hull) tryMerge(pair.a, pair.b);
    }
  }

  /// Pairs group b, the union of `left` and `right` if there are such, with those before it. Merged groups have no hull any more.
  void pairWithEarlier(int b, int left, int right) {
    groups_.control().check();
    if (apart_.size() == static_cast<std::size_t>(b)) apart_.emplace_back(static_cast<std::size_t>(b), 0);
    for (const int a : live_) {
      char& is_apart = apart_[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)];
      if (left >= 0) is_apart = apart(a, left) || apart(a, right);
      if (!is_apart && (all_pairs_ || !isFar(a, b))) queue(a, b);
    }
    live_.push_back(b);
  }

  void tryMerge(int a, int b) {
    Group both = groups_.merged(group(a), group(b));
    if (!both.hull || (proof_ == Proof::kAtOnce && !groups_.proven(both))) {
      apart_[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)] = 1;  // a < b
      return;
    }
    group(a).hull = group(b).hull = nullptr;
    live_.erase(std::remove_if(live_.begin(), live_.end(), [&](int i) { return i == a || i == b; }), live_.end());
    cover_.push_back(std::move(both));
    pairWithEarlier(size() - 1, a, b);
  }

  Cover cover_;
  SurfaceGroups& groups_;
  const MergeCost cost_;
  const Proof proof_;
  const std::size_t given_;
  ApartPairs& apart_;
  std::vector<int> live_;  // groups that were not merged, ascending
  bool all_pairs_ = false;
  std::priority_queue<Pair> queue_;
};

}  // namespace

Cover merged(Cover cover, SurfaceGroups& groups, const MergeCost& cost, Proof proof) {
  ApartPairs apart;
  return Merging(std::move(cover), groups, cost, proof, apart).run();
}

/// What was refuted is remembered, so that merging anew takes another way.
Cover mergedBest(const Cover& cover, SurfaceGroups& groups) {
  constexpr std::array<MergeCost::Kind, 4> kinds{MergeCost::kSize, MergeCost::kGrowth, MergeCost::kMeanGrowth, MergeCost::kSquares};
  const bool many = cover.size() > kMany;
  std::vector<std::size_t> sizes(many ? 1 : kinds.size());
  ApartPairs apart;
  const auto mergedBy = [&](MergeCost::Kind kind, Proof proof) { return Merging(cover, groups, {kind, 0, 0}, proof, apart).run(); };
  for (std::size_t k = 0; k < sizes.size(); ++k) sizes[k] = mergedBy(kinds[k], Proof::kLater).size();
  std::size_t best = 0;
  for (int trial = 0; trial < (many ? kFewTrials : kTrials); ++trial) {
    best = static_cast<std::size_t>(std::min_element(sizes.begin(), sizes.end()) - sizes.begin());
    Cover result = mergedBy(kinds[best], Proof::kLater);
    if (result.size() > sizes[best])
      sizes[best] = result.size();  // refuted meanwhile: another kind may do better now
    else if (groups.proven(result))
      return result;
  }
  return mergedBy(kinds[best], Proof::kAtOnce);
}

}  // namespace collision_hulls
