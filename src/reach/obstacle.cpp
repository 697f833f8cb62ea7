// A mesh is a binary tree of axis-aligned boxes over its triangles, split at the median along the longest side. Distances are found best
// first, and each box and triangle is bounded by convexGap(), so that the result stays a proof.
#include "reach/obstacle.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>

namespace collision_hulls {
namespace {

constexpr std::size_t kLeaf = 4;  // triangles
constexpr double kClose = 1e-3;   // of the distance: smaller improvements are not searched for

const Gap kFar{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), Eigen::Vector3d::Zero()};

/// The gap to the nearer of two bodies.
Gap nearer(const Gap& a, const Gap& b) {
  return {std::min(a.at_least, b.at_least), std::min(a.at_most, b.at_most), Eigen::Vector3d::Zero()};
}

PointMatrix cornersOf(const Eigen::AlignedBox3d& box) {
  PointMatrix corners(3, 8);
  for (int i = 0; i < 8; ++i) corners.col(i) = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
  return corners;
}

PointMatrix placed(const std::vector<Eigen::Vector3d>& vertices, const Eigen::Isometry3d& pose) {
  PointMatrix points(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = pose * vertices[i];
  return points;
}

}  // namespace

Obstacle::Obstacle(const SceneBody& body) {
  if (const auto* hull = std::get_if<ConvexHull>(&body.shape)) {
    corners_ = placed(hull->vertices, body.pose);
  } else {
    const auto& mesh = std::get<TriangleMesh>(body.shape);
    const PointMatrix vertices = placed(mesh.vertices, body.pose);
    std::vector<PointMatrix> triangles;
    for (const Triangle& t : mesh.triangles) {
      PointMatrix corners(3, 3);
      corners << vertices.col(t[0]), vertices.col(t[1]), vertices.col(t[2]);
      triangles.push_back(corners);
    }
    corners_.resize(3, static_cast<Eigen::Index>(3 * triangles.size()));
    std::vector<std::size_t> order(triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    nodes_.resize(1);
    build(triangles, order, 0, 0, order.size());
  }
  size_ = corners_.cwiseAbs().maxCoeff();
}

void Obstacle::build(const std::vector<PointMatrix>& triangles, std::vector<std::size_t>& order, std::size_t node, std::size_t first,
                     std::size_t count) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = first; i < first + count; ++i) {
    const PointMatrix& t = triangles[order[i]];
    box.extend(t.col(0)).extend(t.col(1)).extend(t.col(2));
    corners_.middleCols(static_cast<Eigen::Index>(3 * i), 3) = t;
  }
  nodes_[node] = {box, static_cast<Eigen::Index>(3 * first), static_cast<Eigen::Index>(3 * count)};
  if (count <= kLeaf) return;
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::size_t half = count / 2;
  const auto begin = order.begin() + static_cast<std::ptrdiff_t>(first);
  std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half), begin + static_cast<std::ptrdiff_t>(count),
                   [&](std::size_t a, std::size_t b) {
                     const double left = triangles[a].row(axis).sum(), right = triangles[b].row(axis).sum();
                     return left < right || (left == right && a < b);
                   });
  const std::size_t child = nodes_.size();
  nodes_[node].first = static_cast<Eigen::Index>(child);
  nodes_[node].count = 0;
  nodes_.resize(child + 2);
  build(triangles, order, child, first, half);
  build(triangles, order, child + 1, first + half, count - half);
}

Gap Obstacle::gapToTriangles(const Node& leaf, const Eigen::Ref<const PointMatrix>& points, double enough) const {
  Gap least = kFar;
  for (Eigen::Index i = leaf.first; i < leaf.first + leaf.count; i += 3)
    least = nearer(least, convexGap(points, corners_.middleCols(i, 3), enough));
  return least;
}

// Visits nodes by their lower bounds, the nearest first, until none can be nearer than the best found.
Gap Obstacle::gapTo(const Eigen::Ref<const PointMatrix>& points, double enough) const {
  if (nodes_.empty()) return convexGap(points, corners_, enough);
  using Open = std::pair<double, std::size_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  open.emplace(0, 0);
  Gap result = kFar;
  while (!open.empty() && open.top().first < std::min(enough, (1 - kClose) * result.at_least)) {
    const Node& node = nodes_[open.top().second];
    open.pop();
    if (node.count > 0) {
      result = nearer(result, gapToTriangles(node, points, enough));
      continue;
    }
    for (const Eigen::Index child : {node.first, node.first + 1}) {
      const auto index = static_cast<std::size_t>(child);
      open.emplace(convexGap(points, cornersOf(nodes_[index].box), enough).at_least, index);
    }
  }
  if (!open.empty()) result.at_least = std::min(result.at_least, open.top().first);
  return result;
}

}  // namespace collision_hulls
