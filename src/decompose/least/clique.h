// Graphs, and the largest set of nodes of which every two are connected.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace collision_hulls {

/// A set of the numbers below a fixed count.
class NodeSet {
 public:
  explicit NodeSet(std::size_t count) : words_((count + kBits - 1) / kBits) {}

  void add(std::size_t i) { words_[i / kBits] |= bit(i); }
  void remove(std::size_t i) { words_[i / kBits] &= ~bit(i); }
  bool has(std::size_t i) const { return (words_[i / kBits] & bit(i)) != 0; }
  bool empty() const;
  bool meets(const NodeSet& other) const;
  /// The smallest number in the set; it must not be empty.
  std::size_t first() const;
  void keepOnly(const NodeSet& others);
  void removeAll(const NodeSet& others);

 private:
  static constexpr std::size_t kBits = 64;
  static std::uint64_t bit(std::size_t i) { return std::uint64_t{1} << (i % kBits); }

  std::vector<std::uint64_t> words_;
};

/// An undirected graph.
class Graph {
 public:
  explicit Graph(std::size_t nodes) : neighbours_(nodes, NodeSet(nodes)) {}

  std::size_t size() const { return neighbours_.size(); }
  void connect(std::size_t a, std::size_t b) {
    neighbours_[a].add(b);
    neighbours_[b].add(a);
  }
  bool connected(std::size_t a, std::size_t b) const { return neighbours_[a].has(b); }
  const NodeSet& neighbours(std::size_t a) const { return neighbours_[a]; }

 private:
  std::vector<NodeSet> neighbours_;
};

/// A clique: nodes of which every two are connected. The largest, unless the search ends before: at `enough` nodes, or after `most_steps`.
std::vector<std::size_t> largestClique(const Graph& graph, std::size_t enough, long most_steps);

}  // namespace collision_hulls
