// Put the hull's triangles into a queue, largest bound first; until the largest bound is at most found + gap, divide that triangle
// at its longest edge and put both parts back. Where a hull's face is level with the surface on one side of an edge of it and runs into the
// solid on the other, it is divided along that edge instead.
//
// The distance f to the solid is 1-Lipschitz: within a radius r of the centre c it is at most f(c) + r. Where f is level that closes
// slowly, and LevelBound takes over; TriangleBvh::frontBound settles patches within the solid that end at its surface, where
// no opening is as near as that.
#include "check/surface_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>

#include "check/level_bound.h"

namespace collision_hulls {

namespace {

constexpr int kStepsBetweenChecks = 1024;
constexpr std::size_t kTrianglesBetweenChecks = 1024;
constexpr int kMostInARow = 4;   // divisions by planes, which may not make a patch shorter
constexpr double kLevel = 0.25;  // thresholds: a corner nearer to a plane lies in it
constexpr double kSteep = 0.05;  // sine of the least angle between a patch and a plane that divides it
constexpr double kLarge = 0.25;  // a triangle's size over the patch's: smaller ones are too many to divide along each
constexpr double kSlack = 0.5;   // gaps: how far beyond a flat sheet a patch may reach and still count as above it
constexpr double kLong = 40;     // thresholds: shorter patches are halved: planes would gain little

/// A corner of patches, and the triangle of the solid's surface nearest to it.
struct Corner {
  Eigen::Vector3d p;
  int triangle = -1;
  double distance = 0;  // from it
};

struct Patch {
  std::array<Corner, 3> corner;
  double bound = 0;
  int divider = -1;  // a triangle of the solid's surface whose plane may divide what is level from what lies within; -1: none known
  int divided = 0;   // how often it and its like were divided by planes in a row

  bool operator<(const Patch& other) const { return bound < other.bound; }
  Eigen::Vector3d centre() const { return (corner[0].p + corner[1].p + corner[2].p) / 3; }
};

/// The search over one hull.
class Search {
 public:
  Search(const Solid& solid, const SurfaceQuery& query) : solid_(solid), query_(query) {}

  Protrusion run(const ConvexHull& hull, const RunControl& control) {
    std::vector<Corner> corners;
    for (const Eigen::Vector3d& v : hull.vertices) corners.push_back({v, -1, 0});
    for (std::size_t i = 0; i < hull.triangles.size(); ++i) {
      if (i % kTrianglesBetweenChecks == 0) control.check();
      const Triangle& t = hull.triangles[i];
      const auto at = [&](std::size_t k) -> Corner& { return corners[static_cast<std::size_t>(t[k])]; };
      if (isKnown({at(0), at(1), at(2)})) continue;
      for (std::size_t k = 0; k < 3; ++k)
        if (at(k).triangle < 0) at(k) = visit(at(k).p, at((k + 2) % 3).triangle);
      push({{at(0), at(1), at(2)}, 0});
    }
    for (int step = 0; !queue_.empty() && queue_.top().bound > threshold() && best_.found <= query_.ceiling && step < query_.halvings;
         ++step) {
      if (step >= query_.patience && queue_.top().bound <= query_.low) break;
      if (step % kStepsBetweenChecks == 0) control.check();
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
  /// What a patch must promise to exceed to be worth halving.
  double threshold() const { return std::max(best_.found, query_.floor) + query_.gap; }

  /// Whether nothing of the patch is further than what counts, as far as distances are known.
  bool isKnown(const std::array<Corner, 3>& corner) {
    if (!query_.known || !query_.known->isWithin({corner[0].p, corner[1].p, corner[2].p}, threshold())) return false;
    dropped_ = std::max(dropped_, threshold());
    return true;
  }

  /// A corner at p, whose distance from the solid is a candidate for the largest.
  Corner visit(const Eigen::Vector3d& p, int hint) {
    const TriangleBvh::Nearest n = solid_.surface().nearest(p, std::numeric_limits<double>::infinity(), hint);
    if (n.distance > best_.found && n.distance > query_.floor && !solid_.contains(p)) {
      best_.found = n.distance, best_.where = p, best_.nearest = n.point;
    }
    return {p, n.triangle, n.distance};
  }

  void push(Patch patch) {
    const std::array<Eigen::Vector3d, 3> corners{patch.corner[0].p, patch.corner[1].p, patch.corner[2].p};
    LevelBound<3, 4> level(corners, solid_.surface());  // by the triangles nearest to the corners and to the centre
    for (const Corner& c : patch.corner) level.add(c.triangle);
    patch.bound = level.value();
    if (patch.bound > threshold()) {
      const Eigen::Vector3d c = patch.centre();
      double radius = 0;
      for (const Corner& v : patch.corner) radius = std::max(radius, (v.p - c).norm());
      const TriangleBvh::Nearest n = solid_.surface().nearest(c, std::numeric_limits<double>::infinity(), patch.corner[0].triangle);
      const double outside = solid_.signedDistance(c, n.distance);
      if (outside > best_.found && outside > query_.floor) best_.found = outside, best_.where = c, best_.nearest = n.point;
      level.add(n.triangle);
      patch.bound = std::min({patch.bound, std::max(0.0, outside + radius), level.value()});
      if (patch.bound > threshold()) patch.bound = std::min(patch.bound, solid_.heightAboveSheet(corners, n, kSlack * query_.gap));
      if (patch.bound > threshold()) {
        const double reach = n.distance + 2 * radius;  // to whatever is nearest to a point of the patch
        const double front = solid_.surface().frontBound({corners.begin(), corners.end()}, c, reach, &patch.divider);
        if (front < patch.bound && solid_.wayToBorder(c) > reach) patch.bound = front;
      }
    }
    if (patch.bound > threshold())
      queue_.push(patch);
    else
      dropped_ = std::max(dropped_, patch.bound);
  }

  /// Where a plane crosses an edge of a patch.
  struct Crossing {
    std::size_t edge = 0;  // from corner `edge` to the next one
    double at = 0.5;       // of the way
  };
  std::optional<Crossing> crossing(const Patch& patch) const {
    const Crossing longest = middleOfLongest(patch);
    const double length = (patch.corner[longest.edge].p - patch.corner[(longest.edge + 1) % 3].p).norm();
    if (patch.divided >= kMostInARow || length < kLong * threshold()) return std::nullopt;
    if (patch.divider >= 0) {
      const auto& [a, b, c] = solid_.surface().corners(patch.divider);
      return crossing(patch, (b - a).cross(c - a), a);
    }
    // Over a level surface of several triangles: where one of them ends.
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
    if (!(*high - *low > kSteep * normal.norm() * length)) return std::nullopt;  // nearly level: it would cut slivers off
    const double level = kLevel * threshold() * normal.norm();
    for (std::size_t i = 0; i < 3; ++i) {
      const double from = height[i], to = height[(i + 1) % 3];
      if (std::min(from, to) < -level && std::max(from, to) > level) return Crossing{i, from / (from - to)};
    }
    return std::nullopt;
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
  double dropped_ = 0;
  std::priority_queue<Patch> queue_;
  Protrusion best_;
};

}  // namespace

Protrusion largestOnSurface(const ConvexHull& hull, const Solid& solid, const SurfaceQuery& query, const RunControl& control) {
  return Search(solid, query).run(hull, control);
}

}  // namespace collision_hulls
