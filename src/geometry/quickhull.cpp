// Barber, Dobkin & Huhdanpaa, "The quickhull algorithm for convex hulls" (1996), for triangles in three dimensions.
//
//   begin with a tetrahedron; give each point outside to a face that sees it
//   while some face has points: take its furthest point p
//     the faces that p sees are one patch; its border is the horizon
//     replace the patch by triangles from the horizon's edges to p, and share out the patch's points anew
//
// Faces are not merged as Qhull does: rounding is detected instead, and the caller falls back.
#include "geometry/quickhull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace collision_hulls {

namespace {

constexpr double kVisible = 1e-12;       // share of the extent that a point must lie beyond a face to be seen by it
constexpr double kSliver = 1e-9;         // least height of a face over its longest side, likewise
constexpr std::size_t kMostFaces = 100;  // made in all, per point; more means that rounding goes round in circles
constexpr double kDent = 1e-10;          // most that a vertex may lie beyond a neighbouring face
constexpr double kFlat = 1e-11;          // an edge whose faces' far corners lie no further from each other's planes is none

struct Face {
  std::array<int, 3> vertex{};
  std::array<int, 3> neighbour{-1, -1, -1};  // across the edge from vertex[k] to vertex[(k + 1) % 3]
  Eigen::Vector3d normal;
  double offset = 0;
  int first_point = -1;  // list of points that this face is responsible for
  int furthest = -1;
  double furthest_distance = 0;
  bool alive = true;
  int seen_by = -1;  // the last point that visited this face
};

struct HorizonEdge {
  int face, edge;  // the face beyond the horizon, and which of its edges
  int from, to;    // as seen from within the patch
};

class Builder {
 public:
  explicit Builder(const std::vector<Eigen::Vector3d>& points) : points_(points), next_(points.size(), -1), freed_by_(points.size(), -1) {}

  std::optional<ConvexHull> build() {
    if (!tetrahedron()) return std::nullopt;
    for (std::size_t k = 0; k < faces_.size(); ++k)
      while (faces_[k].alive && faces_[k].furthest >= 0)
        if (faces_.size() > kMostFaces * points_.size() || !add(static_cast<int>(k))) return std::nullopt;
    return result();
  }

  /// The vertices that at least three sharp edges meet at; the others lie within a face or along an edge, up to rounding.
  struct Vertices {
    std::vector<Eigen::Vector3d> corners, others;
  };
  Vertices vertices() const {
    std::vector<int> sharp(points_.size(), -1);  // -1: no vertex
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (std::size_t k = 0; k < 3 && faces_[i].alive; ++k) {
        int& edges = sharp[static_cast<std::size_t>(faces_[i].vertex[k])];
        edges = std::max(edges, 0) + isSharp(static_cast<int>(i), k);
      }
    Vertices result;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (sharp[i] >= 0) (sharp[i] >= 3 ? result.corners : result.others).push_back(points_[i]);
    return result;
  }

  double extent() const { return extent_; }

 private:
  Face& face(int i) { return faces_[static_cast<std::size_t>(i)]; }
  const Face& face(int i) const { return faces_[static_cast<std::size_t>(i)]; }
  const Eigen::Vector3d& point(int i) const { return points_[static_cast<std::size_t>(i)]; }

  template <class F>
  int furthest(F f) const {
    int best = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double d = f(points_[i]);
      if (d > most) most = d, best = static_cast<int>(i);
    }
    return best;
  }

  bool tetrahedron() {
    if (points_.size() < 4) return false;
    int a = furthest([](const auto& p) { return p.x(); });
    int b = furthest([&](const auto& p) { return (p - point(a)).squaredNorm(); });
    a = furthest([&](const auto& p) { return (p - point(b)).squaredNorm(); });
    extent_ = (point(b) - point(a)).norm();
    const Eigen::Vector3d x = (point(b) - point(a)) / extent_;
    int c = furthest([&](const auto& p) { return (p - point(a)).cross(x).squaredNorm(); });
    const Eigen::Vector3d normal = (point(b) - point(a)).cross(point(c) - point(a)).normalized();
    int d = furthest([&](const auto& p) { return std::abs(normal.dot(p - point(a))); });
    if (!(std::abs(normal.dot(point(d) - point(a))) > kSliver * extent_)) return false;
    if (normal.dot(point(d) - point(a)) > 0) std::swap(b, c);
    if (!makeFace({a, b, c}) || !makeFace({b, a, d}) || !makeFace({c, b, d}) || !makeFace({a, c, d})) return false;
    faces_[0].neighbour = {1, 2, 3};
    faces_[1].neighbour = {0, 3, 2};
    faces_[2].neighbour = {0, 1, 3};
    faces_[3].neighbour = {0, 2, 1};
    for (std::size_t i = 0; i < points_.size(); ++i) assign(static_cast<int>(i), 0);
    return true;
  }

