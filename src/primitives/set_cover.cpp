// Greedy, then a local search with weights (Gao, Weise, Li 2015: RWLS). While everything is covered, note the sets and drop the one that
// would be missed least. Otherwise swap: drop another one, and take the one that gains most for some element that is not covered. Elements
// that stay uncovered gain weight, so that the search leaves places where it was stuck. A set's gain is the weight of the elements that
// only it covers, or would cover; it is kept up to date as sets come and go.
//
// Exact solvers do not scale to thousands of sets; greedy alone takes about an eighth more sets.
#include "primitives/set_cover.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace collision_hulls {

namespace {

constexpr std::size_t kStepsBetweenChecks = 256;

class Cover {
 public:
  explicit Cover(const SetSystem& system)
      : system_(system),
        holders_(system.elements),
        count_(system.elements),
        sum_(system.elements),
        weight_(system.elements, 1),
        place_(system.elements, -1),
        gain_(system.sets.size()),
        taken_(system.sets.size()),
        since_(system.sets.size()) {
    for (std::size_t s = 0; s < system.sets.size(); ++s)
      for (const int e : system.sets[s]) holders_[at(e)].push_back(static_cast<int>(s));
    for (std::size_t s = 0; s < system.sets.size(); ++s) gain_[s] = static_cast<long long>(system.sets[s].size());
    for (std::size_t e = 0; e < system.elements; ++e) open(static_cast<int>(e));
  }

  void take(int set) {
    taken_[at(set)] = 1;
    long long own = 0;
    for (const int e : elements(set)) {
      sum_[at(e)] += set;
      const int before = count_[at(e)]++;
      if (before == 0) {
        own += weight_[at(e)];
        for (const int other : holders_[at(e)]) gain_[at(other)] -= weight_[at(e)];
        work_ += holders_[at(e)].size();
        close(e);
      } else if (before == 1) {
        gain_[at(sum_[at(e)] - set)] -= weight_[at(e)];
      }
    }
    gain_[at(set)] = own;
    work_ += elements(set).size();
  }

  void drop(int set) {
    taken_[at(set)] = 0;
    long long own = 0;
    for (const int e : elements(set)) {
      sum_[at(e)] -= set;
      const int left = --count_[at(e)];
      if (left == 0) {
        for (const int other : holders_[at(e)]) gain_[at(other)] += weight_[at(e)];
        work_ += holders_[at(e)].size();
        own += weight_[at(e)];
        open(e);
      } else if (left == 1) {
        gain_[at(sum_[at(e)])] += weight_[at(e)];
      }
    }
    gain_[at(set)] = own;
    work_ += elements(set).size();
  }

  /// Takes the set with the largest gain until everything is covered. Gains only shrink meanwhile, so old ones are upper bounds.
  void complete() {
    std::priority_queue<std::pair<long long, int>> queue;
    for (std::size_t s = 0; s < gain_.size(); ++s)
      if (!taken_[s]) queue.emplace(gain_[s], -static_cast<int>(s));
    while (!open_.empty() && !queue.empty()) {
      const auto [gain, negative] = queue.top();
      queue.pop();
      if (gain_[at(-negative)] == gain)
        take(-negative);
      else
        queue.emplace(gain_[at(-negative)], negative);
    }
  }

  /// Drops sets that cover nothing alone, smallest first.
  void dropRedundant() {
    std::vector<int> sets = taken();
    std::stable_sort(sets.begin(), sets.end(), [&](int a, int b) { return elements(a).size() < elements(b).size(); });
    for (const int s : sets)
      if (gain_[at(s)] == 0) drop(s);
  }

  /// The taken set that would be missed least; of several, the one unchanged for longest.
  int leastMissed(int except) const {
    int best = -1;
    for (const int s : list_)
      if (s != except &&
          (best < 0 || gain_[at(s)] < gain_[at(best)] || (gain_[at(s)] == gain_[at(best)] && since_[at(s)] < since_[at(best)])))
        best = s;
    return best;
  }

  void step(std::size_t now) {
    const int out = leastMissed(last_);
    if (out < 0) return;
    leave(out, now);
    const int element = open_[now % open_.size()];
    int best = -1;
    for (const int s : holders_[at(element)])
      if (since_[at(s)] != now &&
          (best < 0 || gain_[at(s)] > gain_[at(best)] || (gain_[at(s)] == gain_[at(best)] && since_[at(s)] < since_[at(best)])))
        best = s;
    if (best < 0) best = out;
    enter(best, now);
    for (const int e : open_) {
      ++weight_[at(e)];
      for (const int s : holders_[at(e)]) ++gain_[at(s)];
      work_ += holders_[at(e)].size();
    }
  }

  std::vector<int> improved(std::size_t work, const RunControl& control) {
    list_ = taken();
    std::vector<int> best = list_;
    work_ = 0;
    for (std::size_t now = 1; work_ < work; ++now) {
      if (now % kStepsBetweenChecks == 0) control.check();
      while (open_.empty()) {
        best = list_;
        if (best.size() == 1) return best;
        leave(leastMissed(-1), now);
      }
      step(now);
      work_ += list_.size();
    }
    std::sort(best.begin(), best.end());
    return best;
  }

  std::vector<int> taken() const {
    std::vector<int> result;
    for (std::size_t s = 0; s < taken_.size(); ++s)
      if (taken_[s]) result.push_back(static_cast<int>(s));
    return result;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  const std::vector<int>& elements(int set) const { return system_.sets[at(set)]; }

  void leave(int set, std::size_t now) {
    drop(set);
    since_[at(set)] = now;
    list_.erase(std::find(list_.begin(), list_.end(), set));
  }
  void enter(int set, std::size_t now) {
    take(set);
    since_[at(set)] = now;
    last_ = set;
    list_.push_back(set);
  }
  void open(int element) {
    place_[at(element)] = static_cast<int>(open_.size());
    open_.push_back(element);
  }
  void close(int element) {
    const int place = std::exchange(place_[at(element)], -1);
    open_[at(place)] = open_.back();
    place_[at(open_.back())] = place;
    open_.pop_back();
    place_[at(element)] = -1;
  }

  const SetSystem& system_;
  std::vector<std::vector<int>> holders_;  // per element: the sets that hold it
  std::vector<int> count_;                 // per element: how many taken sets hold it,
  std::vector<long long> sum_;             // and the sum of their indices: of one, its index
  std::vector<long long> weight_;          // per element
  std::vector<int> open_, place_;          // elements that are not covered; per element: its place among them
  std::vector<long long> gain_;            // per set: what it alone covers, or would cover, by weight
  std::vector<char> taken_;                // per set
  std::vector<std::size_t> since_;         // per set: the step that changed it last
  std::vector<int> list_;                  // the taken sets
  int last_ = -1;                          // the set that was taken last
  std::size_t work_ = 0;
};

}  // namespace

std::vector<int> fewSets(const SetSystem& system, const std::vector<int>& start, std::size_t work, const RunControl& control) {
  Cover cover(system);
  for (const int set : start) cover.take(set);
  cover.complete();
  if (work > 0) cover.dropRedundant();
  return cover.improved(work, control);
}

}  // namespace collision_hulls
