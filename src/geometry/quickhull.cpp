// Barber, Dobkin & Huhdanpaa, "The quickhull algorithm for convex hulls" (1996), for triangles in three dimensions.
//
//   start with a tetrahedron; for large sets, add the extreme points in some directions
//   give each outside point to a face that sees it
//   while some face has points: take its furthest point p
//     the faces that p sees form a patch; the patch's border is the horizon
//     replace the patch by triangles from the horizon's edges to p, and redistribute the patch's points
//
// O(n log n) under the paper's balance assumptions. Unlike Qhull, it does not merge faces: it detects rounding trouble, and the caller
// falls back.
#include "geometry/quickhull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/looks.h"
#include "geometry/point_tree.h"

namespace collision_hulls {

namespace {

constexpr double kVisible = 1e-12;  // share of the extent that a point must lie beyond a face to see it
constexpr double kSliver = 1e-9;    // least height of a face over its longest side, as a share of the extent
constexpr std::size_t kMany = 500;  // sets larger than this start with extreme points
constexpr int kExtremes = 26;
constexpr double kWorthwhile = 1e-3, kGoldenAngle = 2.399963229728653;
constexpr std::size_t kUsualFaces = 4;  // created in all, per point, if most points are corners
constexpr std::size_t kMostReserved = 10000;
constexpr std::size_t kFewFaces = 100'000;  // that replaced faces may stay among
constexpr std::size_t kMostFaces = 100;     // created in all, per point; more means that rounding runs in circles
constexpr double kDent = 1e-10;             // furthest that a vertex may lie beyond a neighbouring face, as a share of the extent
constexpr double kSuspicious = 2e-12;       // kVisible does not explain dents deeper than this: compare all vertices with all faces
constexpr double kFlat = 1e-11;  // an edge is flat if its faces' opposite corners lie no further than this from each other's planes

struct Face {
  std::array<int, 3> vertex{};
  std::array<int, 3> neighbour{-1, -1, -1};  // across the edge from vertex[k] to vertex[(k + 1) % 3]
  Eigen::Vector3d normal;
  double offset = 0;
  int first_point = -1;  // head of the list of points assigned to this face
  int furthest = -1;
  double furthest_distance = 0;
  int seen_by = -1;      // the last point whose walk reached this face
  int replaced_by = -1;  // a face created in its place; -1: still part of the hull
};

struct HorizonEdge {
  int face, edge;  // the face beyond the horizon, and which of its edges is on it
  int from, to;    // as seen from within the patch
};

class Builder {
 public:
  Builder(const std::vector<Eigen::Vector3d>& points, const RunControl& control)
      : points_(points),
        control_(control),
        look_(control),
        next_(points.size(), -1),
        dropped_(points.size(), -1),
        settled_by_(points.size(), -1) {
    faces_.reserve(std::min(kUsualFaces * points.size(), kMostReserved));
  }

  /// `sources`: see quickhull().
  std::optional<ConvexHull> build(std::vector<int>& sources) {
    if (!tetrahedron() || (points_.size() > kMany && !addExtremes())) return std::nullopt;
    shareOut();
    control_.check();
    for (std::size_t done = 0; done < faces_.size(); done = isCrowded() ? withoutReplaced(done + 1) : done + 1)
      while (isThere(faces_[done]) && faces_[done].furthest >= 0)
        if (created_ > kMostFaces * points_.size() || !add(faces_[done].furthest, static_cast<int>(done))) return std::nullopt;
    return result(sources);
  }

  /// The vertices where at least three sharp edges meet, and the others, which lie within a face or along an edge up to rounding.
  struct Vertices {
    std::vector<int> corners, others;
  };
  Vertices vertices() const {
    std::vector<int> sharp(points_.size(), -1);  // number of sharp edges; -1: not a vertex
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (std::size_t k = 0; k < 3 && isThere(faces_[i]); ++k) {
        int& edges = sharp[static_cast<std::size_t>(faces_[i].vertex[k])];
        edges = std::max(edges, 0) + isSharp(static_cast<int>(i), k);
      }
    Vertices result;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (sharp[i] >= 0) (sharp[i] >= 3 ? result.corners : result.others).push_back(static_cast<int>(i));
    return result;
  }

  double extent() const { return extent_; }

