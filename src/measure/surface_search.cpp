// Queue the hull's triangles by their bounds. While the largest bound exceeds found + gap, split that triangle at its longest edge and
// queue both parts. Where a patch passes through the surface, split it along the plane of a triangle there instead.
//
// The distance f to the solid is 1-Lipschitz: within a radius r of the centre c it is at most f(c) + r. Where f is nearly constant this
// converges slowly, and LevelBound takes over. Where a patch is inside, or near a surface of many triangles, it is moved into the solid: f
// is at most as large as the longest way that any of its points goes.
//
// Where the question is only whether a hull reaches above the floor, parts of it are searched in parallel: then no part gains from what
// another found. The first part that does, in their order, gives the answer, whichever was the fastest.
#include "measure/surface_search.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "base/parallel.h"
#include "measure/level_bound.h"
#include "measure/walls.h"

namespace collision_hulls {

namespace {

constexpr std::size_t kTrianglesPerPart = 16, kMostParts = 8;  // of a hull: parts are searched in parallel
constexpr int kStepsBetweenChecks = 64;  // one may take milliseconds where a mesh of millions of triangles is as near everywhere
constexpr std::size_t kTrianglesBetweenChecks = 64;
constexpr int kMostInARow = 4;      // splits by planes in a row; these need not make a patch shorter
constexpr double kLevel = 0.25;     // in thresholds: a corner nearer to a plane than this lies in it
constexpr double kSteep = 0.05;     // least sine of the angle between a patch and a plane that splits it
constexpr double kLarge = 0.25;     // least size, relative to the patch, of surface triangles along whose edges it may be split
constexpr double kSlack = 0.5;      // in gaps: how far a patch may stick out sideways and still count as above a flat sheet
constexpr double kTouching = 1e-3;  // in thresholds: the direction to a nearest point is vague if that is nearer than this
constexpr double kMoved = 0.125;    // in gaps, above what was found: how far patches are moved
constexpr double kLong = 40;        // in thresholds: shorter patches are halved, as planes would gain little

/// A corner of patches, and the triangle of the solid's surface nearest to it.
struct Corner {
  Eigen::Vector3d p;
  int triangle = -1;
  double distance = 0;  // [m] to that triangle
};

struct Patch {
  std::array<Corner, 3> corner;
  double bound = 0;
  // a triangle of the surface: its plane may separate what is outside from what is inside; null: none known
  const std::array<Eigen::Vector3d, 3>* divider = nullptr;
  int divided = 0;  // times in a row that it and its ancestors were split by planes

  bool operator<(const Patch& other) const { return bound < other.bound; }
  Eigen::Vector3d centre() const { return (corner[0].p + corner[1].p + corner[2].p) / 3; }
};

/// The search over the triangles of one hull or mesh.
class Search {
 public:
  /// `is_vain` is asked now and then: whether the result does not count any more.
  Search(const Solid& solid, const SurfaceQuery& query, std::function<bool()> is_vain)
      : solid_(solid), query_(query), is_vain_(std::move(is_vain)) {}

  /// Over the triangles from the first to before the second of `range`.
  Protrusion run(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles,
                 const std::pair<std::size_t, std::size_t>& range, const RunControl& control) {
    std::vector<Corner> corners;
    for (const Eigen::Vector3d& v : vertices) corners.push_back({v, -1, 0});
    for (std::size_t i = range.first; i < range.second; ++i) {
      if (i % kTrianglesBetweenChecks == 0) {
        control.check();
        if (is_vain_()) return best_;
      }
      if (query_.settled && (*query_.settled)[i]) {
        dropped_ = std::max(dropped_, query_.floor + query_.gap);
        continue;
      }
      const Triangle& t = triangles[i];
      const auto at = [&](std::size_t k) -> Corner& { return corners[static_cast<std::size_t>(t[k])]; };
      if (isKnown({at(0), at(1), at(2)})) continue;
      for (std::size_t k = 0; k < 3; ++k)
        if (at(k).triangle < 0) at(k) = visit(at(k).p, at((k + 2) % 3).triangle);
      push({{at(0), at(1), at(2)}, 0});
    }
    for (int step = 0; !queue_.empty() && queue_.top().bound > threshold() && best_.found <= query_.ceiling && step < query_.halvings;
         ++step) {
      if (step >= query_.patience && queue_.top().bound <= query_.low) break;
      if (step % kStepsBetweenChecks == 0) {
        control.check();
        if (control.late() || is_vain_()) break;
      }
      halve();
    }
    best_.bound = std::max(best_.found, dropped_);
    if (best_.found > query_.ceiling)
      best_.bound = std::numeric_limits<double>::infinity();
    else if (!queue_.empty())
      best_.bound = std::max(best_.bound, queue_.top().bound);
    return best_;
  }

 private:
  /// A patch whose bound is below this is not worth splitting.
  double threshold() const { return std::max(best_.found, query_.floor) + query_.gap; }

