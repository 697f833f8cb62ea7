// 1. Candidates: the largest spheres in the space, at points all over the surface (sphere_candidates.h).
// 2. A choice: candidates that hold all of many points of the surface, greedily (set_cover.h).
// 3. Gaps: parts of the surface in none of the chosen spheres (sphere_cover.h). Points in them join those that must be held, and the choice
// is
//    completed, until there are no gaps: the first cover.
// 4. Search: drop a sphere; then swap spheres until all points are held and there are no gaps. If that succeeds, drop another. Before each
// swap,
//    the spheres nearest to a point that is not held are moved towards it; as they move they leave gaps on the other side, and so the slack
//    between spheres wanders until it closes. Candidates that do not move would need a dense grid of places to come as far.
//
// The points are few and the proof is exact, so the work goes where spheres meet. The cover is proved at any time, so the search may end at
// any time.
#include "primitives/sphere_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "primitives/sphere_cover.h"

namespace collision_hulls {

namespace {

constexpr double kDepth = 0.05;         // of the tolerance: how deep a sphere must hold points
constexpr double kGrain = 0.5;          // of the tolerance: length of the pieces whose gaps count singly, or more if these
constexpr double kMostPieces = 20'000;  // would be too many
constexpr double kSpacing = 0.35;       // of the tolerance: between points
constexpr double kLeastPoints = 500, kMostPoints = 12'000;
constexpr std::size_t kMostSeeds = 1500;  // points at which candidates are sought
constexpr std::size_t kNeighbours = 2;    // spheres that are moved before a swap
constexpr double kOvershoot = 1.05;       // a sphere is moved this much further than it has to be
constexpr std::size_t kMostMoved = 1000;  // candidates kept that came from others by a move
constexpr std::size_t kProof = 50;        // work of a proof, per point
constexpr std::size_t kStepsBetweenChecks = 64;
constexpr std::size_t kHopeless = 2;  // a first cover of this many times the limit, and more, is given up: the search seldom saves half

class Choice {
 public:
  Choice(const TriangleMesh& mesh, const TolerableSpace& space, const RunControl& control)
      : mesh_(mesh),
        space_(space),
        control_(control),
        depth_(kDepth * space.tolerance()),
        grain_(std::max(kGrain * space.tolerance(), std::sqrt(area(mesh) / kMostPieces))) {
    const double spacing = kSpacing * space.tolerance();
    const auto count = static_cast<std::size_t>(std::clamp(area(mesh) / (spacing * spacing), kLeastPoints, kMostPoints));
    addCandidates(spreadOver(mesh, std::min(count, kMostSeeds)));
    std::vector<Eigen::Vector3d> points;
    for (const SurfacePoint& at : spreadOver(mesh, count)) points.push_back(at.p);
    addPoints(points);
  }

  /// Whether a cover was found from which the search may come down to that many.
  bool findCover(std::size_t most) {
    cover_.complete();
    cover_.dropRedundant();
    while (cover_.chosen().size() / kHopeless <= most && !isProved()) cover_.complete();
    best_ = chosen();
    return best_.size() / kHopeless <= most;
  }

  void findFewer(const ChoiceLimits& limits) {
    const std::size_t before = done();
    for (std::size_t step = 0; done() - before < limits.work && best_.size() > limits.enough; ++step) {
      if (step % kStepsBetweenChecks == 0) {
        control_.check();
        if (best_.size() <= limits.max_spheres) control_.report(static_cast<double>(done() - before) / static_cast<double>(limits.work));
      }
      if (!cover_.open().empty()) {
        const int point = cover_.open()[step % cover_.open().size()];
        offerMoved(points_[static_cast<std::size_t>(point)]);
        cover_.swapFor(point);
      } else if (isProved()) {
        best_ = chosen();
        cover_.dropLeast();
      }
    }
  }

  const std::vector<Sphere>& best() const { return best_; }

 private:
  std::size_t done() const { return work_ + cover_.work(); }

  bool holds(const Sphere& sphere, const Eigen::Vector3d& p) const {
    const double radius = std::max(0.0, sphere.radius - depth_);
    return (p - sphere.centre).squaredNorm() <= radius * radius;
  }

  std::vector<int> pointsIn(const Sphere& sphere) {
    std::vector<int> result;
    const double radius = std::max(0.0, sphere.radius - depth_), square = radius * radius;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if ((points_[i] - sphere.centre).squaredNorm() <= square) result.push_back(static_cast<int>(i));
    work_ += points_.size();
    return result;
  }

  void add(const Sphere& sphere) {
    candidates_.push_back(sphere);
    cover_.addSet(pointsIn(sphere));
  }

