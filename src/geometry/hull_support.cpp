// Hill climbing over the vertex graph, stored as one flat array of neighbours. On a convex surface any local maximum is global.
//
// Why overhang() is a bound: move all faces out by the excess; then all vertices are below all of them. Let p be below all faces, and c the
// mean of the vertices. If p is beyond the triangles, the segment from c to p leaves them at a point q of some triangle, whose corners, and
// so q, are at most the slack below its face, c by the depth. From q to p the segment rises by at most the slack, from c to q by at least
// depth - slack; it is straight, so |p - q| <= |q - c| slack / (depth - slack).
#include "geometry/hull_support.h"

#include <algorithm>
#include <limits>

#include "base/looks.h"

namespace collision_hulls {
namespace {

/// The face that a triangle's corners lie least below [m].
struct BestFace {
  const HalfSpace* face = nullptr;
  double slack = std::numeric_limits<double>::infinity();
};

BestFace bestFace(const ConvexHull& hull, const Triangle& triangle, Looks& look) {
  BestFace best;
  for (const HalfSpace& face : hull.faces) {
    look();
    double slack = 0;
    for (std::size_t k = 0; k < 3 && slack < best.slack; ++k)
      slack = std::max(slack, -face.distance(hull.vertices[static_cast<std::size_t>(triangle[k])]));
    if (slack < best.slack) best = {&face, slack};
  }
  return best;
}

}  // namespace

HullSupport::HullSupport(const ConvexHull& hull) : hull_(hull), first_(hull.vertices.size() + 1), neighbours_(hull.triangles.size() * 3) {
  for (const Triangle& t : hull.triangles)
    for (const int v : t) ++first_[static_cast<std::size_t>(v) + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const Triangle& t : hull.triangles)
    for (std::size_t k = 0; k < 3; ++k) neighbours_[next[static_cast<std::size_t>(t[k])]++] = t[(k + 1) % 3];
}

int HullSupport::furthest(const Eigen::Vector3d& direction, int start) const {
  int best = start;
  double most = direction.dot(hull_.vertices[static_cast<std::size_t>(best)]);
  for (int from = -1; from != best;) {
    from = best;
    for (std::size_t i = first_[static_cast<std::size_t>(from)]; i < first_[static_cast<std::size_t>(from) + 1]; ++i) {
      const double reach = direction.dot(hull_.vertices[static_cast<std::size_t>(neighbours_[i])]);
      if (reach > most) most = reach, best = neighbours_[i];
    }
  }
  return best;
}

double leastWidth(const ConvexHull& hull, const RunControl& control) {
  Looks look(control);
  double least = std::numeric_limits<double>::infinity();
  for (const HalfSpace& face : hull.faces) {
    double lowest = 0;
    for (const Eigen::Vector3d& v : hull.vertices) look(), lowest = std::min(lowest, face.distance(v));
    least = std::min(least, -lowest);
  }
  return least;
}

Eigen::Vector3d meanOfVertices(const ConvexHull& hull) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : hull.vertices) mean += v / static_cast<double>(hull.vertices.size());
  return mean;
}

double overhang(const ConvexHull& hull, const RunControl& control) {
  if (hull.vertices.empty()) return 0;
  Looks look(control);
  const Eigen::Vector3d c = meanOfVertices(hull);
  double radius = 0, excess = 0;
  for (const Eigen::Vector3d& v : hull.vertices) {
    control.check();
    radius = std::max(radius, (v - c).norm());
    excess = std::max(excess, planeDistance(hull, v));
  }
  double most = 0;
  for (const Triangle& t : hull.triangles) {
    const BestFace best = bestFace(hull, t, look);
    const double slack = best.slack + excess, depth = excess - best.face->distance(c);
    most = std::max(most, depth > slack ? slack / (depth - slack) : 2);
  }
  return radius * std::min(most, 2.0);  // no two points are further apart
}

double wayInto(const ConvexHull& hull, const Eigen::Vector3d& vertex, double depth) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto isNear = [&](const HalfSpace& face) { return -face.distance(vertex) < 2 * depth; };
  Eigen::Vector3d inward = Eigen::Vector3d::Zero();
  for (const HalfSpace& face : hull.faces)
    if (isNear(face)) inward -= face.normal;
  inward.normalize();
  double way = 0;
  for (const HalfSpace& face : hull.faces) {
    if (!isNear(face)) continue;
    const double rise = -face.normal.dot(inward);
    if (!(rise > 0)) return kNone;
    way = std::max(way, (depth + face.distance(vertex)) / rise);
  }
  const auto isDeep = [&](const HalfSpace& face) { return isNear(face) || -face.distance(vertex + way * inward) >= depth; };
  return std::all_of(hull.faces.begin(), hull.faces.end(), isDeep) ? way : kNone;
}

}  // namespace collision_hulls
