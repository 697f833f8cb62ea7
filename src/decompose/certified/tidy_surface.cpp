// A mesh says more than its shape: the order of its triangles, and how its flat faces are divided. Splitting samples points and scores cuts
// on simplified pieces, so all of this would show in the hulls.
//
// Vertices are put in order along a slanted direction (geometry/lean.h), triangles by their vertices. Then a half-edge collapse moves a
// vertex into a neighbour where the triangles that remain around it stay in their planes. So it is inside a flat face, or the neighbour is
// further along a straight edge. Only vertices inside the surface are moved, and only where the surface stays a surface (its two triangles
// are all that both ends of the edge have in common); so an edge where it ends, or where three faces meet, stays as it is.
//
// What a vertex is moved by, out of the planes, adds up along the way and never exceeds `flat`. O(n log n) to sort, O(n) for the rest.
#include "decompose/certified/tidy_surface.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/at.h"
#include "base/looks.h"
#include "geometry/lean.h"

namespace collision_hulls {

namespace {

SurfacePiece inOrderOfPlace(const SurfacePiece& surface) {
  std::vector<std::pair<double, int>> order;
  order.reserve(surface.vertices.size());
  for (const Eigen::Vector3d& v : surface.vertices) order.push_back({lean(v, 1), static_cast<int>(order.size())});
  const auto place = [&](const std::pair<double, int>& item) {
    const Eigen::Vector3d& v = surface.vertices[at(item.second)];
    return std::make_tuple(item.first, v.x(), v.y(), v.z());
  };
  std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
  SurfacePiece result;
  result.vertices.reserve(order.size());
  std::vector<int> number(order.size());
  for (const auto& [along, v] : order) {
    number[at(v)] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(surface.vertices[at(v)]);
  }
  result.triangles.reserve(surface.triangles.size());
  for (const Triangle& t : surface.triangles) {
    Triangle renumbered{number[at(t[0])], number[at(t[1])], number[at(t[2])]};
    std::rotate(renumbered.begin(), std::min_element(renumbered.begin(), renumbered.end()), renumbered.end());
    result.triangles.push_back(renumbered);
  }
  std::sort(result.triangles.begin(), result.triangles.end());
  return result;
}

class Tidying {
 public:
  Tidying(SurfacePiece surface, double flat, const RunControl& control)
      : points_(std::move(surface.vertices)),
        triangles_(std::move(surface.triangles)),
        flat_(flat),
        look_(control),
        first_(points_.size(), -1),
        next_(3 * triangles_.size()),
        stays_(points_.size(), 0),
        moved_(points_.size(), 0),
        is_gone_(triangles_.size(), 0) {
    for (int corner = static_cast<int>(next_.size()) - 1; corner >= 0; --corner) look_(), link(corner);
    for (const Triangle& t : triangles_)
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
        for (const int v : t) stays_[at(v)] = 1;
  }

  SurfacePiece run() {
    std::deque<int> waiting(points_.size());
    std::iota(waiting.begin(), waiting.end(), 0);
    std::vector<char> waits(points_.size(), 1);
    while (!waiting.empty()) {
      look_();
      const int v = waiting.front();
      waiting.pop_front();
      waits[at(v)] = 0;
      if (!removes(v)) continue;
      for (const Corner& corner : around_)
        for (const int other : {corner.from, corner.to})
          if (!std::exchange(waits[at(other)], 1)) waiting.push_back(other);
    }
    return rest();
  }

 private:
  /// A triangle at a vertex.
  struct Corner {
    int number;    // three times the triangle's, and which of its corners this is
    int from, to;  // the side across
    Eigen::Vector3d normal;
    bool is_sliver;  // so slim that it has no normal
  };

  int& vertexAt(int corner) { return triangles_[at(corner / 3)][at(corner % 3)]; }
  bool isGone(int corner) const { return is_gone_[at(corner / 3)] != 0; }

  void link(int corner) {
    int& first = first_[at(vertexAt(corner))];
    next_[at(corner)] = first;
    first = corner;
  }

  bool has(int corner, int v) const {
    const Triangle& t = triangles_[at(corner / 3)];
    return t[0] == v || t[1] == v || t[2] == v;
  }

  /// Twice the area long; zero for a sliver.
  Eigen::Vector3d normalOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const {
    const Eigen::Vector3d ab = b - a, ac = c - a, normal = ab.cross(ac);
    const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
    if (normal.squaredNorm() <= flat_ * flat_ * longest) return Eigen::Vector3d::Zero();
    return normal;
  }

  void lookAround(int v) {
    around_.clear();
    for (int corner = first_[at(v)]; corner >= 0; corner = next_[at(corner)]) {
      if (isGone(corner)) continue;
      const Triangle& t = triangles_[at(corner / 3)];
      const int from = t[at((corner % 3 + 1) % 3)], to = t[at((corner % 3 + 2) % 3)];
      const Eigen::Vector3d normal = normalOf(points_[at(v)], points_[at(from)], points_[at(to)]);
      const bool is_sliver = normal.isZero(0);
      around_.push_back({corner, from, to, is_sliver ? normal : Eigen::Vector3d(normal.normalized()), is_sliver});
    }
  }

