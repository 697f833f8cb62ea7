// The flow of the method `certified`; doc/certified.md explains it whole, with proofs, pictures and every constant.
//
// Idea. How far a hull protrudes from the solid can be bounded with certainty (protrusion_oracle.h), and it only grows when the hull grows.
// So pieces are split until every hull fits (top down), hulls are merged while their union still fits (bottom up), and a search dissolves
// and merges again. Splitting alone leaves slivers that merging picks up; merging alone would need leaves that somebody has split well.
//
//   for each way to split (a score for planes, and how much of the tolerance leaves may use):     plan.h
//     leaves = splitIntoLeaves()             splitting.h
//     cover  = mergedBest(leaves)            merging.h; with Effort::kBest, improved() a little
//     keep the cover if it has fewer hulls than the best so far; if it is provably minimal, stop     lower_bound.h
//   cover = improved(best cover)             local_search.h
//   if a hull of the cover may hold a pocket: merge its leaves anew, with a search for pockets in each hull that is tried;
//     if a leaf may hold one: all this once more, with that search
//   Effort::kBest does all this after Effort::kQuick has, and the cover of fewer hulls counts
//   if the mesh falls into too many leaves: all of this at the next larger tolerance that is coarse enough
//   if a limit on hulls asks for fewer: a cut of treeAbove(cover), if it is near                     tree_building.h
//     or all of this at larger tolerances, whichever protrudes less                                  hull_limit.h
//     (where far fewer are asked for, the first way to split shows that, and the rest of the search is left out)
//
// All of this is done about the origin and along axes that turn with the mesh, where coordinates are finest and results hardly depend on
// how the mesh lies.
//
// Cost. With T triangles and K leaves, splitting builds hulls of pieces that halve about log K times, O(T log T log K); it asks O(K) hulls
// of the oracle and scores some hundreds of planes per split on pieces of at most 200 vertices, whatever T is. Merging looks at O(K^2)
// pairs and builds a hull only for those that come out on top. The search is limited by a count of hulls: the result is the same
// everywhere.
//
// A deadline (RunControl) ends the search as such: splitting leaves the rest of the surface whole, and what was merged and proven by then
// counts. Such results do depend on the machine. Coarser covers, which take little time, come first then, so that there is something to
// fall back on.
//
// Tried and given up: clusters of the surface as leaves (as good on smooth shapes, far worse on mechanical parts); one score for all meshes
// (none wins everywhere); ray concavity or volume as the limit (neither bounds protrusion); leaves that use the whole tolerance (merging
// then finds no room, hence the ways differ in their share); repairing hulls that the final check refuses (the oracle proves them before).
#include "collision_hulls/decompose/certified.h"

#include <cmath>
#include <memory>
#include <optional>

#include "base/parallel.h"
#include "collision_hulls/decompose/least_hulls.h"
#include "collision_hulls/decompose/reduce_vertices.h"
#include "decompose/certified/hull_limit.h"
#include "decompose/certified/in_time.h"
#include "decompose/certified/largest_side.h"
#include "decompose/certified/local_search.h"
#include "decompose/certified/lower_bound.h"
#include "decompose/certified/merging.h"
#include "decompose/certified/place.h"
#include "decompose/certified/plan.h"
#include "decompose/certified/tree_building.h"
#include "decompose/certified/unproved_tree.h"
#include "decompose/finest_tolerance.h"
#include "mesh/loose_segments.h"

namespace collision_hulls {

namespace {

// A way that gives more leaves than this, times those of the cover to beat (or times its hulls), is not worth merging.
constexpr double kMoreLeaves = 1.5;
// Multiples of the tolerance that are tried before it where there is a deadline.
constexpr double kCoarsest = 16, kCoarser = 4;
constexpr double kNextTolerance = 2;     // times one at which a mesh falls into too many pieces
constexpr std::size_t kMostToProve = 8;  // hulls; of covers with more, it can hardly ever be proved that none has fewer
// A tree over more hulls than this, times the limit, is a worse cover than one at a larger tolerance, and takes longer. So nobody searches
// for fewer of them.
constexpr std::size_t kFewForTree = 4;
// Progress: splitting and merging take up to the first share of the whole, the search up to the second, the tree the rest. Of each way,
// splitting takes kSplitting; of Effort::kBest, the search of Effort::kQuick kQuickShare.
constexpr double kCovered = 0.7, kSearched = 0.9, kSplitting = 0.8, kQuickShare = 0.1;

/// A stretch of the whole run's progress, for one stage of it.
struct Stretch {
  double from = 0, to = 1;

