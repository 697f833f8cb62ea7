// Few sets that cover everything.
#pragma once

#include <cstddef>
#include <vector>

namespace collision_hulls {

/// A choice among sets of elements, improved step by step. Elements and sets may come later, too. Deterministic.
class SetCover {
 public:
  /// Adds element number elements(), which the sets `holders` hold.
  void addElement(const std::vector<int>& holders);
  /// Adds a set of elements; returns its number.
  int addSet(const std::vector<int>& elements);
  /// Puts another set of elements in the place of one that is not chosen.
  void replaceSet(int set, const std::vector<int>& elements);

  std::size_t elements() const { return count_.size(); }
  std::size_t sets() const { return gain_.size(); }
  bool isChosen(int set) const { return chosen_[at(set)] != 0; }
  const std::vector<int>& chosen() const { return list_; }
  /// Elements that no chosen set holds.
  const std::vector<int>& open() const { return open_; }

  void complete();       ///< chooses sets until no element is open, greedily
  void dropRedundant();  ///< drops sets that hold nothing alone, smallest first
  void dropLeast();      ///< drops the set that would be missed least
  /// Drops a set, and chooses the one that gains most among those that hold an open element.
  void swapFor(int element);

  /// How many elements and sets were looked at so far.
  std::size_t work() const { return work_; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  void choose(int set);
  void drop(int set);
  int leastMissed(int except) const;
  int bestHolder(int element) const;
  void setOpen(int element);
  void setCovered(int element);

  // per element
  std::vector<std::vector<int>> holders_;  // the sets that hold it
  std::vector<int> count_;                 // how many chosen sets hold it,
  std::vector<long long> sum_;             // and the sum of their numbers: of one, its number
  std::vector<long long> weight_;
  std::vector<int> place_;  // in open_; -1: covered
  // per set
  std::vector<std::vector<int>> held_;  // its elements
  std::vector<long long> gain_;         // the weight of what it alone holds, or would hold
  std::vector<char> chosen_;
  std::vector<std::size_t> since_;  // the step that changed it last
  std::vector<int> list_, open_;
  int last_ = -1;  // the set that was chosen last
  std::size_t now_ = 0, work_ = 0;
};

}  // namespace collision_hulls
