// 2D convex hulls by the monotone chain, and a simplification that only grows: it drops one edge at a time and extends its neighbours until
// they meet. The edge whose removal reaches least far goes first. O(n^2).
#include "decompose/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "decompose/bounding_box.h"

namespace collision_hulls {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Where the neighbours of the edge that starts at corner i meet beyond it; nullopt if they do not.
std::optional<Eigen::Vector2d> apexOver(const Outline& outline, std::size_t i) {
  const std::size_t n = outline.size();
  const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % n];
  const Eigen::Vector2d before = a - outline[(i + n - 1) % n], after = outline[(i + 2) % n] - b;
  const double turn = cross(before, after);
  if (!(turn > 0)) return std::nullopt;
  return a + cross(b - a, after) / turn * before;
}

}  // namespace

/// Andrew's monotone chain.
Outline outlineOf(std::vector<Eigen::Vector2d> p) {
  std::sort(p.begin(), p.end(), [](const auto& a, const auto& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  Outline chain;
  const auto walk = [&](const Eigen::Vector2d& c, std::size_t fixed) {
    while (chain.size() > fixed && cross(chain.back() - chain[chain.size() - 2], c - chain.back()) <= 0) chain.pop_back();
    chain.push_back(c);
  };
  for (const auto& c : p) walk(c, 1);
  const std::size_t lower = chain.size();
  for (std::size_t i = p.size() - 1; i-- > 0;) walk(p[i], lower);
  chain.pop_back();
  return chain;
}

Outline simplified(Outline outline, std::size_t most) {
  while (outline.size() > most) {
    const std::size_t n = outline.size();
    double least = std::numeric_limits<double>::infinity();
    std::size_t dropped = n;
    Eigen::Vector2d corner = outline[0];
    for (std::size_t i = 0; i < n; ++i) {
      const auto apex = apexOver(outline, i);
      if (!apex) continue;
      const Eigen::Vector2d edge = outline[(i + 1) % n] - outline[i];
      const double beyond = std::abs(cross(edge.normalized(), *apex - outline[i]));
      if (beyond < least) least = beyond, dropped = i, corner = *apex;
    }
    if (dropped == n) break;  // only rounding gets here: from five edges up some edge can be dropped
    outline[dropped] = corner;
    outline.erase(outline.begin() + static_cast<std::ptrdiff_t>((dropped + 1) % n));
  }
  return outline;
}

ConvexHull prismAbout(const ConvexHull& hull, int max_vertices) {
  const Eigen::Matrix3d axes = principalAxes(hull.vertices);
  std::vector<Eigen::Vector2d> flat;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : hull.vertices) {
    const Eigen::Vector3d local = axes.transpose() * v;
    box.extend(local);
    flat.push_back(local.tail<2>());
  }
  std::vector<Eigen::Vector3d> corners;
  for (const Eigen::Vector2d& p : simplified(outlineOf(std::move(flat)), static_cast<std::size_t>(max_vertices) / 2))
    for (const double height : {box.min().x(), box.max().x()}) corners.push_back(axes * Eigen::Vector3d(height, p.x(), p.y()));
  return convexHull(corners);
}

}  // namespace collision_hulls
