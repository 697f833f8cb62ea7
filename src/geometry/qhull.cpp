// Qhull (Barber, Dobkin & Huhdanpaa 1996) in its reentrant C form. Tried first with merged facets, then with joggled input; the result
// counts only if it is a closed 2-manifold.
#include "geometry/qhull.h"

#include <algorithm>
#include <cstdio>
#include <unordered_map>

#include "base/left_behind.h"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace collision_hulls {

namespace {

/// Owns one run of Qhull and its memory.
class QhullRun {
 public:
  QhullRun(const std::vector<Eigen::Vector3d>& points, const char* command) : coordinates_(points.size() * 3) {
    for (std::size_t i = 0; i < points.size(); ++i)
      for (int k = 0; k < 3; ++k) coordinates_[3 * i + static_cast<std::size_t>(k)] = points[i][k];
    static FILE* const nowhere = std::fopen("/dev/null", "w");
    qh_zero(&qh_, nowhere);
    ok_ = qh_new_qhull(&qh_, 3, static_cast<int>(points.size()), coordinates_.data(), False, const_cast<char*>(command), nullptr,
                       nowhere) == 0;
  }
  ~QhullRun() {
    int open = 0, total = 0;
    qh_freeqhull(&qh_, !qh_ALL);
    qh_memfreeshort(&qh_, &open, &total);
  }
  QhullRun(const QhullRun&) = delete;
  QhullRun& operator=(const QhullRun&) = delete;

  bool ok() const { return ok_; }

  ConvexHull hull(const std::vector<Eigen::Vector3d>& points) {
    ConvexHull result;
    std::unordered_map<int, int> vertex_of_point;
    qhT* qh = &qh_;
    // Points merged into a face may lie this far beyond it.
    const double outside = std::max(0.0, static_cast<double>(qh->max_outside));
    facetT* facet = nullptr;
    FORALLfacets {
      vertexT *vertex, **vertexp;
      Triangle t{};
      std::size_t k = 0;
      FOREACHvertex_(facet->vertices) {
        if (k == 3) return {};
        const int id = qh_pointid(qh, vertex->point);
        const auto [it, fresh] = vertex_of_point.try_emplace(id, static_cast<int>(result.vertices.size()));
        if (fresh) result.vertices.push_back(points[static_cast<std::size_t>(id)]);
        t[k++] = it->second;
      }
      if (k != 3) return {};
      if (!facet->toporient != !qh_ORIENTclock) std::swap(t[1], t[2]);
      result.triangles.push_back(t);
      result.faces.push_back({Eigen::Vector3d(facet->normal[0], facet->normal[1], facet->normal[2]), outside - facet->offset});
    }
    return result;
  }

 private:
  std::vector<coordT> coordinates_;
  qhT qh_{};
  bool ok_ = false;
};

/// Closed: each directed edge has exactly one opposite.
bool isClosed(const ConvexHull& hull) {
  std::unordered_map<long long, int> edges;
  const auto key = [](int a, int b) { return (static_cast<long long>(a) << 32) | b; };
  for (const Triangle& t : hull.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[key(t[k], t[(k + 1) % 3])];
  for (const Triangle& t : hull.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto forward = edges.find(key(t[k], t[(k + 1) % 3])), back = edges.find(key(t[(k + 1) % 3], t[k]));
      if (forward->second != 1 || back == edges.end() || back->second != 1) return false;
    }
  return !hull.triangles.empty() && hull.triangles.size() + 4 == 2 * hull.vertices.size();
}

std::optional<ConvexHull> hullOf(const std::vector<Eigen::Vector3d>& points, const RunControl& control) {
  // Qt triangulates merged facets. QJ joggles the input: slower and less exact, but it never gives up on hard sets.
  for (const char* command : {"qhull Qt Pp", "qhull QJ Pp"}) {
    control.check();
    QhullRun run(points, command);
    if (!run.ok()) continue;
    ConvexHull hull = run.hull(points);
    if (isClosed(hull)) return hull;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ConvexHull> qhull(const std::vector<Eigen::Vector3d>& points, const RunControl& control) {
  constexpr std::size_t kMany = 20'000;  // points for which Qhull takes a tenth of a second or more
  if (points.size() < kMany) return hullOf(points, control);
  return orLeftBehind([points](const RunControl& control) { return hullOf(points, control); }, control);
}

}  // namespace collision_hulls
