// Runs the steps of certified.h. Different plane scores and leaf sizes win on different meshes, so there are several ways to cut; later
// ways run only while the best cover is small, when every hull counts. Stops early if the cover is provably minimal (points_apart.h). Works
// about the origin and along the mesh's own axes, which makes results finer and steadier.
#include "collision_hulls/decompose/certified.h"

#include <cmath>
#include <limits>
#include <memory>

#include "base/parallel.h"
#include "collision_hulls/decompose/reduce_vertices.h"
#include "decompose/certified/largest_side.h"
#include "decompose/certified/local_search.h"
#include "decompose/certified/merging.h"
#include "decompose/certified/points_apart.h"
#include "decompose/certified/tree_building.h"
#include "geometry/own_axes.h"
#include "mesh/loose_segments.h"

namespace collision_hulls {

namespace {

// Share of the tolerance used for cutting leaves: a small one leaves merging some room, a large one makes leaves as large as possible.
constexpr double kLeafShare = 0.7, kLargeLeafShare = 0.93;
constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kManyLeaves = 8, kManyLeavesPerHull = 8;  // more leaves than this are not worth merging

/// One way to cut.
struct Way {
  ScoreWeights weights;
  double leaf_share = kLeafShare;
  std::size_t few = kAnyNumber;  // tried only if the ways before it leave no more hulls than this
  bool largest_side_first = false;
};

/// How hard to try.
struct Plan {
  std::vector<Way> ways;
  std::size_t elements = 0;    // pieces that leaves are divided into for the search; 0: leaves are not divided
  long first_evaluations = 0;  // evaluations for the search after each way of cutting,
  long evaluations = 0;        // and for the final search on the best cover
};

Plan planFor(Effort effort) {
  const ScoreWeights large_sides{0.5, 0.3, 0}, any_side{0.5, 0, 0.1}, little_volume{0.1, 0, 0};
  constexpr std::size_t kFew = 24, kVeryFew = 10;
  if (effort == Effort::kQuick)
    return {{{large_sides}, {any_side, kLeafShare, kFew}, {large_sides, kLargeLeafShare, kVeryFew, true}}, 0, 0, 400};
  Plan plan{{}, 150, 200, 10'000};
  for (const double share : {kLeafShare, kLargeLeafShare})
    for (const ScoreWeights& weights : {large_sides, any_side, little_volume}) plan.ways.push_back({weights, share});
  plan.ways.push_back({large_sides, kLargeLeafShare, kAnyNumber, true});
  return plan;
}

/// The frame to work in: about the origin, where coordinates are finest, and along the mesh's own axes.
class Place {
 public:
  explicit Place(const RepairedMesh& mesh) : axes_(ownAxes(mesh.mesh)), middle_(boundingBox(mesh).center()) {}

  RepairedMesh brought(RepairedMesh mesh) const {
    for (Eigen::Vector3d& v : mesh.mesh.vertices) v = axes_ * (v - middle_);
    for (Segment& segment : mesh.loose)
      for (Eigen::Vector3d& p : segment) p = axes_ * (p - middle_);
    return mesh;
  }

  void takeBack(ConvexHull& hull) const {
    Eigen::Isometry3d back = Eigen::Isometry3d::Identity();
    back.linear() = axes_.transpose();
    back.translation() = middle_;
    hull = transformed(hull, back);
  }

 private:
  const Eigen::Matrix3d axes_;  // rows
  const Eigen::Vector3d middle_;
};

/// Maps the progress of one stage to its stretch of the whole.
std::function<void(double)> stretch(const RunControl& control, double from, double to) {
  return [&control, from, to](double share) { control.report(from + (to - from) * share); };
}

/// One decomposition in progress.
class Job {
 public:
  Job(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control)
      : mesh_(mesh),
        options_(options),
        plan_(planFor(options.effort)),
        control_(control),
        solid_(mesh, control),
        oracle_(solid_, boundingBox(mesh), options.tolerance, control) {}

  Cover cover() {
    const std::uint64_t seed = options_.seed;
    Cover best;
    const double step = 0.7 / static_cast<double>(plan_.ways.size());
    for (std::size_t i = 0; i < plan_.ways.size(); ++i) {
      if (best.size() > plan_.ways[i].few || (plan_.ways[i].largest_side_first && !hasLargeSide())) continue;
      const double from = step * static_cast<double>(i);
      const std::size_t most = groups_ ? kManyLeaves + kManyLeavesPerHull * best.size() : CutOptions{}.most_leaves;
      const std::vector<Leaf> parts = leaves(plan_.ways[i], most, stretch(control_, from, from + 0.8 * step));
      if (groups_ && parts.size() >= most) continue;
      auto mine = std::make_unique<SurfaceGroups>(parts, plan_.elements, oracle_, options_.max_vertices);
      Cover cover = mergedBest(mine->leaves(), *mine);
      if (plan_.first_evaluations > 0)
        cover = improved(std::move(cover), *mine, {plan_.first_evaluations, seed}, stretch(control_, from + 0.8 * step, from + step));
      if (groups_ && cover.size() >= best.size()) continue;
      best = std::move(cover);
      groups_ = std::move(mine);
      if (isLeast(best, mesh_.mesh, solid_, options_.tolerance)) return best;
    }
    return improved(std::move(best), *groups_, {plan_.evaluations, seed}, stretch(control_, 0.7, 0.9));
  }

  std::vector<ConvexHull> hullsOf(const Cover& cover) const {
    std::vector<ConvexHull> hulls(cover.size());
    forEach(cover.size(), [&](std::size_t i) { hulls[i] = groups_->cappedHull(cover[i]); });
    return hulls;
  }

  HullTree treeOver(Cover cover) {
    forEach(cover.size(), [&](std::size_t i) { cover[i].hull = std::make_shared<ConvexHull>(groups_->exactHull(cover[i])); });
    return treeAbove(cover, oracle_, stretch(control_, 0.9, 1));
  }

 private:
  bool hasLargeSide() {
    oracle_.setShare(kLargeLeafShare);
    const bool result = largestSide(withLoose(mesh_), oracle_).has_value();
    oracle_.setShare(1);
    return result;
  }

  std::vector<Leaf> leaves(const Way& way, std::size_t most, const std::function<void(double)>& progress) {
    oracle_.setShare(way.leaf_share);
    const CutOptions options{way.weights, options_.max_vertices, options_.fill, way.largest_side_first, most};
    std::vector<Leaf> leaves = cutIntoLeaves(mesh_, oracle_, options, progress);
    oracle_.setShare(1);
    return leaves;
  }

  const RepairedMesh& mesh_;
  const DecomposeOptions options_;
  const Plan plan_;
  const RunControl& control_;
  const Solid solid_;
  ProtrusionOracle oracle_;
  std::unique_ptr<SurfaceGroups> groups_;  // of the best cover
};

}  // namespace

Decomposition certified(const RepairedMesh& original, const DecomposeOptions& options, const RunControl& control) {
  const Place place(original);
  const RepairedMesh mesh = place.brought(original);
  Job job(mesh, options, control);
  Decomposition result;
  Cover cover = job.cover();
  result.capped = options.max_hulls > 0 && cover.size() > static_cast<std::size_t>(options.max_hulls);
  if (result.capped) {
    const HullTree tree = job.treeOver(std::move(cover));
    result.hulls = tree.hullsOf(tree.cutTo(options.max_hulls));
    if (options.max_vertices > 0)
      for (ConvexHull& hull : result.hulls) hull = reduceVertices(hull, options.max_vertices);
  } else {
    result.hulls = job.hullsOf(cover);
  }
  for (ConvexHull& hull : result.hulls) place.takeBack(hull);
  control.report(1);
  return result;
}

HullTree hullTree(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control) {
  check(options);
  if (mesh.mesh.triangles.empty() && mesh.loose.empty())
    throw Error(ErrorCode::kEmptyMesh, "the mesh has no triangles; a hull tree needs at least one");
  const Place place(mesh);
  const RepairedMesh local = place.brought(mesh);
  Job job(local, options, control);
  HullTree tree = job.treeOver(job.cover());
  for (HullNode& node : tree.nodes) place.takeBack(node.hull);
  return tree;
}

}  // namespace collision_hulls