  /// How far patches are moved into the solid. With the whole threshold, the gap would be all that is known.
  double farthest() const { return std::max(best_.found, query_.floor) + kMoved * query_.gap; }

  /// Whether, as far as distances are known, no point of the patch is far enough to matter.
  bool isKnown(const std::array<Corner, 3>& corner) {
    if (!query_.known || !query_.known->isWithin({corner[0].p, corner[1].p, corner[2].p}, threshold())) return false;
    dropped_ = std::max(dropped_, threshold());
    return true;
  }

  /// Makes a corner at p; its distance from the solid is a candidate for the largest.
  Corner visit(const Eigen::Vector3d& p, int hint) {
    const TriangleBvh::Nearest n = solid_.surface().nearest(p, std::numeric_limits<double>::infinity(), hint);
    if (n.distance > best_.found && n.distance > query_.floor && !solid_.contains(p)) {
      best_.found = n.distance, best_.where = p, best_.nearest = n.point;
    }
    return {p, n.triangle, n.distance};
  }

  void push(Patch patch) {
    const std::array<Eigen::Vector3d, 3> corners{patch.corner[0].p, patch.corner[1].p, patch.corner[2].p};
    LevelBound<3, 4> level(corners, solid_.surface());  // from the triangles nearest to the corners and to the centre
    for (const Corner& c : patch.corner) level.add(c.triangle);
    patch.bound = level.value();
    if (patch.bound > threshold()) {
      const Eigen::Vector3d c = patch.centre();
      double radius = 0;
      for (const Corner& v : patch.corner) radius = std::max(radius, (v.p - c).norm());
      const TriangleBvh::Nearest n = solid_.surface().nearest(c, std::numeric_limits<double>::infinity(), patch.corner[0].triangle);
      level.add(n.triangle);
      patch.bound = std::min({patch.bound, n.distance + radius, level.value()});
      if (patch.bound > dropped_ || n.distance > std::max(best_.found, query_.floor)) boundBySide(patch, c, radius, n);
      if (patch.bound > threshold()) patch.bound = std::min(patch.bound, solid_.heightAboveSheet(corners, n, kSlack * query_.gap));
    }
    if (patch.bound > threshold())
      queue_.push(patch);
    else
      dropped_ = std::max(dropped_, patch.bound);
  }

  /// Bounds a patch about c by the side of the surface that c is on. That takes long to tell: only where it makes a difference.
  void boundBySide(Patch& patch, const Eigen::Vector3d& c, double radius, const TriangleBvh::Nearest& n) {
    Winding winding = solid_.windingAt(c);
    const double outside = solid_.signedDistance(winding, n.distance);
    if (outside > best_.found && outside > query_.floor) best_.found = outside, best_.where = c, best_.nearest = n.point;
    patch.bound = std::min(patch.bound, std::max(0.0, outside + radius));
    if (patch.bound > threshold() && goesInside(patch, winding, radius, outside, n)) patch.bound = farthest();
  }

  /// Whether every point of the patch about c has a point of the solid within farthest(), because all of the patch is inside once it is
  /// moved there. Lemma 9 of doc/certified.md.
  bool goesInside(Patch& patch, Winding& centre, double radius, double outside, const TriangleBvh::Nearest& nearest) const {
    const Eigen::Vector3d& c = centre.point();
    if (outside < 0 && isInside(patch, c, radius, centre)) return true;
    const double above = std::max(outside, 0.0);
    if (above >= farthest() || (outside < 0 && !patch.divider)) return false;
    const auto& [p, q, r] = outside < 0 ? *patch.divider : solid_.surface().corners(nearest.triangle);
    const Eigen::Vector3d inward = outside > kTouching * threshold() ? nearest.point - c : (q - p).cross(p - r);
    const Eigen::Vector3d by = (above + farthest()) / 2 * inward.normalized();
    Winding moved = solid_.windingAt(c + by);
    return moved.isInside() && isInside(patch, c, radius, moved);
  }

  /// Whether the patch about c lies inside as a whole, as `centre` does, when it is moved there and shrunk: that moves its corners by
  /// farthest() at most. If not, it meets the divider.
  bool isInside(Patch& patch, const Eigen::Vector3d& c, double radius, Winding& centre) const {
    const double share = 1 - (farthest() - (centre.point() - c).norm()) / radius;
    std::array<Eigen::Vector3d, 3> moved;
    for (std::size_t i = 0; i < 3; ++i) moved[i] = centre.point() + share * (patch.corner[i].p - c);
    return solid_.isOneSide(moved, centre, &patch.divider);
  }

