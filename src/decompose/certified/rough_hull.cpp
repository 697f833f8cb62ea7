// Quickhull, of points that are moved a little outward where it would refuse them as they are.
#include "decompose/certified/rough_hull.h"

#include <optional>
#include <utility>

#include "base/at.h"
#include "base/random.h"

namespace collision_hulls {

namespace {

constexpr double kJoggle = 1e-6;           // most that points are moved, as a share of their distance from the middle
constexpr std::size_t kJoggles = 3;        // attempts
constexpr std::size_t kManyPoints = 3000;  // with more, coplanar points hinder quickhull so often that all are moved right away

/// Moves the points away from the origin, which lies in their hull: the new hull contains the old one, and points that were coplanar hardly
/// ever still are. Each trial moves them differently.
std::vector<Eigen::Vector3d> joggled(std::vector<Eigen::Vector3d> points, std::size_t trial) {
  for (std::size_t i = 0; i < points.size(); ++i) points[i] *= 1 + kJoggle * unitInterval(mixed(i + trial * points.size()));
  return points;
}

}  // namespace

ConvexHull roughHull(const std::vector<Eigen::Vector3d>& points, Corners corners, const RunControl& control) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) middle += p / static_cast<double>(points.size());
  std::vector<Eigen::Vector3d> centred;
  centred.reserve(points.size());
  for (const Eigen::Vector3d& p : points) centred.push_back(p - middle);
  std::optional<ConvexHull> hull;
  std::vector<int> sources;
  if (points.size() <= kManyPoints) hull = quickhull(centred, control, corners, &sources);
  for (std::size_t trial = 0; !hull && trial < kJoggles; ++trial) hull = quickhull(joggled(centred, trial), control, corners, &sources);
  if (!hull) return convexHull(points, control);
  for (std::size_t i = 0; i < sources.size(); ++i) hull->vertices[i] = points[at(sources[i])];  // bit by bit, for KnownFacets
  for (HalfSpace& face : hull->faces) face.offset += face.normal.dot(middle);
  return *std::move(hull);
}

}  // namespace collision_hulls
