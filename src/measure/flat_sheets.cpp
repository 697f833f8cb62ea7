// Inside a group, the two triangles at an edge run along it in opposite directions and face the same way, so they lie on either side of it.
// Projected to the plane, the group therefore covers a neighbourhood of each of its points except those on its rim. Hence a connected set
// that contains a point of the group and meets no edge of the rim is covered.
#include "measure/flat_sheets.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace collision_hulls {

namespace {

constexpr double kFlat = 1e-6;     // largest deviation from the plane, as a share of the mesh's diagonal
constexpr double kMargin = 1e-9;   // what counts as on the outline, as a share of the diagonal: rounding may put it on either side
constexpr double kSameWay = 0.5;   // least cosine between the group's normal and its triangles'
constexpr double kExtent = 0.01;   // of the mesh's diagonal; groups of less are left to the search's other bounds,
constexpr std::size_t kLeast = 2;  // and so are single triangles

/// The triangle across a half-edge if it runs along the edge in the opposite direction; -1: none.
int neighbour(const RepairedMesh& mesh, const Edges& edges, int h) {
  const int twin = edges.twin[static_cast<std::size_t>(h)];
  return twin >= 0 && startOf(mesh.mesh.triangles, twin) == endOf(mesh.mesh.triangles, h) ? twin / 3 : -1;
}

double extentOf(const TriangleMesh& mesh, const std::vector<int>& triangles, Looks& look) {
  Eigen::AlignedBox3d box;
  for (const int t : triangles)
    for (int k = 0; k < 3; ++k) look(), box.extend(mesh.corner(t, k));
  return box.diagonal().norm();
}

Eigen::Vector3d normalOf(const TriangleMesh& mesh, int t) {
  return (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)).normalized();
}

}  // namespace

FlatSheets::FlatSheets(const RepairedMesh& mesh, const Edges& edges, const std::vector<char>& two_sided, const RunControl& control)
    : flat_(kFlat * diagonal(mesh.mesh)),
      margin_(kMargin * diagonal(mesh.mesh)),
      group_(mesh.mesh.triangles.size(), -1),
      rim_(TriangleMesh{}) {
  constexpr int kSmall = -2;
  const double least = kExtent * diagonal(mesh.mesh);
  Looks look(control);
  for (std::size_t t = 0; t < group_.size(); ++t) {
    look();
    if (group_[t] != -1 || !two_sided[t]) continue;
    Group group = grownFrom(static_cast<int>(t), mesh, edges, two_sided, look);
    const bool large = group.triangles.size() >= kLeast && extentOf(mesh.mesh, group.triangles, look) >= least;
    for (const int of_it : group.triangles) group_[static_cast<std::size_t>(of_it)] = large ? static_cast<int>(groups_.size()) : kSmall;
    if (large) groups_.push_back(std::move(group));
  }
  if (!groups_.empty()) rim_ = rims(mesh, edges, control);
}

FlatSheets::Group FlatSheets::grownFrom(int seed, const RepairedMesh& mesh, const Edges& edges, const std::vector<char>& two_sided,
                                        Looks& look) {
  const int number = static_cast<int>(groups_.size());
  Group group{normalOf(mesh.mesh, seed), mesh.mesh.corner(seed, 0), 0, {seed}};
  group_[static_cast<std::size_t>(seed)] = number;
  for (std::size_t next = 0; next < group.triangles.size(); ++next) {
    look();
    for (int k = 0; k < 3; ++k) {
      const int t = neighbour(mesh, edges, 3 * group.triangles[next] + k);
      if (t < 0 || group_[static_cast<std::size_t>(t)] != -1 || !two_sided[static_cast<std::size_t>(t)]) continue;
      double deviation = 0;
      for (int corner = 0; corner < 3; ++corner)
        deviation = std::max(deviation, std::abs(group.normal.dot(mesh.mesh.corner(t, corner) - group.through)));
      if (!(deviation <= flat_ && normalOf(mesh.mesh, t).dot(group.normal) > kSameWay)) continue;
      group.deviation = std::max(group.deviation, deviation);
      group_[static_cast<std::size_t>(t)] = number;
      group.triangles.push_back(t);
    }
  }
  return group;
}

