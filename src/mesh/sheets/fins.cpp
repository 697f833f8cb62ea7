// Starts from all patches that might be fins (open and hanging at non-manifold edges) or shared walls, and excludes those that other
// triangles need to be balanced, repeatedly for walls because excluding one may unbalance another. Then it excludes patches that are
// closed but for a small opening, and last those that hang on nothing else.
#include "mesh/sheets/fins.h"

#include <algorithm>
#include <map>

#include "base/at.h"
#include "base/looks.h"
#include "mesh/boundary.h"
#include "mesh/sheets/meetings.h"

namespace collision_hulls {
namespace {

class Fins {
 public:
  Fins(const TriangleMesh& mesh, const Edges& edges, const OrientedPatches& oriented, const std::vector<int>& surplus,
       const RunControl& control)
      : mesh_(mesh),
        edges_(edges),
        patch_(oriented.patch),
        control_(control),
        look_(control),
        meetings_(mesh, edges, oriented, look_),
        is_fin_(oriented.patches, 1),
        is_wall_(oriented.patches, 1) {
    std::vector<char> is_open(is_fin_.size(), 0), hangs(is_fin_.size(), 0);
    for (int h = 0; h < static_cast<int>(edges.twin.size()); ++h) {
      look_();
      const int twin = edges.twin[at(h)];
      if (twin >= 0) continue;
      boundary_.push_back(boundaryEdge(mesh, h, oriented.turn, patch_));
      (twin == Edges::kOpen ? is_open : hangs)[at(patch_[at(h / 3)])] = 1;
    }
    for (std::size_t t = 0; t < patch_.size(); ++t)
      if (surplus[t] != 0) is_wall_[at(patch_[t])] = 0;
    for (std::size_t p = 0; p < is_fin_.size(); ++p) {
      is_fin_[p] = is_open[p] && hangs[p];
      is_wall_[p] = is_wall_[p] && !is_open[p] && hangs[p];
    }
  }

  std::vector<char> find() {
    excludeThoseThatSurfacesNeed();
    while (excludeWallsThatSurfacesNeed()) continue;
    for (std::size_t p = 0; p < is_fin_.size(); ++p) is_fin_[p] = is_fin_[p] || is_wall_[p];
    excludeAlmostClosed();
    excludeThoseOfNothingElse();
    std::vector<char> fin(patch_.size());
    for (std::size_t t = 0; t < fin.size(); ++t) fin[t] = is_fin_[at(patch_[t])];
    return fin;
  }

 private:
  void excludeThoseThatSurfacesNeed() {
    meetings_.forEach([&](const Meetings::Halves& halves) {
      std::map<int, int> own_sum;  // by patch
      for (const MeetingHalf& half : halves) own_sum[half.patch] += half.direction;
      for (const auto& [patch, own] : own_sum)
        if (sumOfDirections(halves) != own) is_fin_[at(patch)] = 0;
    });
  }

  /// Whether it excluded any.
  bool excludeWallsThatSurfacesNeed() {
    bool any = false;
    meetings_.forEach([&](const Meetings::Halves& halves) {
      int sum = 0;
      for (const MeetingHalf& half : halves)
        if (!is_wall_[at(half.patch)]) sum += half.direction;
      for (const MeetingHalf& half : halves) {
        if (sum == 0) break;
        any = any || is_wall_[at(half.patch)];
        is_wall_[at(half.patch)] = 0;
      }
    });
    return any;
  }

  void excludeAlmostClosed() {
    std::vector<double> area(is_fin_.size(), 0);
    for (int t = 0; t < static_cast<int>(patch_.size()); ++t) look_(), area[at(patch_[at(t)])] += triangleArea(mesh_, t);
    const std::vector<Closure> closing = closures(mesh_.vertices, std::move(boundary_), area.size(), Eigen::Vector3d::Zero(), control_);
    for (std::size_t p = 0; p < area.size(); ++p)
      if (closing[p].area < kSmallOpening * area[p]) is_fin_[p] = 0;
  }

  /// Fins and walls that hang only on each other, or on themselves, are a surface.
  void excludeThoseOfNothingElse() {
    std::vector<char> holds(edges_.components, 0);  // per component: something else
    const auto component = [&](std::size_t t) { return at(edges_.component[t]); };
    for (std::size_t t = 0; t < patch_.size(); ++t)
      if (look_(); !is_fin_[at(patch_[t])]) holds[component(t)] = 1;
    for (std::size_t t = 0; t < patch_.size(); ++t)
      if (look_(); !holds[component(t)]) is_fin_[at(patch_[t])] = 0;
  }

  const TriangleMesh& mesh_;
  const Edges& edges_;
  const std::vector<int>& patch_;  // per triangle
  const RunControl& control_;
  Looks look_;
  const Meetings meetings_;
  std::vector<char> is_fin_;   // per patch: not excluded yet,
  std::vector<char> is_wall_;  // the same, as a wall shared by two solids
  std::vector<BoundaryEdge> boundary_;
};

}  // namespace

std::vector<char> findFins(const TriangleMesh& mesh, const Edges& edges, const OrientedPatches& oriented, const std::vector<int>& surplus,
                           const RunControl& control) {
  const bool any_wall = std::find(surplus.begin(), surplus.end(), 0) != surplus.end();
  if ((edges.open == 0 && !any_wall) || edges.nonmanifold == 0) return std::vector<char>(mesh.triangles.size(), 0);
  return Fins(mesh, edges, oriented, surplus, control).find();
}

}  // namespace collision_hulls
