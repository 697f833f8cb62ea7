// The decimation of the dual graph by half-edge collapses, evaluated lazily. C is monotone under merging (see concavity.h): the concavity
// of a part, or of an edge before its ends grew, is a lower bound for the edge now. E_shape is exact and costs O(1).
//
//   for every edge (v, w) of S*: push it with a lower bound of E(v, w)
//   while some edge is left, take the one of lowest E:
//     if only its bound is known: compute C(S(v, w)); push it again, or drop it for good if C > epsilon
//     else hecol(v, w): v takes over w's ancestors and edges; push v's edges with their new bounds
//
// An edge collapses only if its exact cost is no more than every other edge's lower bound, so the order is the paper's. Eager evaluation
// would compute 7 to 9 hulls per triangle.
//
// The queue takes O(T log T) for T triangles; the rest is concavities of unions (see concavity.cpp), which on usual shapes grow little
// faster than T. doc/hacd.md has the method in words, what the paper leaves open, what it costs and where it fails.
#include "collision_hulls/decompose/hacd.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>

#include "decompose/finest_tolerance.h"
#include "decompose/hacd/concavity.h"
#include "decompose/hacd/dual_graph.h"
#include "geometry/pi.h"

namespace collision_hulls {

namespace {

/// A vertex of S*: p_k with its ancestors A(p_k), which are patch.triangles.
struct Cluster {
  Patch patch;
  double perimeter = 0, area = 0;
  std::vector<int> edges;
};

/// An edge of S*. An edge whose bound exceeds epsilon stays in the graph so that edges merged with it are dropped, too.
struct Edge {
  int v = 0, w = 0;
  double border = 0;      // [m] length shared by v and w
  double bound = 0;       // [m] lower bound of C(S(v, w))
  bool measured = false;  // `bound` equals C(S(v, w)), and `points` are those of the union
  bool gone = false;      // collapsed, or merged with another edge between the same clusters
  int version = 0;        // of the queue entry that is valid
  std::vector<int> points;
  int otherEnd(int x) const { return x == v ? w : v; }
};

struct Entry {
  double cost;
  int edge, version;
  bool operator<(const Entry& o) const { return std::tie(cost, edge, version) > std::tie(o.cost, o.edge, o.version); }
};

class Decimation {
 public:
  Decimation(const TriangleMesh& mesh, double epsilon, const RunControl& control)
      : measure_(mesh), epsilon_(epsilon), diagonal_(diagonal(mesh)), alpha_(shapeWeight(epsilon, diagonal_)), control_(control) {
    makeClusters(mesh);
    makeEdges(mesh);
  }

  void run() {
    while (!queue_.empty()) {
      control_.check();
      const Entry top = queue_.top();
      queue_.pop();
      if (edges_[top.edge].gone || edges_[top.edge].version != top.version) continue;
      if (edges_[top.edge].measured)
        hecol(top.edge);
      else
        measure(top.edge);
    }
  }

  /// Goes on beyond epsilon, with the same alpha, until no edge is left.
  void runToTheEnd() {
    epsilon_ = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (edges_[e].gone) continue;
      edges_[e].measured = false;  // only as far as it took to exceed epsilon
      push(static_cast<int>(e));
    }
    run();
  }

  /// The concavities of all clusters that were merged so far, in ascending order.
  std::vector<double> merges() const {
    std::vector<double> merges = merges_;
    std::sort(merges.begin(), merges.end());
    return merges;
  }

  /// Equation (5).
  std::vector<std::vector<int>> partition() const {
    std::vector<std::vector<int>> clusters;
    for (const Cluster& cluster : clusters_) {
      if (cluster.patch.triangles.empty()) continue;
      clusters.push_back(cluster.patch.triangles);
      std::sort(clusters.back().begin(), clusters.back().end());
    }
    std::sort(clusters.begin(), clusters.end());
    return clusters;
  }

 private:
  void makeClusters(const TriangleMesh& mesh) {
    clusters_.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < clusters_.size(); ++t) {
      control_.check();
      Cluster& cluster = clusters_[t];
      const int triangle = static_cast<int>(t);
      const Eigen::Vector3d &a = mesh.corner(triangle, 0), &b = mesh.corner(triangle, 1), &c = mesh.corner(triangle, 2);
      cluster.patch = measure_.patch(triangle);
      cluster.perimeter = (b - a).norm() + (c - b).norm() + (a - c).norm();
      cluster.area = (b - a).cross(c - a).norm() / 2;
    }
    edge_to_.assign(clusters_.size(), -1);
  }

  void makeEdges(const TriangleMesh& mesh) {
    for (const DualEdge& dual : dualGraph(mesh)) {
      control_.check();
      const int e = static_cast<int>(edges_.size());
      edges_.emplace_back();
      edges_.back().v = dual.v;
      edges_.back().w = dual.w;
      edges_.back().border = dual.border;
      clusters_[dual.v].edges.push_back(e);
      clusters_[dual.w].edges.push_back(e);
      push(e);
    }
  }

  /// E(v, w), equation (4), with the current bound of C(S(v, w)). The union's perimeter and area follow from those of its parts.
  double cost(const Edge& edge) const {
    const Cluster &v = clusters_[edge.v], &w = clusters_[edge.w];
    const double shape = aspectRatio(std::max(0.0, v.perimeter + w.perimeter - 2 * edge.border), v.area + w.area);
    return decimationCost(edge.bound, diagonal_, alpha_, shape);
  }