  /// Whether the vertex is no longer used; around_ is what was around it.
  bool removes(int v) {
    if (stays_[at(v)]) return false;
    lookAround(v);
    if (around_.size() == 1) return dropsTip(v);
    for (const Corner& corner : around_) {
      const double out = wayOut(v, corner.from);
      if (!(moved_[at(v)] + out <= flat_) || !keepsFacing(corner.from) || !isInside() || !isLink(corner.from)) continue;
      move(v, corner.from, out);
      return true;
    }
    return false;
  }

  /// [m] How far the vertex `to` is out of the planes of the triangles at `v` that stay; infinite where there is no telling.
  double wayOut(int v, int to) const {
    const Eigen::Vector3d way = points_[at(to)] - points_[at(v)];
    double out = 0;
    for (const Corner& corner : around_) {
      if (corner.from == to || corner.to == to) continue;
      out = std::max(out, corner.is_sliver ? std::numeric_limits<double>::infinity() : std::abs(corner.normal.dot(way)));
      if (out > flat_) break;
    }
    return out;
  }

  bool keepsFacing(int to) const {
    return std::all_of(around_.begin(), around_.end(), [&](const Corner& corner) {
      if (corner.from == to || corner.to == to) return true;
      return normalOf(points_[at(to)], points_[at(corner.from)], points_[at(corner.to)]).dot(corner.normal) > 0;
    });
  }

  /// Whether the sides across close one ring.
  bool isInside() {
    sides_.clear();
    for (const Corner& corner : around_) sides_.push_back({corner.from, corner.to});
    std::sort(sides_.begin(), sides_.end());
    std::size_t steps = 0;
    int end = sides_[0].first;
    do {
      const auto side = std::lower_bound(sides_.begin(), sides_.end(), std::make_pair(end, -1));
      const bool is_one = side != sides_.end() && side->first == end && (side + 1 == sides_.end() || (side + 1)->first != end);
      if (!is_one || ++steps > sides_.size()) return false;
      end = side->second;
    } while (end != sides_[0].first);
    return steps == sides_.size();
  }

  /// Whether no vertex but the two across the edge to `to` is next to both of its ends. After isInside().
  bool isLink(int to) {
    neighbours_.clear();
    for (int corner = first_[at(to)]; corner >= 0; corner = next_[at(corner)])
      if (!isGone(corner))
        for (const int v : triangles_[at(corner / 3)])
          if (v != to) neighbours_.push_back(v);
    std::sort(neighbours_.begin(), neighbours_.end());
    const auto is_common = [&](const std::pair<int, int>& side) {
      return std::binary_search(neighbours_.begin(), neighbours_.end(), side.first);
    };
    return std::count_if(sides_.begin(), sides_.end(), is_common) == 2;
  }

  void move(int v, int to, double out) {
    moved_[at(to)] = std::max(moved_[at(to)], moved_[at(v)] + out);
    for (const Corner& corner : around_) {
      if (has(corner.number, to)) {
        is_gone_[at(corner.number / 3)] = 1;
        continue;
      }
      vertexAt(corner.number) = to;
      link(corner.number);
    }
    first_[at(v)] = -1;
  }

  /// Drops a triangle that has hardly any height over a side of another one.
  bool dropsTip(int v) {
    const Corner& tip = around_[0];
    const Eigen::Vector3d side = points_[at(tip.to)] - points_[at(tip.from)], way = points_[at(v)] - points_[at(tip.from)];
    const double along = way.dot(side);
    if (!tip.is_sliver || along < 0 || along > side.squaredNorm() || way.cross(side).norm() > flat_ * side.norm()) return false;
    for (int corner = first_[at(tip.from)]; corner >= 0; corner = next_[at(corner)]) {
      if (isGone(corner) || corner / 3 == tip.number / 3 || !has(corner, tip.to)) continue;
      is_gone_[at(tip.number / 3)] = 1;
      return true;
    }
    return false;
  }

  /// What is left, in the same order.
  SurfacePiece rest() {
    SurfacePiece result;
    std::vector<int> number(points_.size(), -1);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (look_(); !is_gone_[t])
        for (const int v : triangles_[t]) number[at(v)] = 0;
    for (std::size_t v = 0; v < points_.size(); ++v) {
      look_();
      if (number[v] < 0) continue;
      number[v] = static_cast<int>(result.vertices.size());
      result.vertices.push_back(points_[v]);
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      look_();
      const Triangle& c = triangles_[t];
      if (!is_gone_[t]) result.triangles.push_back({number[at(c[0])], number[at(c[1])], number[at(c[2])]});
    }
    return result;
  }

  std::vector<Eigen::Vector3d> points_;
  std::vector<Triangle> triangles_;
  const double flat_;
  Looks look_;
  std::vector<int> first_, next_;  // lists of corners: the first of each vertex, and after each corner the next one of its vertex
  std::vector<char> stays_;        // per vertex: an end of a segment, or a point
  std::vector<double> moved_;      // [m] per vertex: the furthest that the surface there was moved
  std::vector<char> is_gone_;      // per triangle
  std::vector<Corner> around_;
  std::vector<std::pair<int, int>> sides_;  // across the corners, sorted
  std::vector<int> neighbours_;
};

}  // namespace

SurfacePiece tidied(const SurfacePiece& surface, double flat, const RunControl& control) {
  return Tidying(inOrderOfPlace(surface), flat, control).run();
}

}  // namespace collision_hulls
