// The queue of greedy merging, wherever hulls are merged bottom up: the pair that costs least comes
// first, and pairs whose parts have merged with others meanwhile are skipped when they come out (a
// lazy queue: nothing is ever searched for and removed).
#pragma once

#include <optional>
#include <queue>
#include <tuple>

namespace collision_hulls {

/// Two things that may merge, by their indices.
struct MergePair {
  double cost = 0;
  int a = -1, b = -1;
  bool is_exact = true;  ///< otherwise `cost` is a lower bound: whoever takes the pair computes it and queues the pair again

  /// On a tie the lower indices come first, so that the order never depends on the queue's inner
  /// workings.
  bool operator<(const MergePair& o) const { return std::tie(cost, a, b) > std::tie(o.cost, o.a, o.b); }
};

class PairQueue {
 public:
  void push(const MergePair& pair) { queue_.push(pair); }

  /// Takes the cheapest pair of which both parts are still there; nullopt if none is left.
  template <class IsThere>
  std::optional<MergePair> takeCheapest(IsThere is_there) {
    while (!queue_.empty()) {
      const MergePair pair = queue_.top();
      queue_.pop();
      if (is_there(pair.a) && is_there(pair.b)) return pair;
    }
    return std::nullopt;
  }

 private:
  std::priority_queue<MergePair> queue_;
};

}  // namespace collision_hulls
