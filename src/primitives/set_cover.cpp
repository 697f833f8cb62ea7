// Greedy, then a local search with weights (Gao, Weise, Li 2015: RWLS). A swap drops the chosen set that would be missed least, and chooses
// the one that gains most among those that hold some open element. Elements that stay open gain weight, so the search leaves places where
// it was stuck; of equals, sets that have not changed for long go first, so it does not run in circles. A set's gain is the weight of the
// elements that it alone holds, or would hold; it is kept up to date as sets come and go.
//
// Exact solvers do not scale to thousands of sets.
#include "primitives/set_cover.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace collision_hulls {

void SetCover::addElement(const std::vector<int>& holders) {
  const int element = static_cast<int>(count_.size());
  holders_.push_back(holders);
  count_.push_back(0);
  sum_.push_back(0);
  weight_.push_back(1);
  place_.push_back(-1);
  for (const int s : holders) {
    held_[at(s)].push_back(element);
    if (!isChosen(s)) continue;
    ++count_.back();
    sum_.back() += s;
  }
  if (count_.back() == 1) ++gain_[at(static_cast<int>(sum_.back()))];
  if (count_.back() > 0) return;
  for (const int s : holders) ++gain_[at(s)];
  setOpen(element);
}

int SetCover::addSet(const std::vector<int>& elements) {
  const int set = static_cast<int>(gain_.size());
  held_.emplace_back();
  gain_.push_back(0);
  chosen_.push_back(0);
  since_.push_back(0);
  replaceSet(set, elements);
  return set;
}

void SetCover::replaceSet(int set, const std::vector<int>& elements) {
  for (const int e : held_[at(set)]) {
    std::vector<int>& holders = holders_[at(e)];
    *std::find(holders.begin(), holders.end(), set) = holders.back();
    holders.pop_back();
  }
  held_[at(set)] = elements;
  gain_[at(set)] = 0;
  since_[at(set)] = 0;
  for (const int e : elements) {
    holders_[at(e)].push_back(set);
    if (count_[at(e)] == 0) gain_[at(set)] += weight_[at(e)];
  }
  work_ += elements.size();
}

void SetCover::choose(int set) {
  chosen_[at(set)] = 1;
  list_.push_back(set);
  since_[at(set)] = now_;
  last_ = set;
  long long own = 0;
  for (const int e : held_[at(set)]) {
    sum_[at(e)] += set;
    const int before = count_[at(e)]++;
    if (before == 0) {
      own += weight_[at(e)];
      for (const int other : holders_[at(e)]) gain_[at(other)] -= weight_[at(e)];
      work_ += holders_[at(e)].size();
      setCovered(e);
    } else if (before == 1) {
      gain_[at(static_cast<int>(sum_[at(e)]) - set)] -= weight_[at(e)];
    }
  }
  gain_[at(set)] = own;
  work_ += held_[at(set)].size();
}

void SetCover::drop(int set) {
  chosen_[at(set)] = 0;
  list_.erase(std::find(list_.begin(), list_.end(), set));
  since_[at(set)] = now_;
  long long own = 0;
  for (const int e : held_[at(set)]) {
    sum_[at(e)] -= set;
    const int left = --count_[at(e)];
    if (left == 0) {
      for (const int other : holders_[at(e)]) gain_[at(other)] += weight_[at(e)];
      work_ += holders_[at(e)].size();
      own += weight_[at(e)];
      setOpen(e);
    } else if (left == 1) {
      gain_[at(static_cast<int>(sum_[at(e)]))] += weight_[at(e)];
    }
  }
  gain_[at(set)] = own;
  work_ += held_[at(set)].size();
}

/// Gains only shrink meanwhile, so old ones are upper bounds.
void SetCover::complete() {
  std::priority_queue<std::pair<long long, int>> queue;
  for (std::size_t s = 0; s < gain_.size(); ++s)
    if (!chosen_[s]) queue.emplace(gain_[s], -static_cast<int>(s));
  while (!open_.empty() && !queue.empty()) {
    const auto [gain, negative] = queue.top();
    queue.pop();
    if (gain_[at(-negative)] == gain)
      choose(-negative);
    else
      queue.emplace(gain_[at(-negative)], negative);
  }
}

void SetCover::dropRedundant() {
  std::vector<int> sets = list_;
  std::stable_sort(sets.begin(), sets.end(), [&](int a, int b) { return held_[at(a)].size() < held_[at(b)].size(); });
  for (const int s : sets)
    if (gain_[at(s)] == 0) drop(s);
}

void SetCover::dropLeast() {
  ++now_;
  const int set = leastMissed(-1);
  if (set >= 0) drop(set);
}

void SetCover::swapFor(int element) {
  ++now_;
  work_ += list_.size() + holders_[at(element)].size();
  const int out = leastMissed(last_);
  if (out >= 0) drop(out);
  const int in = bestHolder(element);
  choose(in >= 0 ? in : out);
  for (const int e : open_) {
    ++weight_[at(e)];
    for (const int s : holders_[at(e)]) ++gain_[at(s)];
    work_ += holders_[at(e)].size();
  }
}

/// Of several, the one that has not changed for longest.
int SetCover::leastMissed(int except) const {
  int best = -1;
  for (const int s : list_) {
    if (s == except) continue;
    if (best < 0 || std::pair(gain_[at(s)], since_[at(s)]) < std::pair(gain_[at(best)], since_[at(best)])) best = s;
  }
  return best;
}

/// None that was dropped in this step.
int SetCover::bestHolder(int element) const {
  int best = -1;
  for (const int s : holders_[at(element)]) {
    if (since_[at(s)] == now_) continue;
    if (best < 0 || std::pair(-gain_[at(s)], since_[at(s)]) < std::pair(-gain_[at(best)], since_[at(best)])) best = s;
  }
  return best;
}

void SetCover::setOpen(int element) {
  place_[at(element)] = static_cast<int>(open_.size());
  open_.push_back(element);
}

void SetCover::setCovered(int element) {
  const int place = place_[at(element)];
  open_[at(place)] = open_.back();
  place_[at(open_.back())] = place;
  open_.pop_back();
  place_[at(element)] = -1;
}

}  // namespace collision_hulls