TriangleBvh FlatSheets::rims(const RepairedMesh& mesh, const Edges& edges, const RunControl& control) const {
  TriangleMesh rims;
  rims.vertices = mesh.mesh.vertices;
  Looks look(control);
  for (const Group& group : groups_)
    for (const int t : group.triangles)
      for (int h = 3 * t; h < 3 * t + 3; ++h) {
        look();
        const int other = neighbour(mesh, edges, h);
        if (other >= 0 && group_[static_cast<std::size_t>(other)] == group_[static_cast<std::size_t>(t)]) continue;
        const int from = startOf(mesh.mesh.triangles, h), to = endOf(mesh.mesh.triangles, h);
        rims.triangles.push_back({from, to, to});
      }
  return TriangleBvh(rims, {}, control, TriangleBvh::Keeps::kNothing);
}

double FlatSheets::bound(const std::array<Eigen::Vector3d, 3>& patch, const TriangleBvh::Nearest& near, double slack) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto t = static_cast<std::size_t>(near.triangle);
  if (groups_.empty() || near.triangle < 0 || t >= group_.size() || group_[t] < 0) return kNone;
  const Group& group = groups_[static_cast<std::size_t>(group_[t])];
  const auto height = [&](const Eigen::Vector3d& p) { return group.normal.dot(p - group.through); };
  const Eigen::Vector3d middle = near.point - height(near.point) * group.normal;
  double radius = 0, highest = 0;
  for (const Eigen::Vector3d& p : patch) {
    radius = std::max(radius, (p - height(p) * group.normal - middle).norm());
    highest = std::max(highest, std::abs(height(p)));
  }
  if (slack > radius) return kNone;
  std::array<Eigen::Vector3d, 3> inner;  // the patch projected to the plane and shrunk toward the middle by at most `slack`
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d flat = patch[k] - height(patch[k]) * group.normal;
    inner[k] = flat + slack / radius * (middle - flat);
  }
  return isCovered(inner, middle, group) ? highest + group.deviation + slack : kNone;
}

/// Whether a triangle in a group's plane that contains a point of the group meets no edge of the rim.
bool FlatSheets::isCovered(const std::array<Eigen::Vector3d, 3>& triangle, const Eigen::Vector3d& point, const Group& group) const {
  std::array<Eigen::Vector3d, 3> normals;
  for (std::size_t k = 0; k < 3; ++k) normals[k] = group.normal.cross(triangle[(k + 1) % 3] - triangle[k]);
  const double side = normals[0].dot(triangle[2] - triangle[0]) > 0 ? 1 : -1;
  Eigen::AlignedBox3d box;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(side * normals[k].dot(point - triangle[k]) >= 0)) return false;
    box.extend(triangle[k]);
  }
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(group.deviation + margin_);
  const std::vector<int> edges = rim_.trianglesNear({box.min() - reach, box.max() + reach});
  return std::none_of(edges.begin(), edges.end(), [&](int edge) {
    const std::array<Eigen::Vector3d, 3>& corners = rim_.corners(edge);
    const Eigen::Vector3d &a = corners[0], &b = corners[1];
    const auto isBeyond = [&](std::size_t k, const Eigen::Vector3d& p) {
      return side * normals[k].dot(p - triangle[k]) < -margin_ * normals[k].norm();
    };
    for (std::size_t k = 0; k < 3; ++k)
      if (isBeyond(k, a) && isBeyond(k, b)) return false;
    const Eigen::Vector3d across = group.normal.cross(b - a);
    const auto [low, high] = std::minmax({across.dot(triangle[0] - a), across.dot(triangle[1] - a), across.dot(triangle[2] - a)});
    return low <= margin_ * across.norm() && high >= -margin_ * across.norm();
  });
}

}  // namespace collision_hulls
