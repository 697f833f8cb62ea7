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

TEST(SetCover, SwapsSaveSetsAfterGreedy) {
  // Discs of radius 0.15 in a square.
  RandomPoints random(1);
  const std::vector<Eigen::Vector3d> points = random.cloud(400, 0.5), centres = random.cloud(400, 0.5);
  std::vector<std::vector<int>> sets(400);
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (std::size_t e = 0; e < points.size(); ++e)
      if ((points[e] - centres[s]).head<2>().norm() < 0.15 || s == e) sets[s].push_back(static_cast<int>(e));
  SetCover cover = coverOf(sets, 400);
  cover.complete();
  cover.dropRedundant();
  const std::size_t greedy = cover.chosen().size();
  EXPECT_TRUE(isCover(cover, sets, 400));
  EXPECT_LT(improved(cover, 20000), 0.95 * static_cast<double>(greedy)) << greedy;
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