 private:
  Face& face(int i) { return faces_[static_cast<std::size_t>(i)]; }
  const Face& face(int i) const { return faces_[static_cast<std::size_t>(i)]; }
  const Eigen::Vector3d& point(int i) const { return points_[static_cast<std::size_t>(i)]; }
  static bool isThere(const Face& f) { return f.replaced_by < 0; }

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
    middle_ = (point(a) + point(b) + point(c) + point(d)) / 4;
    return true;
  }

  /// Adds the extreme points in directions that CAD models seldom share; few points then stay outside for long.
  bool addExtremes() {
    for (int i = 0; i < kExtremes; ++i) {
      if (points_.size() > kItemsBetweenLooks) control_.check();
      const double z = (2 * i + 1.0) / kExtremes - 1, across = std::sqrt(1 - z * z), turn = i * kGoldenAngle;
      const Eigen::Vector3d direction(across * std::cos(turn), across * std::sin(turn), z);
      const int p = furthest([&](const auto&q) { return direction.dot(q); }), f = pierced(point(p), static_cast<int>(faces_.size()) - 1);
      if (f >= 0 && height(p, f) > kWorthwhile * extent_ && !add(p, f)) return false;
    }
    return true;
  }

  /// Gives each point to the face it projects to from the middle, if it lies beyond that face.
  void shareOut() {
    for (int p = 0, f = present(0); p < static_cast<int>(points_.size()); ++p) {
      const int before = pierced(point(p), f);
      if (before < 0)
        assign(p, 0, faces_.size());
      else
        assign(p, static_cast<std::size_t>(before), static_cast<std::size_t>(f = before) + 1);
    }
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
    if (faces_.size() == faces_.capacity()) makeRoom();
    faces_.push_back(f);
    ++created_;
    return true;
  }

  /// Bit by bit: the kernel takes its time over much memory.
  void makeRoom() {
    std::vector<Face> larger;
    larger.reserve(2 * faces_.size() + 1);
    for (const Face& each : faces_) look_(), larger.push_back(each);
    faces_ = std::move(larger);
  }

  /// Whether memory is worth the time that it takes to forget replaced faces.
  bool isCrowded() const { return faces_.size() > kFewFaces && replaced_ > faces_.size() / 3; }

  /// Forgets the faces that have been replaced; the others keep their order. Returns how many of the first `count` are left.
  std::size_t withoutReplaced(std::size_t count) {
    for (int& first : dropped_)
      if (look_(); first >= 0) first = present(first);
    std::vector<int> now(faces_.size(), -1);
    int left = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (look_(); isThere(faces_[i])) now[i] = left++;
    const auto moved = [&](int f) { return now[static_cast<std::size_t>(f)]; };
    std::size_t result = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      look_();
      if (now[i] < 0) continue;
      Face& f = faces_[static_cast<std::size_t>(now[i])] = faces_[i];
      for (int& n : f.neighbour) n = moved(n);
      if (i < count) ++result;
    }
    for (int& first : dropped_)
      if (first >= 0) first = moved(first);
    faces_.resize(static_cast<std::size_t>(left));
    replaced_ = 0;
    return result;
  }

  /// Gives a point to the first face in [from, to) that it sees; drops it if it sees none.
  void assign(int p, std::size_t from, std::size_t to) {
    look_();
    for (std::size_t k = from; k < to; ++k) {
      Face& f = faces_[k];
      const double d = f.normal.dot(point(p)) - f.offset;
      if (!(d > kVisible * extent_) || !isThere(f)) continue;
      next_[static_cast<std::size_t>(p)] = f.first_point;
      f.first_point = p;
      if (d > f.furthest_distance) f.furthest_distance = d, f.furthest = p;
      return;
    }
    dropped_[static_cast<std::size_t>(p)] = static_cast<int>(from);
  }

  double height(int p, int f) const { return face(f).normal.dot(point(p)) - face(f).offset; }

  /// Whether p is so nearly collinear with an edge that the face over them would be a sliver.
  bool isSliver(int p, int from, int to) const {
    const Eigen::Vector3d edge = point(to) - point(from), way = point(p) - point(from);
    const double longest = std::sqrt(std::max({edge.squaredNorm(), way.squaredNorm(), (way - edge).squaredNorm()}));
    return !(edge.cross(way).norm() > 2 * kSliver * extent_ * longest);
  }

  /// p counts as seeing a face level with it if p is collinear with the edge leading to that face: the face is then spanned anew from p.
  bool sees(int p, int f, int from, int to) {
    const double h = height(p, f);
    return h > kVisible * extent_ || (h > -kVisible * extent_ && isSliver(p, from, to));
  }

