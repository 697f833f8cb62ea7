// Branch and bound with colours (Tomita and Seki, "An efficient branch-and-bound algorithm for finding a maximum clique", 2003): a clique
// takes at most one node of each colour of a colouring in which neighbours differ, so nodes are tried from the last colour down until
// the colours left are too few. Sets of nodes are bits, which makes a greedy colouring cheap. Exponential in the worst case; graphs of
// points that are apart take some hundred steps.
#include "decompose/least/clique.h"

#include <algorithm>

namespace collision_hulls {

bool NodeSet::empty() const {
  return std::all_of(words_.begin(), words_.end(), [](std::uint64_t word) { return word == 0; });
}

bool NodeSet::meets(const NodeSet& other) const {
  for (std::size_t w = 0; w < words_.size(); ++w)
    if ((words_[w] & other.words_[w]) != 0) return true;
  return false;
}

std::size_t NodeSet::first() const {
  std::size_t w = 0, i = 0;
  while (words_[w] == 0) ++w;
  while ((words_[w] >> i & 1) == 0) ++i;
  return w * kBits + i;
}

void NodeSet::keepOnly(const NodeSet& others) {
  for (std::size_t w = 0; w < words_.size(); ++w) words_[w] &= others.words_[w];
}

void NodeSet::removeAll(const NodeSet& others) {
  for (std::size_t w = 0; w < words_.size(); ++w) words_[w] &= ~others.words_[w];
}

namespace {

class CliqueSearch {
 public:
  CliqueSearch(const Graph& graph, std::size_t enough, long most_steps) : graph_(graph), enough_(enough), most_steps_(most_steps) {}

  /// Adds nodes of `candidates`, all neighbours of the chosen ones, in every way that may lead to a larger clique.
  void extend(NodeSet candidates) {
    const std::vector<Coloured> order = coloured(candidates);
    for (auto next = order.rbegin(); next != order.rend() && !isOver(); ++next) {
      if (chosen_.size() + next->colours <= best_.size()) return;
      ++steps_;
      chosen_.push_back(next->node);
      if (chosen_.size() > best_.size()) best_ = chosen_;
      NodeSet rest = candidates;
      rest.keepOnly(graph_.neighbours(next->node));
      if (!rest.empty()) extend(std::move(rest));
      chosen_.pop_back();
      candidates.remove(next->node);
    }
  }

  const std::vector<std::size_t>& best() const { return best_; }

 private:
  struct Coloured {
    std::size_t node, colours;  // of this node and those before it
  };

  bool isOver() const { return best_.size() >= enough_ || steps_ >= most_steps_; }

  /// The nodes by colour: each colour takes whatever is not next to one that has it.
  std::vector<Coloured> coloured(NodeSet nodes) const {
    std::vector<Coloured> order;
    for (std::size_t colours = 1; !nodes.empty(); ++colours)
      for (NodeSet free = nodes; !free.empty();) {
        const std::size_t node = free.first();
        nodes.remove(node);
        free.remove(node);
        free.removeAll(graph_.neighbours(node));
        order.push_back({node, colours});
      }
    return order;
  }

  const Graph& graph_;
  const std::size_t enough_;
  const long most_steps_;
  long steps_ = 0;
  std::vector<std::size_t> chosen_, best_;
};

}  // namespace

std::vector<std::size_t> largestClique(const Graph& graph, std::size_t enough, long most_steps) {
  CliqueSearch search(graph, enough, most_steps);
  NodeSet all(graph.size());
  for (std::size_t i = 0; i < graph.size(); ++i) all.add(i);
  search.extend(all);
  return search.best();
}

}  // namespace collision_hulls