  Stretch part(double first, double last) const { return {at(first), at(last)}; }
  double at(double share) const { return from + (to - from) * share; }
};

/// One decomposition in progress, in a frame of its own. Hulls are returned in the mesh's frame.
class Job {
 public:
  Job(const RepairedMesh& original, const Solid& solid, const DecomposeOptions& options, LowerBound& least, const RunControl& control)
      : place_(original),
        mesh_(place_.brought(original)),
        options_(place_.brought(options)),
        plan_(planFor(options.effort)),
        tolerance_(options.tolerance),
        least_(least),
        control_(control),
        solid_(mesh_, solid, control),
        oracle_(solid_, boundingBox(mesh_), options.tolerance, searching_, options_.regions) {
    searching_.whole = &control;
    searching_.stops_at_deadline = true;
  }

  /// The steps at the top of this file, without the tree. The cover's hulls, capped, are proven to fit, but for leaves that could not be
  /// split, or not in time. groups_ is then what the cover's groups belong to. Where the mesh would fall into too many pieces, this is done
  /// at the least of some larger tolerances for which it does not.
  Cover cover() {
    Cover result = coverHere();
    const double most = boundingBox(mesh_).diagonal().norm();
    while (surplus_ && tolerance_ < most && !searching_.late()) {
      setTolerance(kNextTolerance * tolerance_);
      groups_.reset();
      result = coverHere();
    }
    return result;
  }

  bool isAtOwnTolerance() const { return tolerance_ == options_.tolerance; }  // after cover(): it needed no larger one

  /// What the deadline cut short or left out; empty: nothing.
  const std::string& untried() const { return untried_; }

  std::vector<ConvexHull> hullsOf(const Cover& cover) const {
    std::vector<ConvexHull> hulls = cappedHulls(cover);
    for (ConvexHull& hull : hulls) hull = place_.takenBack(hull);
    return hulls;
  }

  /// As many hulls as the limit allows in place of a cover of more: those that protrude least, of a cut of the tree above it and of covers
  /// at larger tolerances, which divide the surface anew, in one way each. After the deadline only the tree is cut.
  std::vector<ConvexHull> limited(const Cover& cover) {
    const std::string untried = untried_;
    const double most = boundingBox(mesh_).diagonal().norm();
    BoundedHulls best;
    if (limit() > 1 && !isFarTooMany(cover.size())) best = cutOfTree(cover);
    searching_.stops_at_deadline = true;
    if (!searching_.late()) {
      std::unique_ptr<SurfaceGroups> groups = std::move(groups_);
      best = withinLimit(tolerance_, cover.size(), limit(), most, std::move(best), [&](double at) { return hullsAt(at); });
      groups_ = std::move(groups);
      setTolerance(options_.tolerance);
      untried_ = untried;
      note("covers at larger tolerances");
    }
    if (best.hulls.empty()) best = cutOfTree(cover);
    for (ConvexHull& hull : best.hulls) hull = place_.takenBack(hull);
    return std::move(best.hulls);
  }

  /// After the deadline its bounds are loose.
  HullTree treeOver(const Cover& cover, TreeBounds bounds) {
    HullTree tree = treeHere(cover, bounds);
    for (HullNode& node : tree.nodes) node.hull = place_.takenBack(node.hull);
    return tree;
  }

 private:
  Cover coverHere() {
    Cover first = searched();
    if (surplus_ || isFarTooMany(first.size())) return first;
    bool is_free = true;
    inTime([&] { is_free = freeOfPockets(first); });
    if (is_free) return first;
    oracle_.provePockets();
    std::unique_ptr<SurfaceGroups> groups_of_first = std::move(groups_);
    Cover second = searched();
    if (!searching_.late()) return second;
    groups_ = std::move(groups_of_first);
    return first;
  }

  /// The tree, in the job's frame.
  HullTree treeHere(Cover cover, TreeBounds bounds) {
    searching_.stops_at_deadline = false;
    forEach(cover.size(), [&](std::size_t i) { cover[i].hull = std::make_shared<ConvexHull>(groups_->exactHull(cover[i])); });
    return treeAbove(cover, oracle_, bounds, reporting({kSearched, 1}));
  }

