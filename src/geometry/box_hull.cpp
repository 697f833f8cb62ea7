// The corners are counted with x first, on which the order of the hull's vertices and triangles depends.
#include "geometry/box_hull.h"

namespace collision_hulls {

ConvexHull hullOfBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back((i & 1 ? high : low).x(), (i & 2 ? high : low).y(), (i & 4 ? high : low).z());
  return convexHull(corners);
}

ConvexHull hullOfBox(const Eigen::Vector3d& sides) {
  return hullOfBox(-sides / 2, sides / 2);
}

}  // namespace collision_hulls
