// Which of FCL's queries are used, and which are not:
// - Unsigned distance by libccd's GJK with a distance tolerance of 1e-9. Signed distance and penetration depth run EPA, whose asserts end
//   the process; the other solver, GST_INDEP, is wrong for some pairs, and for most at millimetre scale. Even so, if faces of two hulls
//   line up one answer in a hundred is wrong: validation counts it only if its nearest points prove it, see proved().
// - Bodies are enlarged: FCL's thresholds are absolute, and libccd's GJK reports 6 % of the overlaps of millimetre cubes (in metres) as
//   separated.
#include "query/fcl_bodies.h"

namespace collision_hulls {

std::vector<Eigen::Vector3d> enlarged(std::vector<Eigen::Vector3d> points, double factor) {
  for (Eigen::Vector3d& p : points) p *= factor;
  return points;
}

Eigen::Isometry3d enlarged(Eigen::Isometry3d pose) {
  pose.translation() *= kFclEnlarged;
  return pose;
}

std::shared_ptr<fcl::Convexd> fclConvex(const ConvexHull& hull, double factor) {
  // FCL's face array: for each face its number of vertices, followed by their indices counter-clockwise.
  const auto faces = std::make_shared<std::vector<int>>();
  for (const Triangle& t : hull.triangles) faces->insert(faces->end(), {3, t[0], t[1], t[2]});
  const auto vertices = std::make_shared<std::vector<Eigen::Vector3d>>(enlarged(hull.vertices, factor));
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(hull.triangles.size()), faces);
}

std::vector<fcl::Triangle> fclTriangles(const std::vector<Triangle>& triangles) {
  std::vector<fcl::Triangle> result;
  result.reserve(triangles.size());
  for (const Triangle& t : triangles)
    result.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2]));
  return result;
}

fcl::DistanceRequestd distanceRequest(bool nearest_points) {
  return fcl::DistanceRequestd(nearest_points, false, 0, 0, kFclDistanceTolerance, fcl::GST_LIBCCD);
}

fcl::CollisionRequestd contactRequest() {
  fcl::CollisionRequestd request(1, false);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  return request;
}

}  // namespace collision_hulls