  BoundedHulls cutOfTree(const Cover& cover) {
    const HullTree tree = treeHere(cover, TreeBounds::kEstimated);  // the order of bounds is what counts
    std::vector<ConvexHull> hulls = tree.hullsOf(tree.cutTo(options_.max_hulls));
    forEach(hulls.size(), [&](std::size_t i) { hulls[i] = capped(hulls[i], options_.max_vertices, control_); });
    const double bound = oracle_.bound(hulls);
    return {std::move(hulls), bound};
  }

  BoundedHulls hullsAt(double tolerance) {
    setTolerance(tolerance);
    groups_.reset();
    const Cover cover = this->cover();
    BoundedHulls result{cappedHulls(cover)};
    if (result.hulls.size() <= limit()) inTime([&] { result.bound = oracle_.bound(result.hulls); });
    return result;
  }

  void setTolerance(double tolerance) {
    tolerance_ = tolerance;
    oracle_.setTolerance(tolerance);
  }

  /// Dissolves the hulls that may hold pockets and merges them anew, proving that those hold none. False: some leaf may hold one, so the
  /// surface has to be divided in another way. Of hulls that do not fit anyway nothing is asked.
  bool freeOfPockets(Cover& cover) {
    Cover proven, free, parts;
    std::copy_if(cover.begin(), cover.end(), std::back_inserter(proven), [&](const Group& group) { return groups_->isProven(group); });
    const std::vector<char> may_hold = mayHoldPockets(proven);
    auto next = may_hold.begin();
    for (const Group& group : cover) {
      if (groups_->isProven(group) && *next++ != 0)
        for (Group& part : groups_->byLeaf(group.elements)) parts.push_back(std::move(part));
      else
        free.push_back(group);
    }
    if (parts.empty()) return true;
    const std::vector<char> of_parts = mayHoldPockets(parts);
    if (std::any_of(of_parts.begin(), of_parts.end(), [](char may) { return may != 0; })) return false;
    oracle_.provePockets();
    groups_->keepProofsOf(free);
    free.insert(free.end(), parts.begin(), parts.end());
    cover = merged(std::move(free), *groups_, {MergeCost::kSquares, 0, 0}, Proof::kAtOnce);
    cover = improved(std::move(cover), *groups_, {plan_.evaluations, options_.seed}, [](double) {});
    return true;
  }

  std::vector<ConvexHull> cappedHulls(const Cover& cover) const {
    std::vector<ConvexHull> hulls(cover.size());
    forEach(cover.size(), [&](std::size_t i) { hulls[i] = groups_->cappedHull(cover[i]); });
    return hulls;
  }

  std::vector<char> mayHoldPockets(const Cover& cover) { return oracle_.mayHoldPockets(cappedHulls(cover)); }

  /// A cover at a larger tolerance. No groups: there is none.
  struct Coarse {
    Cover cover;
    std::unique_ptr<SurfaceGroups> groups;
  };

  /// By the plan. Another search may be luckier though it is shorter, so Effort::kBest begins with that of Effort::kQuick.
  Cover searched() {
    Coarse coarse;
    if (control_.until() != RunControl::Time::max()) coarse = coarseCover();
    if (options_.effort != Effort::kBest || !isAtOwnTolerance()) return searchedBy(plan_, std::move(coarse));
    whole_ = {0, kQuickShare};
    Cover quick = searchedBy(planFor(Effort::kQuick), std::move(coarse));
    whole_ = {kQuickShare, 1};
    if (searching_.late() || surplus_ || isFarTooMany(quick.size()) || isMinimal(quick)) return quick;
    std::unique_ptr<SurfaceGroups> groups_of_quick = std::move(groups_);
    divided_ = false;
    Cover best = searchedBy(plan_, {});
    if (divided_ && best.size() <= quick.size()) return best;
    groups_ = std::move(groups_of_quick);
    return quick;
  }