  void addCandidates(const std::vector<SurfacePoint>& seeds) {
    std::vector<std::vector<Sphere>> found(seeds.size());
    forEach(seeds.size(), [&](std::size_t i) {
      control_.check();
      found[i] = largestAt(seeds[i], space_);
    });
    for (const std::vector<Sphere>& spheres : found)
      for (const Sphere& sphere : spheres) add(sphere);
  }

  /// A point that no candidate holds comes with one that does.
  void addPoints(const std::vector<Eigen::Vector3d>& points) {
    std::vector<std::vector<int>> holders(points.size());
    const std::size_t before = candidates_.size();
    const auto note = [&](std::size_t i, std::size_t first) {
      for (std::size_t s = first; s < candidates_.size(); ++s)
        if (holds(candidates_[s], points[i])) holders[i].push_back(static_cast<int>(s));
    };
    forEach(points.size(), [&](std::size_t i) { note(i, 0); });
    for (std::size_t i = 0; i < points.size(); ++i) {
      note(i, before);
      points_.push_back(points[i]);
      cover_.addElement(holders[i]);
      if (holders[i].empty()) addHolder(points[i]);
    }
  }

  void addHolder(const Eigen::Vector3d& p) {
    control_.check();
    const Sphere about = sphereAt(p, space_), larger = enlarged(about, space_);
    if (!holds(about, p)) throw Error(ErrorCode::kInternal, "no sphere within the tolerance holds a point of the surface");
    add(holds(larger, p) ? larger : about);
  }

  /// Whether the chosen spheres leave no gap; if they do, points in it must be held from now on.
  bool isProved() {
    const std::vector<Eigen::Vector3d> gaps = gapsIn(mesh_, chosen(), {depth_, grain_}, control_);
    work_ += kProof * points_.size();
    addPoints(gaps);
    return gaps.empty();
  }

  /// Makes candidates of the chosen spheres nearest to a point, each moved so far that it holds the point.
  void offerMoved(const Eigen::Vector3d& p) {
    std::vector<std::pair<double, int>> near;
    for (const int s : cover_.chosen()) {
      const Sphere& sphere = candidates_[static_cast<std::size_t>(s)];
      near.emplace_back((p - sphere.centre).norm() - sphere.radius, s);
    }
    const std::size_t count = std::min(kNeighbours, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
    for (std::size_t k = 0; k < count; ++k) {
      const Sphere& sphere = candidates_[static_cast<std::size_t>(near[k].second)];
      const double way = kOvershoot * (near[k].first + depth_);
      const Sphere moved = sphereAt(sphere.centre + way * (p - sphere.centre).normalized(), space_);
      if (holds(moved, p)) offer(moved);
    }
  }

  /// Beyond kMostMoved, it takes the place of the oldest that is not chosen.
  void offer(const Sphere& sphere) {
    if (moved_.size() < std::max(kMostMoved, 2 * cover_.chosen().size())) {
      moved_.push_back(static_cast<int>(candidates_.size()));
      add(sphere);
      return;
    }
    do oldest_ = (oldest_ + 1) % moved_.size();
    while (cover_.isChosen(moved_[oldest_]));
    candidates_[static_cast<std::size_t>(moved_[oldest_])] = sphere;
    cover_.replaceSet(moved_[oldest_], pointsIn(sphere));
  }

  std::vector<Sphere> chosen() const {
    std::vector<Sphere> result;
    for (const int s : cover_.chosen()) result.push_back(candidates_[static_cast<std::size_t>(s)]);
    return result;
  }

  const TriangleMesh& mesh_;
  const TolerableSpace& space_;
  const RunControl& control_;
  const double depth_, grain_;           // [m]
  std::vector<Eigen::Vector3d> points_;  // that must be held
  std::vector<Sphere> candidates_;
  SetCover cover_;          // of the points by the candidates
  std::vector<int> moved_;  // candidates that came from others by a move, in a ring,
  std::size_t oldest_ = 0;  // which begins after this one
  std::size_t work_ = 0;
  std::vector<Sphere> best_;  // a cover
};

}  // namespace

std::optional<std::vector<Sphere>> fewSpheres(const TriangleMesh& mesh, const TolerableSpace& space, const ChoiceLimits& limits,
                                              const RunControl& control) {
  Choice choice(mesh, space, control);
  if (!choice.findCover(limits.max_spheres)) return std::nullopt;
  choice.findFewer(limits);
  if (choice.best().size() > limits.max_spheres) return std::nullopt;
  return choice.best();
}

}  // namespace collision_hulls