  /// Walks the patch that p sees, depth first around each face; this visits the horizon's edges in order.
  void findHorizon(int p, int start) {
    patch_.assign(1, start);
    horizon_.clear();
    face(start).seen_by = p;
    steps_.assign(1, {start, 0, 3});
    while (!steps_.empty()) {
      Step& step = steps_.back();
      if (step.left == 0) {
        steps_.pop_back();
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
        steps_.push_back({n, (entry + 1) % 3, 2});
      } else {
        const auto& back = face(n).neighbour;
        const int across = back[0] == f ? 0 : back[1] == f ? 1 : 2;
        horizon_.push_back({n, across, from, to});
      }
    }
  }

  /// Adds a point that lies beyond face `start`; false if rounding gets in the way.
  bool add(int p, int start) {
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
    replaced_ += patch_.size();
    for (const HorizonEdge& e : horizon_) settled_by_[static_cast<std::size_t>(e.from)] = p;
    for (int f : patch_) {
      face(f).replaced_by = static_cast<int>(first);
      for (int v : face(f).vertex)
        if (settled_by_[static_cast<std::size_t>(v)] != p) {
          settled_by_[static_cast<std::size_t>(v)] = p;  // several faces of the patch may share it, but it may be in one list only
          assign(v, first, faces_.size());               // without the level faces it may stick out
        }
      for (int q = face(f).first_point; q >= 0;) {
        const int following = next_[static_cast<std::size_t>(q)];
        if (q != p) assign(q, first, faces_.size());
        q = following;
      }
    }
    return true;
  }

  /// How far below face f the vertices of its neighbour n reach.
  double drop(const Face& f, const Face& n) const {
    double least = 0;
    for (int v : n.vertex) least = std::min(least, f.normal.dot(point(v)) - f.offset);
    return -least;
  }

  bool isSharp(int i, std::size_t edge) const {
    const Face &f = face(i), &n = face(f.neighbour[edge]);
    return std::min(drop(f, n), drop(n, f)) > kFlat * extent_;
  }

  /// The face that the ray from the middle through p pierces. Walks across edges that p lies beyond; -1 if rounding leads the walk in
  /// circles.
  int pierced(const Eigen::Vector3d& p, int start) const {
    const Eigen::Vector3d way = p - middle_;
    int f = start;
    for (std::size_t steps = 0; steps < faces_.size(); ++steps) {
      int across = -1;
      for (std::size_t k = 0; k < 3 && across < 0; ++k)
        if (isBeyond(way, face(f).vertex[k], face(f).vertex[(k + 1) % 3])) across = face(f).neighbour[k];
      if (across < 0) return f;
      f = across;
    }
    return -1;
  }

  /// Whether a ray from the middle passes an edge on the right. Both faces of an edge get the same answer.
  bool isBeyond(const Eigen::Vector3d& way, int from, int to) const {
    const Eigen::Vector3d a = point(std::min(from, to)) - middle_, b = point(std::max(from, to)) - middle_;
    const double side = a.cross(b).dot(way);
    return from < to ? side < 0 : side > 0;
  }

  /// The face that now stands in place of f.
  int present(int f) const {
    while (!isThere(face(f))) f = face(f).replaced_by;
    return f;
  }

  /// How far p lies beyond the hull.
  double beyond(const Eigen::Vector3d& p, int start) const {
    const int f = pierced(p, start);
    if (f >= 0) return face(f).normal.dot(p) - face(f).offset;
    double most = -std::numeric_limits<double>::infinity();
    for (const Face& each : faces_)
      if (isThere(each)) most = std::max(most, each.normal.dot(p) - each.offset);
    return most;
  }

  /// Whether all dropped points are inside. Being below some faces is no proof: each must lie between the middle and the face it projects
  /// to, hence in the convex hull of four points that all faces hold.
  bool holdsAll(const std::vector<int>& vertex) {
    for (std::size_t p = 0; p < points_.size(); ++p)
      if (look_(); vertex[p] < 0 && dropped_[p] >= 0 && beyond(points_[p], present(dropped_[p])) > kDent * extent_) return false;
    return true;
  }

  /// Whether every face holds every vertex.
  bool holdsVertices(const ConvexHull& hull) const {
    const PointTree vertices(hull.vertices);
    const auto cuts = [&](const HalfSpace& face) { return control_.check(), vertices.anyBeyond(face, kDent * extent_); };
    return std::none_of(hull.faces.begin(), hull.faces.end(), cuts);
  }

