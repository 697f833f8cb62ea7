#include "collision_hulls/decompose/certified.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <memory>

#include "collision_hulls/decompose/reduce_vertices.h"
#include "decompose/local_search.h"
#include "decompose/merging.h"
#include "decompose/tree_building.h"

namespace collision_hulls {

namespace {

constexpr double kLeafShare = 0.7;  // of the tolerance that leaves are cut for: merging has room left

/// How hard to try.
struct Plan {
  std::vector<ScoreWeights> cuts;  // ways to cut that are tried,
  std::size_t few = 0;             // the others only if the first one leaves no more hulls: there each counts, and luck most
  std::size_t elements = 0;        // that leaves are divided into for the search; 0: leaves as they are
  long first_evaluations = 0;      // of the search after each cut,
  long evaluations = 0;            // and of that with the best of them
};

Plan planFor(Effort effort) {
  const ScoreWeights large_sides{0.5, 0.3, 0}, any_side{0.5, 0, 0.1}, little_volume{0.1, 0, 0};
  constexpr std::size_t kFew = 24, kAnyNumber = std::numeric_limits<std::size_t>::max();
  if (effort == Effort::kQuick) return {{large_sides, any_side}, kFew, 0, 0, 400};
  return {{large_sides, any_side, little_volume}, kAnyNumber, 150, 200, 3500};
}

/// The mesh moved so that `middle` is the origin: near it coordinates are finest, however far away the mesh lies.
RepairedMesh about(const Eigen::Vector3d& middle, RepairedMesh mesh) {
  for (Eigen::Vector3d& v : mesh.mesh.vertices) v -= middle;
  for (Eigen::Vector3d& p : mesh.loose) p -= middle;
  return mesh;
}

void moveBack(ConvexHull& hull, const Eigen::Vector3d& middle) {
  for (Eigen::Vector3d& v : hull.vertices) v += middle;
  for (HalfSpace& face : hull.faces) face.offset += face.normal.dot(middle);
}

Eigen::AlignedBox3d boxOf(const RepairedMesh& mesh) {
  Eigen::AlignedBox3d box = boundingBox(mesh.mesh);
  for (const Eigen::Vector3d& p : mesh.loose) box.extend(p);
  return box;
}

/// Reports shares of a stretch of the whole work.
std::function<void(double)> stretch(const RunControl& control, double from, double to) {
  return [&control, from, to](double share) { control.report(from + (to - from) * share); };
}

/// A decomposition under way.
class Job {
 public:
  Job(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control)
      : mesh_(mesh),
        options_(options),
        plan_(planFor(options.effort)),
        control_(control),
        solid_(mesh, control),
        oracle_(solid_, boxOf(mesh), options.tolerance, control) {}

  Cover cover() {
    const std::uint64_t seed = options_.seed;
    Cover best;
    const double step = 0.7 / static_cast<double>(plan_.cuts.size());
    for (std::size_t i = 0; i < plan_.cuts.size() && best.size() <= plan_.few; ++i) {
      const double from = step * static_cast<double>(i);
      auto mine = std::make_unique<SurfaceGroups>(leaves(plan_.cuts[i], stretch(control_, from, from + 0.8 * step)), plan_.elements,
                                                  oracle_, options_.max_vertices);
      Cover cover = mergedBest(mine->leaves(), *mine);
      if (plan_.first_evaluations > 0)
        cover = improved(std::move(cover), *mine, {plan_.first_evaluations, seed}, stretch(control_, from + 0.8 * step, from + step));
      if (groups_ && cover.size() >= best.size()) continue;
      best = std::move(cover);
      groups_ = std::move(mine);
    }
    return improved(std::move(best), *groups_, {plan_.evaluations, seed}, stretch(control_, 0.7, 0.9));
  }

  std::vector<ConvexHull> hullsOf(const Cover& cover) const {
    std::vector<ConvexHull> hulls(cover.size());
    tbb::parallel_for(std::size_t{0}, cover.size(), [&](std::size_t i) { hulls[i] = groups_->cappedHull(cover[i]); });
    return hulls;
  }

  HullTree treeOver(Cover cover) {
    tbb::parallel_for(std::size_t{0}, cover.size(),
                      [&](std::size_t i) { cover[i].hull = std::make_shared<ConvexHull>(groups_->exactHull(cover[i])); });
    return treeAbove(cover, oracle_, stretch(control_, 0.9, 1));
  }

 private:
  std::vector<Leaf> leaves(const ScoreWeights& weights, const std::function<void(double)>& progress) {
    oracle_.setShare(kLeafShare);
    std::vector<Leaf> leaves = cutIntoLeaves(mesh_, oracle_, {weights, options_.max_vertices, options_.fill}, progress);
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
  const Eigen::Vector3d middle = boxOf(original).center();
  const RepairedMesh mesh = about(middle, original);
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
  for (ConvexHull& hull : result.hulls) moveBack(hull, middle);
  control.report(1);
  return result;
}

HullTree hullTree(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control) {
  if (!(options.tolerance > 0 && std::isfinite(options.tolerance)))
    throw Error(ErrorCode::kBadOption, "tolerance is " + std::to_string(options.tolerance) + " m; it must be a positive length");
  if (mesh.mesh.triangles.empty() && mesh.loose.empty())
    throw Error(ErrorCode::kEmptyMesh, "the mesh has no triangle; a hull tree needs at least one");
  const Eigen::Vector3d middle = boxOf(mesh).center();
  const RepairedMesh local = about(middle, mesh);
  Job job(local, options, control);
  HullTree tree = job.treeOver(job.cover());
  for (HullNode& node : tree.nodes) moveBack(node.hull, middle);
  return tree;
}

}  // namespace collision_hulls