  void push(int e) {
    ++edges_[e].version;
    if (edges_[e].bound <= epsilon_) queue_.push({cost(edges_[e]), e, edges_[e].version});
  }

  /// Equation (6) for S(v, w), equation (2).
  void measure(int e) {
    Edge& edge = edges_[e];
    ConcavityMeasure::Union s = measure_.ofUnion(clusters_[edge.v].patch, clusters_[edge.w].patch, edge.bound, epsilon_);
    edge.bound = s.value;
    edge.points = std::move(s.points);
    edge.measured = true;
    push(e);
  }

  /// Half-edge collapse: merges w into v. v is the end with more triangles, so long lists seldom move.
  void hecol(int e) {
    Edge& edge = edges_[e];
    if (clusters_[edge.v].patch.triangles.size() < clusters_[edge.w].patch.triangles.size()) std::swap(edge.v, edge.w);
    Cluster &v = clusters_[edge.v], &w = clusters_[edge.w];
    v.patch = measure_.unite(std::move(v.patch), w.patch, {edge.bound, std::move(edge.points)});  // A(v), equation (1)
    v.perimeter = std::max(0.0, v.perimeter + w.perimeter - 2 * edge.border);
    v.area += w.area;
    edge.gone = true;
    takeEdges(edge.v, edge.w);
    w = Cluster();
    for (int other : v.edges) renew(other, v.patch.concavity);
    merges_.push_back(edge.bound);
    control_.report(static_cast<double>(merges_.size()) / static_cast<double>(clusters_.size()));
  }

  /// Connects w's edges to v; two edges to the same cluster become one.
  void takeEdges(int v, int w) {
    std::vector<int> kept;
    for (int e : clusters_[v].edges) {
      if (edges_[e].gone) continue;
      kept.push_back(e);
      edge_to_[edges_[e].otherEnd(v)] = e;
    }
    for (int e : clusters_[w].edges) {
      Edge& edge = edges_[e];
      if (edge.gone) continue;
      const int twin = edge_to_[edge.otherEnd(w)];
      if (twin < 0) {
        (edge.v == w ? edge.v : edge.w) = v;
        kept.push_back(e);
      } else {
        edges_[twin].border += edge.border;
        edges_[twin].bound = std::max(edges_[twin].bound, edge.bound);
        edge.gone = true;
      }
    }
    for (int e : kept) edge_to_[edges_[e].otherEnd(v)] = -1;
    clusters_[v].edges = std::move(kept);
  }

  /// Updates an edge whose end has grown: its previous concavity and the cluster's own are lower bounds of the new one.
  void renew(int e, double concavity) {
    Edge& edge = edges_[e];
    edge.bound = std::max(edge.bound, concavity);
    edge.measured = false;
    edge.points = {};
    push(e);
  }

  ConcavityMeasure measure_;
  double epsilon_, diagonal_, alpha_;
  const RunControl& control_;
  std::vector<Cluster> clusters_;
  std::vector<Edge> edges_;
  std::vector<int> edge_to_;  // scratch, per cluster: v's edge to it; -1 if none
  std::priority_queue<Entry> queue_;
  std::vector<double> merges_;  // [m] the concavity of each merged cluster
};

void check(const TriangleMesh& mesh, double epsilon, const RunControl& control) {
  check(mesh, control);
  expectUsable(epsilon, mesh, "epsilon");
}

}  // namespace

double aspectRatio(double perimeter, double area) {
  if (!(area > 0)) return std::numeric_limits<double>::infinity();
  return perimeter * perimeter / (4 * kPi * area);
}

double decimationCost(double concavity, double diagonal, double alpha, double shape) {
  return concavity / diagonal + alpha * shape;
}

double shapeWeight(double epsilon, double diagonal) {
  return epsilon / (10 * diagonal);
}

double concavity(const TriangleMesh& mesh, const std::vector<int>& triangles) {
  const ConcavityMeasure measure(mesh);
  Patch s;
  for (int t : triangles) {
    const Patch next = measure.patch(t);
    if (s.triangles.empty()) {
      s = next;
      continue;
    }
    auto both = measure.ofUnion(s, next, 0, std::numeric_limits<double>::infinity());
    s = measure.unite(std::move(s), next, std::move(both));
  }
  return s.concavity;
}

std::vector<std::vector<int>> hacdPartition(const TriangleMesh& mesh, double epsilon, const RunControl& control) {
  check(mesh, epsilon, control);
  Decimation decimation(mesh, epsilon, control);
  decimation.run();
  control.report(1);
  return decimation.partition();
}

Segmentation hacdSegmentation(const TriangleMesh& mesh, double epsilon, const RunControl& control) {
  check(mesh, epsilon, control);
  Decimation decimation(mesh, epsilon, control);
  decimation.run();
  Segmentation result{decimation.partition(), {}};
  decimation.runToTheEnd();
  result.merges = decimation.merges();
  control.report(1);
  return result;
}

std::size_t clustersAt(const Segmentation& segmentation, double epsilon) {
  std::size_t triangles = 0;
  for (const std::vector<int>& cluster : segmentation.clusters) triangles += cluster.size();
  const auto& merges = segmentation.merges;
  return triangles - static_cast<std::size_t>(std::upper_bound(merges.begin(), merges.end(), epsilon) - merges.begin());
}

}  // namespace collision_hulls