  /// `coarse`: for when time ends before there is a cover.
  Cover searchedBy(const SearchPlan& plan, Coarse coarse) {
    Cover best;
    const double step = kCovered / static_cast<double>(plan.ways.size());
    Stretch stretch{0, step};
    for (const Way& way : plan.ways) {
      if (groups_ && (searching_.late() || !isAtOwnTolerance())) break;
      const bool is_better = best.size() <= way.few && tryWay(plan, way, stretch, best);
      if (surplus_) break;
      if ((divided_ && isFarTooMany(best.size())) || (is_better && untried_.empty() && isMinimal(best))) return best;
      stretch = {stretch.to, stretch.to + step};
    }
    if ((!divided_ || surplus_) && coarse.groups) {
      groups_ = std::move(coarse.groups);
      return coarse.cover;
    }
    if (surplus_) return best;
    if (plan.ways.size() > 1) note("other ways to divide it");
    best = improved(std::move(best), *groups_, {plan.evaluations, options_.seed, leastKnown()}, reporting({kCovered, kSearched}));
    if (plan.evaluations > 0) note("the search for fewer hulls");
    return best;
  }

  /// For when time ends before there is a cover at the tolerance itself: the finest of some that was made in time.
  Coarse coarseCover() {
    Coarse finest;
    for (const double factor : {kCoarsest, kCoarser}) {
      oracle_.setTolerance(factor * tolerance_);
      Coarse next;
      tryWay(plan_, plan_.ways.front(), {0, 0}, next.cover);
      next.groups = std::move(groups_);
      if (searching_.late() && finest.groups) break;
      finest = std::move(next);
    }
    oracle_.setTolerance(tolerance_);
    untried_.clear();
    return finest;
  }

  /// Whether splitting this way gives a cover of fewer hulls than `best`, or the first cover, which then replaces it.
  bool tryWay(const SearchPlan& plan, const Way& way, const Stretch& stretch, Cover& best) {
    // Parts that finish a largest side first hardly merge, so they have to be few from the start.
    const auto enough = static_cast<double>(way.largest_side_first ? best.size() : leaves_);
    const std::size_t most = groups_ ? 1 + static_cast<std::size_t>(kMoreLeaves * enough) : plan.most_leaves;
    const std::optional<HalfSpace> largest_side = way.largest_side_first ? largestSideOfAll(way.leaf_share) : std::nullopt;
    if (way.largest_side_first && !largest_side) return false;
    const std::vector<Leaf> parts = leaves(way, largest_side, most, reporting(stretch.part(0, kSplitting)));
    const bool has_surplus = std::any_of(parts.begin(), parts.end(), [](const Leaf& leaf) { return leaf.is_surplus; });
    if (groups_ && (parts.size() >= most || has_surplus || searching_.late())) return false;  // what is whole would pass for few hulls
    surplus_ = has_surplus;
    divided_ = !searching_.late();
    note("the division of all of the surface within the tolerance");
    auto groups = std::make_unique<SurfaceGroups>(parts, plan.elements, oracle_, options_.max_vertices);
    if (surplus_) {
      best = groups->leaves();
      groups_ = std::move(groups);
      return true;
    }
    Cover cover = mergedBest(groups->leaves(), *groups);
    note("the merging of hulls");
    if (plan.first_evaluations > 0) {
      const SearchOptions search{plan.first_evaluations, options_.seed};
      cover = improved(std::move(cover), *groups, search, reporting(stretch.part(kSplitting, 1)));
    }
    if (groups_ && cover.size() >= best.size()) return false;
    best = std::move(cover);
    groups_ = std::move(groups);
    leaves_ = parts.size();
    return true;
  }

  std::size_t limit() const { return static_cast<std::size_t>(options_.max_hulls); }  // on hulls; 0: none

  /// Whether a limit on hulls asks for so many fewer that a larger tolerance is what can give them.
  bool isFarTooMany(std::size_t hulls) const { return limit() > 0 && hulls > kFewForTree * limit(); }

  /// Hulls, than which no cover has fewer as far as is known. Two are what merging leaves where one, that of everything, was refused.
  std::size_t leastKnown() const { return std::max(std::size_t{2}, isAtOwnTolerance() ? least_.known().value_or(0) : 0); }

  /// Whether it is proved that no cover has fewer hulls.
  bool isMinimal(const Cover& cover) {
    return cover.size() <= leastKnown() || (isAtOwnTolerance() && cover.size() <= kMostToProve && cover.size() <= least(cover));
  }

  /// 0: time ended.
  std::size_t least(const Cover& cover) {
    std::vector<ConvexHull> hulls;
    for (const Group& group : cover) hulls.push_back(place_.takenBack(*group.hull));
    std::size_t result = 0;
    inTime([&] { result = least_(hulls, searching_); });
    return result;
  }

