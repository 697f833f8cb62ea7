// The paper's decimation (Mamou & Ghorbel 2009), between any groups, with the true protrusion in place of ray concavity:
//
//   queue every pair of near groups under its cost
//   while the queue holds a pair: take the cheapest
//     if one of its groups has merged meanwhile: drop it
//     if their common hull protrudes too far: they are apart
//     else merge them: pair the union with the others; it is apart from whatever either part is apart from
//   then the same with pairs of distant groups, unless there are very many groups: solid may lie between them
//
// What is apart stays apart: the hull of a larger union contains the hull that protrudes too far. So each pair is refused at most once, and
// its refusal is inherited. The cost is made of mean widths, which cost nothing; protrusion as the cost takes a hull and a proof for every
// pair in the queue and was far slower, and volume alone gave more hulls.
//
// Merges may also be accepted on trust (Proof::kLater) and settled afterwards: unions that are refuted fall back into their parts, and
// merging goes on with the proven ones. Few groups are merged on trust by each kind of cost, and the best outcome is settled. With many
// groups too much of it would be refuted, so each merge is proven before it is made, by one kind of cost. The unions of some pairs that
// come next are proven beside it, in parallel; they are of other groups, so nearly all of these proofs are needed.
//
// For K groups: O(K^2) pairs, O(K^2 log K) time for the queue, and as many hulls as pairs come out on top.
#include "decompose/certified/merging.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/at.h"
#include "base/random.h"
#include "decompose/certified/in_time.h"
#include "decompose/pair_queue.h"

namespace collision_hulls {

namespace {

constexpr std::size_t kManyGroups = 1000;  // groups; with more, distant pairs are not tried, as time grows with their number squared
constexpr std::size_t kSeveral = 40;       // groups; beyond this, the result of provisional merging says little about what can be proven
constexpr std::size_t kProvenAtOnce = 4, kLookedAt = 8;  // unions, and pairs that are looked at for them
constexpr double kTieBreak = 1e-3;                       // as a share of the union's square, for squares that cancel out

double costOf(const Group& a, const Group& b, const MergeCost& cost) {
  const double u = a.widths.merged(b.widths).mean(), wa = a.widths.mean(), wb = b.widths.mean();
  double value = u;
  if (cost.kind == MergeCost::kGrowth) value = u - std::max(wa, wb);
  if (cost.kind == MergeCost::kMeanGrowth) value = u - (wa + wb) / 2;
  if (cost.kind == MergeCost::kSquares) value = u * u - wa * wa - wb * wb + kTieBreak * u * u;
  if (cost.noise > 0) value += u * cost.noise * (unitInterval(mixed(a.key ^ b.key ^ cost.seed)) - 0.5);
  return value;
}

/// [b][a] for a < b: whether a and b are known to be apart, i.e. cannot share a hull.
using ApartPairs = std::vector<std::vector<bool>>;

class Merging {
 public:
  /// `apart`: what is already known about the groups in the cover.
  Merging(Cover cover, SurfaceGroups& groups, const MergeCost& cost, ApartPairs apart = {})
      : groups_(groups), cost_(cost), given_(cover.size()), all_(std::move(cover)), parts_(given_, {-1, -1}), apart_(std::move(apart)) {
    for (int i = 0; i < static_cast<int>(given_); ++i) live_.push_back(i);
  }

  void run(Proof proof) {
    all_pairs_ = false;
    const std::vector<int> given = std::move(live_);
    live_.clear();
    for (const int b : given) {
      if (groups_.control().cancelled()) groups_.control().check();
      if (groups_.control().late())
        live_.push_back(b);  // in no pair, but in the cover
      else
        pairWithEarlier(b, -1, -1);
    }
    groups_.control().check();
    mergeQueued(proof);
    if (live_.size() > kManyGroups) return;
    all_pairs_ = true;
    for (const int b : live_)
      for (const int a : live_)
        if (a < b && !apart(a, b) && isFar(a, b)) queue(a, b);
    mergeQueued(proof);
  }

  /// Proves the merged groups; refuted ones fall back into their parts, if need be down to the given ones. Returns whether nothing was
  /// refuted; if something was, there may be more to merge.
  bool settle() {
    for (bool all = true;; all = false) {
      std::vector<const Group*> open;
      for (const int i : live_)
        if (isMerged(i)) open.push_back(&group(i));
      groups_.prove(open);
      const auto holds = [&](int i) { return !isMerged(i) || groups_.proven(group(i)); };
      const auto refuted = std::stable_partition(live_.begin(), live_.end(), holds);
      if (refuted == live_.end()) return all;
      const std::vector<int> fallen(refuted, live_.end());
      live_.erase(refuted, live_.end());
      for (const int i : fallen) {
        const auto [a, b] = parts_[at(i)];
        setApart(a, b);
        live_.insert(live_.end(), {a, b});
      }
      std::sort(live_.begin(), live_.end());
    }
  }

  std::size_t count() const { return live_.size(); }

  Cover cover() const {
    Cover result;
    for (const int i : live_) result.push_back(all_[at(i)]);
    return result;
  }

  /// What is now known about the given groups.
  ApartPairs known() const { return {apart_.begin(), apart_.begin() + static_cast<std::ptrdiff_t>(given_)}; }