  bool makeFace(const std::array<int, 3>& v) {
    Face f;
    f.vertex = v;
    const Eigen::Vector3d &a = point(v[0]), &b = point(v[1]), &c = point(v[2]);
    const Eigen::Vector3d ab = b - a, ac = c - a, cross = ab.cross(ac);
    const double twice_area = cross.norm();
    const double longest = std::sqrt(std::max({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()}));
    if (!(twice_area > kSliver * extent_ * longest)) return false;
    f.normal = cross / twice_area;
    f.offset = std::max({f.normal.dot(a), f.normal.dot(b), f.normal.dot(c)});
    faces_.push_back(f);
    return true;
  }

  /// Gives a point to the first face from `from` on that sees it; points within all faces are dropped.
  void assign(int p, std::size_t from) {
    for (std::size_t k = from; k < faces_.size(); ++k) {
      Face& f = faces_[k];
      const double d = f.normal.dot(point(p)) - f.offset;
      if (!(d > kVisible * extent_)) continue;
      next_[static_cast<std::size_t>(p)] = f.first_point;
      f.first_point = p;
      if (d > f.furthest_distance) f.furthest_distance = d, f.furthest = p;
      return;
    }
  }

  double height(int p, int f) { return face(f).normal.dot(point(p)) - face(f).offset; }

  /// Whether p and an edge are so nearly in line that a face over them would be a sliver.
  bool isSliver(int p, int from, int to) const {
    const Eigen::Vector3d edge = point(to) - point(from), way = point(p) - point(from);
    const double longest = std::sqrt(std::max({edge.squaredNorm(), way.squaredNorm(), (way - edge).squaredNorm()}));
    return !(edge.cross(way).norm() > 2 * kSliver * extent_ * longest);
  }

  /// A face that p lies level with counts as seen where p is in line with the edge that leads to it: it is spanned anew from p.
  bool sees(int p, int f, int from, int to) {
    const double h = height(p, f);
    return h > kVisible * extent_ || (h > -kVisible * extent_ && isSliver(p, from, to));
  }

  /// Walks the patch that p sees, depth first around each face, so that the horizon comes out in order.
  void findHorizon(int p, int start) {
    struct Step {
      int face, edge, left;
    };
    patch_.assign(1, start);
    horizon_.clear();
    face(start).seen_by = p;
    std::vector<Step> stack{{start, 0, 3}};
    while (!stack.empty()) {
      Step& step = stack.back();
      if (step.left == 0) {
        stack.pop_back();
        continue;
      }
      const int f = step.face, e = step.edge;
      step.edge = (e + 1) % 3;
      --step.left;
      const int n = face(f).neighbour[static_cast<std::size_t>(e)];
      if (face(n).seen_by == p) continue;
      const int from = face(f).vertex[static_cast<std::size_t>(e)], to = face(f).vertex[static_cast<std::size_t>((e + 1) % 3)];
      if (sees(p, n, from, to)) {
        face(n).seen_by = p;
        patch_.push_back(n);
        const auto& back = face(n).neighbour;
        const int entry = back[0] == f ? 0 : back[1] == f ? 1 : 2;
        stack.push_back({n, (entry + 1) % 3, 2});
      } else {
        const auto& back = face(n).neighbour;
        const int across = back[0] == f ? 0 : back[1] == f ? 1 : 2;
        horizon_.push_back({n, across, from, to});
      }
    }
  }

  bool onHorizon(int v) const {
    return std::any_of(horizon_.begin(), horizon_.end(), [&](const HorizonEdge& e) { return e.from == v; });
  }

