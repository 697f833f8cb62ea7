#include "decompose/pair_queue.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace collision_hulls {
namespace {

using Order = std::vector<std::pair<int, int>>;

/// The order in which a queue gives its pairs if nothing is ever merged.
Order taken(PairQueue queue) {
  Order order;
  while (const auto pair = queue.takeCheapest([](int) { return true; })) order.push_back({pair->a, pair->b});
  return order;
}

TEST(PairQueueTest, AnEmptyQueueGivesNothing) {
  EXPECT_EQ(taken({}), Order{});
}

TEST(PairQueueTest, TheCheapestPairComesFirst) {
  PairQueue queue;
  queue.push({3, 0, 1});
  queue.push({1, 2, 3});
  queue.push({2, 0, 3});
  EXPECT_EQ(taken(queue), (Order{{2, 3}, {0, 3}, {0, 1}}));
}

TEST(PairQueueTest, OnATieTheLowerIndicesComeFirstWhateverTheOrderOfEntry) {
  const std::vector<MergePair> pairs{{1, 0, 2}, {1, 1, 2}, {1, 0, 1}};
  PairQueue forward, backward;
  for (std::size_t i = 0; i < pairs.size(); ++i) forward.push(pairs[i]), backward.push(pairs[pairs.size() - 1 - i]);
  EXPECT_EQ(taken(forward), (Order{{0, 1}, {0, 2}, {1, 2}}));
  EXPECT_EQ(taken(backward), taken(forward));
}

TEST(PairQueueTest, PairsWithAPartThatIsGoneAreSkipped) {
  PairQueue queue;
  queue.push({1, 0, 1});
  queue.push({2, 1, 2});
  queue.push({3, 2, 3});
  const auto pair = queue.takeCheapest([](int i) { return i != 1; });
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->a, 2);
  EXPECT_EQ(pair->b, 3);
}

}  // namespace
}  // namespace collision_hulls
