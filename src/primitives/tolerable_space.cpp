// A cube about c of half side h lies in T if d(c) + sqrt(3) h is at most the tolerance, where d is the distance to S, or minus the radius
// of a ball in S (Solid::signedDistance). Cubes that lie in T, or wholly outside it, are leaves; others are divided until they are small.
// Whatever is not proved to lie in T counts as outside, so a ball that meets no such cube lies in T.
//
// That knows of grooves, holes and walls inside, which the triangle inequality does not see: the ball about c of radius tolerance - d(c)
// ends at the first wall, even if there is solid behind it. It is exact where that wall is the border of T, so the larger of the two balls
// counts.
#include "primitives/tolerable_space.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace collision_hulls {

namespace {

constexpr double kFinest = 0.25;             // of the tolerance: radius of the smallest cubes
constexpr std::size_t kMostCells = 200'000;  // divided breadth first, so that what remains is evenly coarse
constexpr std::size_t kCellsAtOnce = 64;     // that one thread measures
constexpr double kBoxMargin = 1.05;          // tolerances around the surface that the octree reaches
const double kSqrt3 = std::sqrt(3.0);

}  // namespace

TolerableSpace::TolerableSpace(const Solid& solid, const Eigen::AlignedBox3d& box, double tolerance, const RunControl& control)
    : solid_(solid), tolerance_(tolerance) {
  Cell root;
  root.centre = box.center();
  root.half = box.sizes().maxCoeff() / 2 + kBoxMargin * tolerance;
  root.to_surface = std::numeric_limits<double>::infinity();
  cells_.push_back(root);
  divide(kFinest * tolerance, control);
}

/// Fills in what is known at the cell's centre, and says where the cell lies.
TolerableSpace::Place TolerableSpace::measure(Cell& cell, const Cell& parent) const {
  const TriangleBvh::Nearest near = solid_.surface().nearest(cell.centre, std::numeric_limits<double>::infinity(), parent.triangle);
  const double radius = kSqrt3 * cell.half;
  cell.to_surface = near.distance;
  cell.triangle = near.triangle;
  if (near.distance + radius <= tolerance_) return Place::kIn;
  const double outside = solid_.signedDistance(cell.centre, near.distance);
  if (outside + radius <= tolerance_) return Place::kIn;
  return outside - radius > tolerance_ ? Place::kOut : Place::kBoth;
}

/// Level by level: the cells of a level are measured in parallel and divided in their order.
void TolerableSpace::divide(double finest, const RunControl& control) {
  std::vector<int> level{0};
  while (!level.empty() && cells_.size() + 8 * level.size() <= kMostCells) {
    const std::size_t first = cells_.size();
    for (const int parent : level) {
      const Cell above = cells_[static_cast<std::size_t>(parent)];
      cells_[static_cast<std::size_t>(parent)].children = static_cast<int>(cells_.size());
      for (int k = 0; k < 8; ++k) {
        Cell cell = above;
        cell.half = above.half / 2;
        cell.centre += cell.half * Eigen::Vector3d(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
        cells_.push_back(cell);
      }
    }
    std::vector<Place> places(cells_.size() - first);
    forEach((places.size() + kCellsAtOnce - 1) / kCellsAtOnce, [&](std::size_t block) {
      control.check();
      for (std::size_t i = block * kCellsAtOnce; i < std::min((block + 1) * kCellsAtOnce, places.size()); ++i)
        places[i] = measure(cells_[first + i], cells_[static_cast<std::size_t>(level[i / 8])]);
    });
    std::vector<int> next;
    for (std::size_t i = 0; i < places.size(); ++i) {
      cells_[first + i].in = places[i] == Place::kIn;
      if (places[i] == Place::kBoth && kSqrt3 * cells_[first + i].half > finest) next.push_back(static_cast<int>(first + i));
    }
    level = std::move(next);
  }
}

void TolerableSpace::findOutside(int index, const Eigen::Vector3d& p, double enough, Border& border) const {
  const Cell& cell = cells_[static_cast<std::size_t>(index)];
  if (cell.in || border.distance <= enough) return;
  const Eigen::Vector3d aside = p - cell.centre, beside = aside.cwiseMax(-cell.half).cwiseMin(cell.half);
  const double distance = (aside - beside).norm();
  if (distance >= border.distance) return;
  if (cell.children < 0) {
    border = {distance, cell.centre + beside};
    return;
  }
  // The child on the point's side first, its neighbours next, the opposite one last.
  const int nearest = (aside.x() > 0 ? 1 : 0) | (aside.y() > 0 ? 2 : 0) | (aside.z() > 0 ? 4 : 0);
  for (const int flip : {0, 1, 2, 4, 3, 5, 6, 7}) findOutside(cell.children + (nearest ^ flip), p, enough, border);
}

Eigen::Vector3d TolerableSpace::nearestOutside(const Eigen::Vector3d& p) const {
  Border border;
  findOutside(0, p, 0, border);
  return border.point;
}

/// A ball that leaves the octree meets one of the cubes at its border: these reach beyond the tolerance, so none of them lies in T.
double TolerableSpace::radius(const Eigen::Vector3d& centre) const {
  const TriangleBvh::Nearest near = solid_.surface().nearest(centre);
  const double by_distance = tolerance_ - solid_.signedDistance(centre, near.distance);
  if (((centre - cells_[0].centre).cwiseAbs().array() > cells_[0].half).any()) return by_distance;
  Border border;
  findOutside(0, centre, by_distance, border);
  return std::max(by_distance, border.distance);
}

double TolerableSpace::boundByDistance(const Sphere& sphere) const {
  return std::max(0.0, solid_.signedDistance(sphere.centre, solid_.distanceToSurface(sphere.centre)) + sphere.radius);
}

double TolerableSpace::bound(const Sphere& sphere) const {
  const double by_distance = boundByDistance(sphere);
  if (by_distance <= tolerance_) return by_distance;
  return sphere.radius <= radius(sphere.centre) ? tolerance_ : std::numeric_limits<double>::infinity();
}

}  // namespace collision_hulls
