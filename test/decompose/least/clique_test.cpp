// Also tests src/decompose/least/colouring.cpp.
#include "decompose/least/clique.h"

#include <gtest/gtest.h>

#include <limits>

#include "decompose/least/colouring.h"
#include "random_points.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
constexpr long kSteps = 100'000;

/// Nodes around a circle, connected where they are at least `apart` steps from each other.
Graph circle(std::size_t nodes, std::size_t apart) {
  Graph graph(nodes);
  for (std::size_t i = 0; i < nodes; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::min(i - j, nodes - (i - j)) >= apart) graph.connect(i, j);
  return graph;
}

Graph randomGraph(std::size_t nodes, double density, std::uint32_t seed) {
  test_shapes::RandomPoints random(seed);
  Graph graph(nodes);
  for (std::size_t i = 0; i < nodes; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (random.number(0, 1) < density) graph.connect(i, j);
  return graph;
}

/// Tries all sets of nodes.
std::size_t cliqueByTrial(const Graph& graph) {
  std::size_t best = 0;
  for (unsigned set = 0; set < 1u << graph.size(); ++set) {
    std::size_t size = 0;
    bool is_clique = true;
    for (std::size_t i = 0; i < graph.size(); ++i) {
      if ((set >> i & 1) == 0) continue;
      ++size;
      for (std::size_t j = 0; j < i; ++j) is_clique = is_clique && ((set >> j & 1) == 0 || graph.connected(i, j));
    }
    if (is_clique) best = std::max(best, size);
  }
  return best;
}

bool colourableByTrial(const Graph& graph, std::size_t colours, std::vector<std::size_t>& given) {
  if (given.size() == graph.size()) return true;
  for (std::size_t colour = 0; colour < colours; ++colour) {
    bool is_free = true;
    for (std::size_t j = 0; j < given.size(); ++j) is_free = is_free && (given[j] != colour || !graph.connected(given.size(), j));
    if (!is_free) continue;
    given.push_back(colour);
    if (colourableByTrial(graph, colours, given)) return true;
    given.pop_back();
  }
  return false;
}

TEST(LargestClique, OfSmallGraphsIsThatOfATrialOfAllSets) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const Graph graph = randomGraph(12, 0.1 + 0.8 * seed / 60, seed);
    const std::vector<std::size_t> clique = largestClique(graph, kAny, kSteps);
    EXPECT_EQ(clique.size(), cliqueByTrial(graph)) << seed;
    for (const std::size_t a : clique)
      for (const std::size_t b : clique) EXPECT_TRUE(a == b || graph.connected(a, b)) << seed;
  }
}

TEST(LargestClique, OfManyNodes) {
  EXPECT_EQ(largestClique(circle(200, 30), kAny, kSteps).size(), 6u);
  EXPECT_EQ(largestClique(Graph(0), kAny, kSteps).size(), 0u);
  EXPECT_EQ(largestClique(Graph(70), kAny, kSteps).size(), 1u);
}

TEST(LargestClique, EndsAtALimit) {
  EXPECT_EQ(largestClique(circle(200, 1), 7, kSteps).size(), 7u);
  EXPECT_EQ(largestClique(circle(200, 1), kAny, 5).size(), 5u);
}

TEST(NeedsMoreColours, AgreesWithATrialOfAllColourings) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const Graph graph = randomGraph(9, 0.2 + 0.6 * seed / 40, seed);
    const std::vector<std::size_t> clique = largestClique(graph, kAny, kSteps);
    for (std::size_t colours = 1; colours < 8; ++colours) {
      std::vector<std::size_t> given;
      EXPECT_EQ(needsMoreColours(graph, clique, colours, kSteps), !colourableByTrial(graph, colours, given)) << seed << " " << colours;
    }
  }
}

TEST(NeedsMoreColours, WhereACliqueIsTooSmallToTell) {  // nodes in a third of the circle may share a colour: 20 / 6
  const Graph graph = circle(20, 6);
  const std::vector<std::size_t> clique = largestClique(graph, kAny, kSteps);
  EXPECT_EQ(clique.size(), 3u);
  EXPECT_TRUE(needsMoreColours(graph, clique, 3, kSteps));
  EXPECT_FALSE(needsMoreColours(graph, clique, 4, kSteps));
}

TEST(NeedsMoreColours, ProvesNothingWithoutSteps) {
  EXPECT_FALSE(needsMoreColours(circle(20, 6), {}, 3, 2));
}

}  // namespace
}  // namespace collision_hulls
