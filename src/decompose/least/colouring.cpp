// Backtracking (Brelaz, "New methods to color the vertices of a graph", 1979): the node that has the fewest colours left goes next, and of
// several the one with most neighbours, so that contradictions come early. Of unused colours only the first is tried, as all are alike.
#include "decompose/least/colouring.h"

#include <algorithm>
#include <utility>

namespace collision_hulls {

namespace {

class ColouringSearch {
 public:
  ColouringSearch(const Graph& graph, std::size_t colours, long most_steps)
      : graph_(graph),
        steps_left_(most_steps),
        colour_(graph.size(), kNone),
        taken_(graph.size(), std::vector<int>(colours)),
        left_(graph.size(), colours),
        degree_(graph.size()) {
    for (std::size_t i = 0; i < graph.size(); ++i)
      for (std::size_t j = 0; j < graph.size(); ++j) degree_[i] += graph.connected(i, j);
  }

  void paint(std::size_t node, std::size_t colour) {
    colour_[node] = colour;
    ++painted_;
    for (std::size_t j = 0; j < graph_.size(); ++j)
      if (graph_.connected(node, j) && taken_[j][colour]++ == 0) --left_[j];
  }

  /// Whether the rest can be coloured with colours below `used` and unused ones. Also yes where the search ends early.
  bool canPaintRest(std::size_t used) {
    if (painted_ == graph_.size() || --steps_left_ <= 0) return true;
    const std::size_t node = hardest();
    for (std::size_t colour = 0; colour < std::min(used + 1, taken_[node].size()); ++colour) {
      if (taken_[node][colour] > 0) continue;
      paint(node, colour);
      if (canPaintRest(std::max(used, colour + 1))) return true;
      strip(node, colour);
    }
    return false;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void strip(std::size_t node, std::size_t colour) {
    colour_[node] = kNone;
    --painted_;
    for (std::size_t j = 0; j < graph_.size(); ++j)
      if (graph_.connected(node, j) && --taken_[j][colour] == 0) ++left_[j];
  }

  std::size_t hardest() const {
    std::size_t best = kNone;
    for (std::size_t i = 0; i < graph_.size(); ++i) {
      if (colour_[i] != kNone) continue;
      if (best == kNone || std::pair(left_[best], degree_[i]) > std::pair(left_[i], degree_[best])) best = i;
    }
    return best;
  }

  const Graph& graph_;
  long steps_left_;
  std::size_t painted_ = 0;
  std::vector<std::size_t> colour_;      // per node
  std::vector<std::vector<int>> taken_;  // per node and colour: neighbours that have it
  std::vector<std::size_t> left_, degree_;
};

}  // namespace

bool needsMoreColours(const Graph& graph, const std::vector<std::size_t>& clique, std::size_t colours, long most_steps) {
  if (clique.size() > colours) return true;
  ColouringSearch search(graph, colours, most_steps);
  for (std::size_t i = 0; i < clique.size(); ++i) search.paint(clique[i], i);
  return !search.canPaintRest(clique.size());
}

}  // namespace collision_hulls