 private:
  Group& group(int i) { return all_[at(i)]; }
  bool apart(int a, int b) const { return apart_[at(std::max(a, b))][at(std::min(a, b))]; }
  void setApart(int a, int b) { apart_[at(std::max(a, b))][at(std::min(a, b))] = true; }
  bool isMerged(int i) const { return at(i) >= given_; }
  bool isLive(int i) const { return std::binary_search(live_.begin(), live_.end(), i); }

  bool isFar(int a, int b) { return farApart(group(a), group(b), groups_.tolerance()); }
  void queue(int a, int b) { queue_.push({costOf(group(a), group(b), cost_), a, b}); }

  void mergeQueued(Proof proof) {
    while (const auto pair = queue_.takeCheapest([&](int i) { return isLive(i); })) {
      groups_.control().check();
      tryMerge(pair->a, pair->b, proof);
    }
  }

  /// Pairs group b with the earlier ones. If b is a union, `left` and `right` are its parts.
  void pairWithEarlier(int b, int left, int right) {
    if (apart_.size() == at(b)) apart_.emplace_back(at(b), false);
    for (const int a : live_) {
      if (left >= 0 && (apart(a, left) || apart(a, right))) setApart(a, b);
      if (!apart(a, b) && (all_pairs_ || !isFar(a, b))) queue(a, b);
    }
    live_.push_back(b);
  }

  void tryMerge(int a, int b, Proof proof) {
    Group both = groups_.merged(group(a), group(b));
    if (both.hull && proof == Proof::kAtOnce && !groups_.isProven(both)) proveWithNext(both, a, b);
    if (!both.hull || (proof == Proof::kAtOnce && !groups_.proven(both))) return setApart(a, b);
    live_.erase(std::remove_if(live_.begin(), live_.end(), [&](int i) { return i == a || i == b; }), live_.end());
    all_.push_back(std::move(both));
    parts_.push_back({a, b});
    pairWithEarlier(static_cast<int>(all_.size()) - 1, a, b);
  }

  /// Proves the union of a and b, in parallel with the unions that probably follow: of the cheapest pairs of other groups.
  void proveWithNext(const Group& both, int a, int b) {
    std::vector<int> taken{a, b};
    std::vector<Group> unions{both};
    std::vector<MergePair> looked_at;
    const auto is_taken = [&](int i) { return std::find(taken.begin(), taken.end(), i) != taken.end(); };
    while (unions.size() < kProvenAtOnce && looked_at.size() < kLookedAt) {
      const auto pair = queue_.takeCheapest([&](int i) { return isLive(i); });
      if (!pair) break;
      if (!is_taken(pair->a) && !is_taken(pair->b)) {
        Group next = groups_.merged(group(pair->a), group(pair->b));
        if (!next.hull) {
          setApart(pair->a, pair->b);
          continue;
        }
        taken.insert(taken.end(), {pair->a, pair->b});
        unions.push_back(std::move(next));
      }
      looked_at.push_back(*pair);
    }
    for (const MergePair& pair : looked_at) queue_.push(pair);
    std::vector<const Group*> open;
    for (const Group& group : unions) open.push_back(&group);
    groups_.prove(open);
  }

  SurfaceGroups& groups_;
  const MergeCost cost_;
  const std::size_t given_;
  Cover all_;                               // all groups ever, given and merged
  std::vector<std::pair<int, int>> parts_;  // the two parts of each merged group; -1: the group was given
  ApartPairs apart_;
  std::vector<int> live_;  // the groups of the current cover, in ascending order
  bool all_pairs_ = false;
  PairQueue queue_;
};

}  // namespace

Cover merged(Cover cover, SurfaceGroups& groups, const MergeCost& cost, Proof proof) {
  Merging merging(std::move(cover), groups, cost);
  merging.run(proof);
  return merging.cover();
}

namespace {

/// Each merge is proven, so those that were made in time count.
Cover mergedInTime(const Cover& cover, SurfaceGroups& groups) {
  Merging merging(cover, groups, {MergeCost::kSquares, 0, 0});
  inTime([&] { merging.run(Proof::kAtOnce); });
  return merging.cover();
}

/// By the kind of cost that provisionally leaves fewest.
Cover mergedByBestKind(const Cover& cover, SurfaceGroups& groups) {
  ApartPairs apart;
  std::optional<Merging> best;
  for (const auto kind : {MergeCost::kSize, MergeCost::kGrowth, MergeCost::kMeanGrowth, MergeCost::kSquares}) {
    Merging merging(cover, groups, {kind, 0, 0}, apart);
    merging.run(Proof::kLater);
    apart = merging.known();
    if (!best || merging.count() < best->count()) best.emplace(std::move(merging));
  }
  while (!best->settle()) best->run(Proof::kLater);
  return best->cover();
}

}  // namespace

Cover mergedBest(const Cover& cover, SurfaceGroups& groups) {
  if (cover.size() > kSeveral) return mergedInTime(cover, groups);
  Cover result = cover;
  if (inTime([&] { result = mergedByBestKind(cover, groups); })) return result;
  return cover;
}

}  // namespace collision_hulls