  /// The furthest distance of a vertex beyond a neighbouring face.
  double deepestDent() const {
    double most = 0;
    for (const Face& f : faces_) {
      if (!isThere(f)) continue;
      for (int n : f.neighbour)
        for (int v : face(n).vertex)
          if (v != f.vertex[0] && v != f.vertex[1] && v != f.vertex[2]) most = std::max(most, f.normal.dot(point(v)) - f.offset);
    }
    return most;
  }

  /// Whether some face looks inward: rounding may fold a face back onto others in its plane, and no dent reveals that.
  bool isFolded() const {
    return std::any_of(faces_.begin(), faces_.end(), [&](const Face& f) { return isThere(f) && f.normal.dot(middle_) >= f.offset; });
  }

  /// A surface that is nowhere folded and whose edges are all convex up to rounding is convex, so its faces hold its vertices.
  std::optional<ConvexHull> result(std::vector<int>& sources) {
    const double dent = deepestDent();
    if (dent > kDent * extent_ || isFolded()) return std::nullopt;
    ConvexHull hull;
    sources.clear();
    std::vector<int> vertex(points_.size(), -1);
    const auto count = static_cast<std::size_t>(std::count_if(faces_.begin(), faces_.end(), isThere));
    hull.vertices.reserve(count / 2 + 2);
    hull.triangles.reserve(count);
    hull.faces.reserve(count);
    for (const Face& f : faces_) {
      if (!isThere(f)) continue;
      Triangle t{};
      for (std::size_t k = 0; k < 3; ++k) {
        int& v = vertex[static_cast<std::size_t>(f.vertex[k])];
        if (v < 0) {
          v = static_cast<int>(hull.vertices.size());
          hull.vertices.push_back(point(f.vertex[k]));
          sources.push_back(f.vertex[k]);
        }
        t[k] = v;
      }
      hull.triangles.push_back(t);
      hull.faces.push_back({f.normal, f.offset + kVisible * extent_});
    }
    if (!holdsAll(vertex) || (dent > kSuspicious * extent_ && !holdsVertices(hull))) return std::nullopt;
    return hull;
  }

  const std::vector<Eigen::Vector3d>& points_;
  const RunControl& control_;
  Looks look_;
  std::vector<int> next_;
  std::vector<int> dropped_;     // per point: the first of the faces created when it was last dropped; -1: never dropped
  std::vector<int> settled_by_;  // per vertex: the last point that replaced some of its faces
  std::vector<Face> faces_;
  std::size_t created_ = 0;   // faces, in all
  std::size_t replaced_ = 0;  // of faces_
  struct Step {               // of the walk around a patch
    int face, edge, left;
  };
  std::vector<Step> steps_;
  std::vector<int> patch_;
  std::vector<HorizonEdge> horizon_;
  double extent_ = 0;
  Eigen::Vector3d middle_;  // centroid of the first tetrahedron
};

}  // namespace

std::optional<ConvexHull> quickhull(const std::vector<Eigen::Vector3d>& points, const RunControl& control, Corners corners,
                                    std::vector<int>* sources) {
  std::vector<int> all_sources, lean_sources;
  Builder builder(points, control);
  std::optional<ConvexHull> hull = builder.build(all_sources);
  if (sources) *sources = all_sources;
  if (!hull || corners == Corners::kAsFound) return hull;
  const Builder::Vertices vertices = builder.vertices();
  if (vertices.others.empty()) return hull;
  std::vector<Eigen::Vector3d> few;
  for (const int i : vertices.corners) few.push_back(points[static_cast<std::size_t>(i)]);
  std::optional<ConvexHull> lean = Builder(few, control).build(lean_sources);
  if (!lean) return hull;
  double beyond = 0;
  for (const int i : vertices.others) control.check(), beyond = std::max(beyond, planeDistance(*lean, points[static_cast<std::size_t>(i)]));
  if (beyond > kDent * builder.extent()) return hull;
  for (HalfSpace& face : lean->faces) face.offset += beyond + kVisible * builder.extent();  // plus the first run's own margin
  for (int& i : lean_sources) i = vertices.corners[static_cast<std::size_t>(i)];
  if (sources) *sources = lean_sources;
  return lean;
}

}  // namespace collision_hulls