  std::optional<HalfSpace> largestSideOfAll(double share) {
    oracle_.setShare(share);
    std::optional<HalfSpace> result;
    inTime([&] { result = largestSide(withLoose(mesh_), oracle_); });
    oracle_.setShare(1);
    return result;
  }

  std::vector<Leaf> leaves(const Way& way, const std::optional<HalfSpace>& largest_side, std::size_t most,
                           const std::function<void(double)>& progress) {
    oracle_.setShare(way.leaf_share);
    const SplitOptions options{way.weights, options_.max_vertices, options_.fill, most, plan_.most_in_all, largest_side};
    std::vector<Leaf> leaves = splitIntoLeaves(mesh_, oracle_, options, progress);
    oracle_.setShare(1);
    return leaves;
  }

  /// Covers at larger tolerances come when all is done but the tree, and take little time.
  std::function<void(double)> reporting(const Stretch& stretch) const {
    if (!isAtOwnTolerance()) return [](double) {};
    return [this, within = whole_, stretch](double share) { control_.report(within.at(stretch.at(share))); };
  }

  /// After a stage: all that is named after the deadline is untried, be it only in part.
  void note(const std::string& stage) {
    if (searching_.late()) untried_ += (untried_.empty() ? "" : ", ") + stage;
  }

  const Place place_;
  const RepairedMesh mesh_;
  const DecomposeOptions options_;
  const SearchPlan plan_;
  double tolerance_;  // [m] of the cover that is made
  LowerBound& least_;
  const RunControl& control_;
  RunControl searching_;  // ends at the deadline
  const Solid solid_;
  ProtrusionOracle oracle_;
  std::unique_ptr<SurfaceGroups> groups_;  // of the best cover
  std::size_t leaves_ = 0;                 // that it was merged from
  bool divided_ = false;                   // by the last way in time
  bool surplus_ = false;                   // leaves stayed whole, as there were too many
  Stretch whole_;                          // of the run, for what is done now
  std::string untried_;
};

/// For the mesh as it is decomposed, where nobody knows how it was read.
LowerBound boundOf(const RepairedMesh& mesh, const Solid& solid, const DecomposeOptions& options) {
  return LowerBound([&](const std::vector<ConvexHull>& cover, const RunControl& control) -> std::size_t {
    return mesh.mesh.triangles.empty() ? 1 : leastHulls(mesh.mesh, solid, options.tolerance, cover, options.effort, control);
  });
}

void check(const RepairedMesh& mesh, DecomposeOptions options) {
  options.method = Method::kCertified;  // whatever the caller has there
  check(options);
  if (mesh.mesh.triangles.empty() && mesh.loose.empty())
    throw Error(ErrorCode::kEmptyMesh, "the mesh has no triangles; a cover or a hull tree needs at least one");
  expectUsable(options.tolerance, mesh.mesh);
}

HullTree treeOf(const RepairedMesh& mesh, const DecomposeOptions& options, TreeBounds bounds, const RunControl& control) {
  check(mesh, options);
  const Solid solid(mesh, control);
  LowerBound least = boundOf(mesh, solid, options);
  Job job(mesh, solid, options, least, control);
  HullTree tree = job.treeOver(job.cover(), bounds);
  control.report(1);
  return tree;
}

}  // namespace

Decomposition certified(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control) {
  check(mesh, options);
  const Solid solid(mesh, control);
  LowerBound least = boundOf(mesh, solid, options);
  return certified(mesh, solid, options, least, control);
}

Decomposition certified(const RepairedMesh& mesh, const Solid& solid, const DecomposeOptions& options, LowerBound& least,
                        const RunControl& control) {
  Job job(mesh, solid, options, least, control);
  Decomposition result;
  const Cover cover = job.cover();
  result.too_fine = !job.isAtOwnTolerance();
  result.capped = options.max_hulls > 0 && cover.size() > static_cast<std::size_t>(options.max_hulls);
  result.hulls = result.capped ? job.limited(cover) : job.hullsOf(cover);
  result.untried = job.untried();
  control.report(1);
  return result;
}

HullTree hullTree(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control) {
  return treeOf(mesh, options, TreeBounds::kProved, control);
}

HullTree hullTreeWithoutProof(const RepairedMesh& mesh, const DecomposeOptions& options, const RunControl& control) {
  return treeOf(mesh, options, TreeBounds::kDiagonal, control);
}

}  // namespace collision_hulls
