// Corners that were moved apart by a little more than vertices are welded over, as rounding or single facets may have it, leave a surface
// in pieces. A wider weld would close fine details with them. What tells a seam is that both ends of an edge find a partner.
#include "mesh/seams.h"

#include <algorithm>
#include <utility>

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/looks.h"
#include "geometry/point_tree.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostPartners = 1000;  // open edges that are tried, for each
constexpr double kShortest = 2;              // times the tolerance: the ends of a shorter edge may be taken for each other
constexpr double kFurthest = 2;              // times the tolerance, that a vertex moves

class Seams {
 public:
  Seams(const TriangleMesh& mesh, const std::vector<Triangle>& triangles, const Edges& edges, double tolerance, const RunControl& control)
      : mesh_(mesh), tolerance_(tolerance), look_(control), joined_(mesh.vertices.size()) {
    for (int h = 0; h < static_cast<int>(edges.twin.size()); ++h) {
      look_();
      if (edges.twin[at(h)] != Edges::kOpen) continue;
      const OpenEdge edge{startOf(triangles, h), endOf(triangles, h)};
      if ((place(edge.to) - place(edge.from)).norm() > kShortest * tolerance) open_.push_back(edge);
    }
  }

  std::optional<Welding> weld(Welding welding) {
    if (open_.empty() || !joinPartners()) return std::nullopt;
    std::vector<double> moves(mesh_.vertices.size(), 0);
    std::vector<char> is_chain(mesh_.vertices.size(), 0);  // at the lowest vertex of a set that is too large
    forEachVertex(welding, [&](std::size_t v, int target) {
      moves[v] = (mesh_.vertices[v] - place(target)).norm();
      if (moves[v] > kFurthest * tolerance_) is_chain[at(target)] = 1;
    });
    bool any = false;
    forEachVertex(welding, [&](std::size_t v, int target) {
      int& representative = welding.representative[v];
      if (target == representative || is_chain[at(target)]) return;
      if (representative == static_cast<int>(v)) ++welding.joined;
      representative = target;
      welding.distance = std::max(welding.distance, moves[v]);
      any = true;
    });
    return any ? std::optional<Welding>(std::move(welding)) : std::nullopt;
  }

 private:
  struct OpenEdge {
    int from, to;
  };

  /// Calls visit(v, the vertex that is to represent v) for each vertex that triangles use.
  template <class Visit>
  void forEachVertex(const Welding& welding, const Visit& visit) {
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v)
      if (look_(); welding.representative[v] >= 0) visit(v, joined_.find(welding.representative[v]));
  }

  const Eigen::Vector3d& place(int v) const { return mesh_.vertices[at(v)]; }
  bool near(int v, int w) const { return (place(v) - place(w)).norm() <= tolerance_; }

  /// Whether there are any.
  bool joinPartners() {
    std::vector<Eigen::Vector3d> middles;
    for (const OpenEdge& edge : open_) middles.push_back((place(edge.from) + place(edge.to)) / 2);
    const PointTree tree(middles);
    bool any = false;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const OpenEdge& edge = open_[i];
      const std::optional<std::size_t> partner = tree.nearest(middles[i], tolerance_, kMostPartners, [&](std::size_t j) {
        look_();
        return near(edge.from, open_[j].to) && near(edge.to, open_[j].from);
      });
      if (!partner) continue;
      joined_.join(edge.from, open_[*partner].to);
      joined_.join(edge.to, open_[*partner].from);
      any = true;
    }
    return any;
  }

  const TriangleMesh& mesh_;
  const double tolerance_;
  Looks look_;
  DisjointSets joined_;  // of vertices
  std::vector<OpenEdge> open_;
};

}  // namespace

std::optional<Welding> weldSeams(const TriangleMesh& mesh, const std::vector<Triangle>& triangles, const Edges& edges, double tolerance,
                                 const Welding& welding, const RunControl& control) {
  if (edges.open == 0 || tolerance <= 0) return std::nullopt;
  return Seams(mesh, triangles, edges, tolerance, control).weld(welding);
}

}  // namespace collision_hulls