  /// Where a plane crosses an edge of a patch.
  struct Crossing {
    std::size_t edge = 0;  // from corner `edge` to the next one
    double at = 0.5;       // as a share of the edge
  };
  std::optional<Crossing> crossing(const Patch& patch) const {
    const Crossing longest = middleOfLongest(patch);
    const double length = (patch.corner[longest.edge].p - patch.corner[(longest.edge + 1) % 3].p).norm();
    if (patch.divided >= kMostInARow || length < kLong * threshold()) return std::nullopt;
    if (patch.divider) {
      const auto& [a, b, c] = *patch.divider;
      return crossing(patch, (b - a).cross(c - a), a);
    }
    // Over a level surface of several triangles: split where one of them ends.
    const auto is_near = [&](const Corner& c) { return c.distance < threshold(); };
    if (!std::all_of(patch.corner.begin(), patch.corner.end(), is_near)) return std::nullopt;
    for (const Corner& corner : patch.corner) {
      const std::array<Eigen::Vector3d, 3>& t = solid_.surface().corners(corner.triangle);
      const double size = std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
      if (size < kLarge * length) continue;
      const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
      for (std::size_t i = 0; i < 3; ++i)
        if (const auto found = crossing(patch, (t[(i + 1) % 3] - t[i]).cross(normal), t[i])) return found;
    }
    return std::nullopt;
  }

  std::optional<Crossing> crossing(const Patch& patch, const Eigen::Vector3d& normal, const Eigen::Vector3d& through) const {
    std::array<double, 3> height;
    for (std::size_t i = 0; i < 3; ++i) height[i] = normal.dot(patch.corner[i].p - through);
    const auto [low, high] = std::minmax_element(height.begin(), height.end());
    const Crossing longest = middleOfLongest(patch);
    const double length = (patch.corner[longest.edge].p - patch.corner[(longest.edge + 1) % 3].p).norm();
    if (!(*high - *low > kSteep * normal.norm() * length)) return std::nullopt;  // nearly level: it would cut off slivers
    const double level = kLevel * threshold() * normal.norm();
    std::optional<Crossing> result;  // on the longer of the edges that it crosses: cut at the shorter one, patches become slivers
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double from = height[i], to = height[(i + 1) % 3], size = (patch.corner[i].p - patch.corner[(i + 1) % 3].p).squaredNorm();
      if (std::min(from, to) < -level && std::max(from, to) > level && size > most) most = size, result = Crossing{i, from / (from - to)};
    }
    return result;
  }

  Crossing middleOfLongest(const Patch& patch) const {
    Crossing longest;
    const auto length = [&](std::size_t i) { return (patch.corner[i].p - patch.corner[(i + 1) % 3].p).squaredNorm(); };
    for (std::size_t i = 1; i < 3; ++i)
      if (length(i) > length(longest.edge)) longest.edge = i;
    return longest;
  }

  void halve() {
    Patch patch = queue_.top();
    queue_.pop();
    const std::optional<Crossing> plane = crossing(patch);
    const Crossing cut = plane ? *plane : middleOfLongest(patch);
    patch.divided = plane ? patch.divided + 1 : 0;
    const std::size_t a = cut.edge, b = (a + 1) % 3;
    const Corner between = visit(patch.corner[a].p + cut.at * (patch.corner[b].p - patch.corner[a].p), patch.corner[a].triangle);
    Patch other = patch;
    patch.corner[b] = other.corner[a] = between;
    if (!isKnown(patch.corner)) push(patch);
    if (!isKnown(other.corner)) push(other);
  }

  const Solid& solid_;
  const SurfaceQuery query_;
  const std::function<bool()> is_vain_;
  double dropped_ = 0;
  std::priority_queue<Patch> queue_;
  Protrusion best_;
};

}  // namespace

Protrusion largestOnSurface(const ConvexHull& hull, const Solid& solid, const SurfaceQuery& query, const RunControl& control) {
  const std::size_t count = hull.triangles.size();
  const std::size_t parts = query.ceiling > query.floor ? 1 : std::clamp(count / kTrianglesPerPart, std::size_t{1}, kMostParts);
  std::vector<Protrusion> each(parts);
  std::atomic<std::size_t> first{parts};  // part with something above the ceiling; later ones do not count
  forEach(parts, [&](std::size_t i) {
    Search search(solid, query, [&] { return first < i; });
    each[i] = search.run(hull.vertices, hull.triangles, {i * count / parts, (i + 1) * count / parts}, control);
    if (!(each[i].found > query.ceiling)) return;
    for (std::size_t other = first; i < other && !first.compare_exchange_weak(other, i);) continue;
  });
  if (first < parts) return each[first];
  Protrusion largest = each[0];
  for (const Protrusion& part : each) {
    const double bound = std::max(largest.bound, part.bound);
    if (part.found > largest.found) largest = part;
    largest.bound = bound;
  }
  return largest;
}

Protrusion largestOnSurface(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles, const Solid& solid,
                            const SurfaceQuery& query, const RunControl& control) {
  return Search(solid, query, [] { return false; }).run(vertices, triangles, {0, triangles.size()}, control);
}

}  // namespace collision_hulls
