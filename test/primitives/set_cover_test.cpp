#include "primitives/set_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "random_points.h"

namespace collision_hulls {
namespace {

using test_shapes::RandomPoints;

bool isCover(const SetCover& cover, const std::vector<std::vector<int>>& sets, std::size_t elements) {
  std::set<int> held;
  for (const int s : cover.chosen()) held.insert(sets[static_cast<std::size_t>(s)].begin(), sets[static_cast<std::size_t>(s)].end());
  return held.size() == elements;
}

SetCover coverOf(const std::vector<std::vector<int>>& sets, int elements) {
  SetCover cover;
  for (std::size_t s = 0; s < sets.size(); ++s) cover.addSet({});
  for (int e = 0; e < elements; ++e) {
    std::vector<int> holders;
    for (std::size_t s = 0; s < sets.size(); ++s)
      if (std::find(sets[s].begin(), sets[s].end(), e) != sets[s].end()) holders.push_back(static_cast<int>(s));
    cover.addElement(holders);
  }
  return cover;
}

/// The best of some swaps.
std::size_t improved(SetCover& cover, int swaps) {
  std::size_t best = cover.chosen().size();
  for (int i = 0; i < swaps; ++i) {
    while (cover.open().empty() && cover.chosen().size() > 1) best = cover.chosen().size(), cover.dropLeast();
    if (!cover.open().empty()) cover.swapFor(cover.open()[static_cast<std::size_t>(i) % cover.open().size()]);
  }
  return best;
}

TEST(SetCover, NothingNeedsNothing) {
  SetCover cover;
  cover.complete();
  EXPECT_TRUE(cover.chosen().empty());
  EXPECT_TRUE(cover.open().empty());
}

TEST(SetCover, SwapsFindWhatGreedyMisses) {
  // Greedy takes the set of six first, and then needs two more.
  const std::vector<std::vector<int>> sets{{0, 1, 2, 3, 4}, {5, 6, 7, 8, 9}, {2, 3, 4, 5, 6, 7}};
  SetCover cover = coverOf(sets, 10);
  cover.complete();
  EXPECT_EQ(cover.chosen().size(), 3U);
  EXPECT_TRUE(isCover(cover, sets, 10));
  cover.dropRedundant();
  EXPECT_EQ(cover.chosen().size(), 2U);
  EXPECT_TRUE(isCover(cover, sets, 10));
}

TEST(SetCover, ComesCloseToAHiddenCoverOfTen) {
  RandomPoints random(1);
  std::vector<std::vector<int>> sets(10);
  for (int e = 0; e < 300; ++e) sets[static_cast<std::size_t>(random.index(10))].push_back(e);
  while (sets.size() < 400) {
    std::set<int> any;
    while (any.size() < 40) any.insert(random.index(300));
    sets.emplace_back(any.begin(), any.end());
  }
  SetCover cover = coverOf(sets, 300);
  cover.complete();
  const std::size_t greedy = cover.chosen().size();
  EXPECT_GT(greedy, 12U);
  EXPECT_LE(improved(cover, 20000), 10U);
}

TEST(SetCover, WhatIsOpenIsWhatNoChosenSetHolds) {
  RandomPoints random(2);
  std::vector<std::vector<int>> sets(40);
  for (std::vector<int>& set : sets)
    for (int e = 0; e < 60; ++e)
      if (random.index(6) == 0) set.push_back(e);
  for (int e = 0; e < 60; ++e) sets[static_cast<std::size_t>(e % 40)].push_back(e);
  for (std::vector<int>& set : sets) {
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
  }
  SetCover cover = coverOf(sets, 60);
  cover.complete();
  for (int i = 0; i < 500; ++i) {
    if (cover.open().empty()) {
      cover.dropLeast();
    } else {
      cover.swapFor(cover.open().front());
    }
    const int replaced = random.index(40);
    if (!cover.isChosen(replaced)) cover.replaceSet(replaced, sets[static_cast<std::size_t>(replaced)]);
    for (int e = 0; e < 60; ++e) {
      const auto holds = [&](int s) {
        return std::count(sets[static_cast<std::size_t>(s)].begin(), sets[static_cast<std::size_t>(s)].end(), e) > 0;
      };
      const bool is_open = std::count(cover.open().begin(), cover.open().end(), e) > 0;
      EXPECT_EQ(is_open, std::none_of(cover.chosen().begin(), cover.chosen().end(), holds));
    }
  }
}

}  // namespace
}  // namespace collision_hulls
