// Hill climbing over the vertex graph, stored as one flat array of neighbours. On a convex surface any local maximum is global.
#include "geometry/hull_support.h"

namespace collision_hulls {

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

double leastWidth(const ConvexHull& hull) {
  const HullSupport support(hull);
  double least = std::numeric_limits<double>::infinity();
  int last = 0;
  for (const HalfSpace& face : hull.faces) {
    last = support.furthest(-face.normal, last);
    least = std::min(least, -face.distance(hull.vertices[static_cast<std::size_t>(last)]));
  }
  return least;
}

}  // namespace collision_hulls