  bool add(int start) {
    const int p = face(start).furthest;
    findHorizon(p, start);
    const std::size_t n = horizon_.size(), first = faces_.size();
    if (n < 3) return false;
    for (std::size_t i = 0; i < n; ++i)
      if (horizon_[i].to != horizon_[(i + 1) % n].from || !makeFace({horizon_[i].from, horizon_[i].to, p})) return false;
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = [&](std::size_t k) { return static_cast<int>(first + k % n); };
      faces_[first + i].neighbour = {horizon_[i].face, at(i + 1), at(i + n - 1)};
      face(horizon_[i].face).neighbour[static_cast<std::size_t>(horizon_[i].edge)] = at(i);
    }
    for (int f : patch_) {
      face(f).alive = false;
      for (int v : face(f).vertex)
        if (!onHorizon(v) && freed_by_[static_cast<std::size_t>(v)] != p) {
          freed_by_[static_cast<std::size_t>(v)] = p;  // several faces of the patch share it, and it may be in one list only
          assign(v, first);                            // once level faces are gone it may stick out
        }
      for (int q = face(f).first_point; q >= 0;) {
        const int following = next_[static_cast<std::size_t>(q)];
        if (q != p) assign(q, first);
        q = following;
      }
    }
    return true;
  }

  /// How far beneath face f the vertices of its neighbour n lie.
  double drop(const Face& f, const Face& n) const {
    double least = 0;
    for (int v : n.vertex) least = std::min(least, f.normal.dot(point(v)) - f.offset);
    return -least;
  }

  bool isSharp(int i, std::size_t edge) const {
    const Face &f = face(i), &n = face(f.neighbour[edge]);
    return std::min(drop(f, n), drop(n, f)) > kFlat * extent_;
  }

  /// Every point was dropped because some faces did not see it; whether none does is asked once more of all faces.
  bool holdsAll(const ConvexHull& hull) const {
    Eigen::Matrix<double, Eigen::Dynamic, 3> normals(static_cast<Eigen::Index>(hull.faces.size()), 3);
    Eigen::VectorXd offsets(normals.rows());
    for (Eigen::Index i = 0; i < normals.rows(); ++i) {
      normals.row(i) = hull.faces[static_cast<std::size_t>(i)].normal.transpose();
      offsets[i] = hull.faces[static_cast<std::size_t>(i)].offset + kDent * extent_;
    }
    Eigen::VectorXd reach(normals.rows());
    for (const Eigen::Vector3d& p : points_) {
      reach.noalias() = normals * p;
      if ((reach - offsets).maxCoeff() > 0) return false;
    }
    return true;
  }

  std::optional<ConvexHull> result() {
    ConvexHull hull;
    std::vector<int> vertex(points_.size(), -1);
    for (const Face& f : faces_) {
      if (!f.alive) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const Face& n = face(f.neighbour[k]);
        for (int v : n.vertex)
          if (f.normal.dot(point(v)) - f.offset > kDent * extent_) return std::nullopt;
      }
      Triangle t{};
      for (std::size_t k = 0; k < 3; ++k) {
        int& v = vertex[static_cast<std::size_t>(f.vertex[k])];
        if (v < 0) {
          v = static_cast<int>(hull.vertices.size());
          hull.vertices.push_back(point(f.vertex[k]));
        }
        t[k] = v;
      }
      hull.triangles.push_back(t);
      hull.faces.push_back({f.normal, f.offset + kVisible * extent_});
    }
    if (!holdsAll(hull)) return std::nullopt;
    return hull;
  }

  const std::vector<Eigen::Vector3d>& points_;
  std::vector<int> next_;
  std::vector<int> freed_by_;  // the last point that took a vertex's faces away
  std::vector<Face> faces_;
  std::vector<int> patch_;
  std::vector<HorizonEdge> horizon_;
  double extent_ = 0;
};

}  // namespace

std::optional<ConvexHull> quickhull(const std::vector<Eigen::Vector3d>& points) {
  Builder builder(points);
  std::optional<ConvexHull> hull = builder.build();
  if (!hull) return hull;
  // Of points in one plane quickhull may take some that are no corners. A second run leaves them out.
  const Builder::Vertices vertices = builder.vertices();
  if (vertices.others.empty()) return hull;
  std::optional<ConvexHull> lean = Builder(vertices.corners).build();
  if (!lean) return hull;
  double beyond = 0;
  for (const Eigen::Vector3d& p : vertices.others) beyond = std::max(beyond, planeDistance(*lean, p));
  if (beyond > kDent * builder.extent()) return hull;
  for (HalfSpace& face : lean->faces) face.offset += beyond + kVisible * builder.extent();  // the first run's own margin
  return lean;
}

}  // namespace collision_hulls
