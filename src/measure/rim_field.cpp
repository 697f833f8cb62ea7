// From p, a piece of the rim of length l that is no nearer than D adds at most l / (4 pi D^2) to the gradient; after a path of length s, it
// is no nearer than D - s. So along the path the winding number changes by at most the sum of l / (4 pi) times s / (D (D - s)). With d the
// least D and B the sum of l / (4 pi D^2), that is at most B s d / (d - s), which reaches the margin m at s = m d / (B d + m).
#include "measure/rim_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/looks.h"
#include "geometry/pi.h"
#include "geometry/segment_distance.h"

namespace collision_hulls {
namespace {

constexpr double kFar = 1;  // in diagonals of its box: a piece that is further counts as a whole, at its box's distance

}  // namespace

double RimField::Seen::way(double margin) const {
  if (!(distance > 0)) return 0;
  return strength > 0 ? margin * distance / (strength * distance + margin) : distance;
}

RimField::RimField(const std::vector<Eigen::Vector3d>& vertices, const Rim& rim, const RunControl& control) {
  if (rim.empty()) return;
  const auto corner = [&](std::size_t edge, std::size_t k) -> const Eigen::Vector3d& {
    return vertices[static_cast<std::size_t>(rim[edge][k])];
  };
  std::vector<std::size_t> edges(rim.size());
  std::iota(edges.begin(), edges.end(), std::size_t{0});
  nodes_.reserve(2 * rim.size() - 1);
  Looks look(control);
  struct Part {
    int node;
    std::size_t from, to;  // of `edges`
  };
  std::vector<Part> parts{{0, 0, edges.size()}};
  nodes_.emplace_back();
  while (!parts.empty()) {
    const Part part = parts.back();
    parts.pop_back();
    Node node;
    for (std::size_t i = part.from; i < part.to; ++i) {
      look();
      node.a = corner(edges[i], 0), node.b = corner(edges[i], 1);
      node.box.extend(node.a).extend(node.b);
      node.length += (node.b - node.a).norm();
    }
    node.squared_diagonal = node.box.diagonal().squaredNorm();
    if (part.to - part.from > 1) {
      node.children = static_cast<int>(nodes_.size());
      nodes_.resize(nodes_.size() + 2);
      Eigen::Index axis = 0;
      node.box.sizes().maxCoeff(&axis);
      const auto middle = [&](std::size_t edge) { return std::pair(corner(edge, 0)[axis] + corner(edge, 1)[axis], edge); };
      const auto at = [&](std::size_t i) { return edges.begin() + static_cast<std::ptrdiff_t>(i); };
      const std::size_t half = part.from + (part.to - part.from) / 2;
      std::nth_element(at(part.from), at(half), at(part.to), [&](std::size_t x, std::size_t y) { return look(), middle(x) < middle(y); });
      parts.push_back({node.children, part.from, half});
      parts.push_back({node.children + 1, half, part.to});
    }
    nodes_[static_cast<std::size_t>(part.node)] = node;
  }
}

RimField::Seen RimField::from(const Eigen::Vector3d& p) const {
  Seen seen{std::numeric_limits<double>::infinity(), 0};
  if (nodes_.empty()) return seen;
  double nearest = seen.distance;       // squared
  constexpr std::size_t kDeepest = 64;  // each level halves the edges
  std::array<int, kDeepest> open{0};
  for (std::size_t count = 1; count > 0;) {
    const Node& node = nodes_[static_cast<std::size_t>(open[--count])];
    const bool is_leaf = node.children < 0;
    const double squared = is_leaf ? squaredSegmentDistance(p, node.a, node.b) : node.box.squaredExteriorDistance(p);
    if (!is_leaf && squared < kFar * kFar * node.squared_diagonal) {
      open[count++] = node.children;
      open[count++] = node.children + 1;
      continue;
    }
    nearest = std::min(nearest, squared);
    if (node.length > 0) seen.strength += node.length / (4 * kPi * squared);
  }
  seen.distance = std::sqrt(nearest);
  return seen;
}

}  // namespace collision_hulls
