// split(piece):
//   H = hull of the piece; if H stays within the tolerance: a leaf
//   (a hull over the vertex cap must do so after it is capped as well; if it does not, the piece is halved)
//   if the piece falls into components: split(each)
//   else choose the candidate plane with the best score and split(both sides)
//   (or first, on request, the one that finishes the largest possible side)
//
// A plane's score counts the intruders (points of H outside the solid by more than the tolerance) that remain in either side's hull. Volume
// that neither side's hull contains improves the score, and so does a finished side. Scores are computed on simplified pieces: a rough one
// for all planes, a finer one for the best of them. The split is made on the piece itself; it divides triangles, so the border between two
// pieces runs where the plane is, not where the mesher put edges. No cap is needed: for a closed part the plane's section lies in the hull
// of its rim.
//
// Leaves use only a share of the tolerance (ProtrusionOracle::setShare), which leaves merging some room. Large parts are split in parallel
// by oracles of their own; the division depends on the mesh alone, and so does the result. A piece that no plane divides, or that is split
// too deep or into too many leaves, becomes a leaf as it is: the certificate then says that it protrudes.
//
// Each level of recursion builds hulls of all points, O(n log n), and scores a few hundred planes on at most kRoughVertices vertices.
#include "decompose/certified/splitting.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <mutex>

#include "base/parallel.h"
#include "collision_hulls/decompose/reduce_vertices.h"
#include "decompose/certified/in_time.h"
#include "decompose/certified/largest_side.h"
#include "decompose/certified/split_planes.h"
#include "geometry/lean.h"
#include "mesh/loose_segments.h"

namespace collision_hulls {

namespace {

constexpr std::size_t kVertices = 200, kRoughVertices = 50;  // of the simplified pieces
constexpr std::size_t kIntruders = 100, kRoughThinning = 3;  // for scoring; the rough piece uses only every third
constexpr std::size_t kFinalists = 8;                        // planes scored on the finer piece
constexpr std::size_t kEdgesOfPiece = 4000;                  // larger pieces show the reflex edges of their simplified form
constexpr std::size_t kSome = 3000;                          // points of a piece whose hull is tried before that of all points
constexpr std::size_t kThin = 300;                           // vertices of a hull that is searched for intruders
constexpr double kSlim = 0.01, kSmall = 0.01;   // in tolerances and as a share of the area: a side this slim and small is not worth a split
constexpr double kOnPlane = 1e-9;               // in extents of the whole mesh
constexpr double kAlongPlane = 0.01;            // in tolerances
constexpr int kHalveFrom = 40, kDeepest = 200;  // depth of recursion from which pieces are simply halved, and where it ends
constexpr std::size_t kApart = 1000, kShares = 16;  // triangles, and shares of them all, that make a part worth a thread

using Intruders = std::vector<OutsideDistance::Intruder>;

/// At most kSome of the points, evenly spread over their order.
std::vector<Eigen::Vector3d> some(const std::vector<Eigen::Vector3d>& points) {
  if (points.size() <= kSome) return points;
  std::vector<Eigen::Vector3d> result;
  for (std::size_t i = 0; i < kSome; ++i) result.push_back(points[i * points.size() / kSome]);
  return result;
}

std::size_t trianglesOf(const std::vector<Block>& blocks) {
  std::size_t sum = 0;
  for (const Block& block : blocks) sum += block.surface.triangles.size();
  return sum;
}

double areaOf(const std::vector<Block>& blocks) {
  double sum = 0;
  for (const Block& block : blocks) sum += area(block.surface);
  return sum;
}

Eigen::AlignedBox3d boxOf(const std::vector<Block>& blocks) {
  Eigen::AlignedBox3d box;
  for (const Block& block : blocks) box.extend(boundingBox(block.surface));
  return box;
}

/// In an order that does not depend on that of the triangles.
std::vector<Block> inOrder(std::vector<Block> blocks) {
  if (blocks.size() < 2) return blocks;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < blocks.size(); ++i) order.push_back({lean(boundingBox(blocks[i].surface).center(), 1), i});
  std::sort(order.begin(), order.end());
  std::vector<Block> result;
  for (const auto& [place, i] : order) result.push_back(std::move(blocks[i]));
  return result;
}

/// The share of the area that is finished. Thread safe.
class Done {
 public:
  Done(double whole, const std::function<void(double)>& progress) : whole_(whole), progress_(progress) {}
  void add(double area) {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ += area;
    if (whole_ > 0) progress_(std::min(1.0, done_ / whole_));
  }

 private:
  std::mutex mutex_;
  const double whole_;
  double done_ = 0;
  const std::function<void(double)>& progress_;
};

class Splitting {
 public:
  Splitting(ProtrusionOracle& oracle, const SplitOptions& options, double on_plane, std::size_t apart, double budget, Done& done)
      : oracle_(oracle), options_(options), on_plane_(on_plane), apart_(apart), budget_(budget), done_(done) {}

  /// Splits large blocks in parallel, half of them with an oracle of their own. The halves do not depend on the number of threads, and so
  /// neither does the result.
  void run(std::vector<Block> blocks, int depth) {
    if (blocks.size() == 1) return run(std::move(blocks[0]), depth);
    std::vector<Block> others(std::make_move_iterator(blocks.begin() + static_cast<std::ptrdiff_t>(blocks.size() / 2)),
                              std::make_move_iterator(blocks.end()));
    blocks.resize(blocks.size() / 2);
    if (std::min(trianglesOf(blocks), trianglesOf(others)) < apart_) {
      run(std::move(blocks), depth);
      return run(std::move(others), depth);
    }
    ProtrusionOracle oracle = oracle_.forPart(boxOf(others));
    const double mine = areaOf(blocks), theirs = areaOf(others), left = budget_ - static_cast<double>(leaves.size());
    const double share = mine + theirs > 0 ? left * theirs / (mine + theirs) : left / 2;
    Splitting beside(oracle, options_, on_plane_, apart_, share, done_);
    budget_ -= share;
    atOnce([&] { run(std::move(blocks), depth); }, [&] { beside.run(std::move(others), depth); });
    oracle_.learn(oracle);
    budget_ += share;
    leaves.insert(leaves.end(), std::make_move_iterator(beside.leaves.begin()), std::make_move_iterator(beside.leaves.end()));
  }

  std::vector<Leaf> leaves;

 private:
  /// One block. Where time ends it is left whole.
  void run(Block block, int depth) {
    Leaf whole;  // but for its block
    std::vector<Block> parts;
    if (!inTime([&] { parts = divided(block, depth, whole); })) whole = {{}, hullOfRest(block.surface.vertices)};
    if (parts.size() < 2) {
      whole.block = std::move(block);
      return leaf(std::move(whole));
    }
    block = {};
    run(std::move(parts), depth + 1);
  }

  /// The parts of a block, or less than two, and then its hull. The hull that refutes a piece need not be the piece's: that of some points
  /// lies in it, and that of few vertices (`thin`) in that. So the whole hull is built only where the smaller ones are clear of intruders,
  /// and proven only then.
  std::vector<Block> divided(const Block& block, int depth, Leaf& whole) {
    const std::vector<Eigen::Vector3d>& points = block.surface.vertices;
    ConvexHull& hull = whole.hull = hullOf(some(points));
    const ConvexHull thin = thinned(hull, kThin);
    const double reach = oracle_.reach(thin);
    const bool clear = !std::isinf(reach), is_full = isFull(), is_last = depth >= kDeepest || is_full;
    const auto complete = [&] {
      if (points.size() > kSome) hull = hullOf(points);
    };
    if (clear || is_last) complete();
    const bool over_cap = clear && exceedsCap(hull, options_.max_vertices);
    const auto reduced = over_cap ? std::make_shared<const ConvexHull>(reduceVertices(hull, options_.max_vertices, control())) : nullptr;
    // If `thin` is the whole hull, its reach is known already.
    const bool is_asked = !reduced && points.size() <= kSome && thin.vertices.size() == hull.vertices.size();
    const bool fits = clear && (is_asked ? oracle_.fitsWithin(hull, reach) : oracle_.fits(reduced ? *reduced : hull));
    whole.fits = fits;
    whole.is_surplus = !fits && is_full;
    if (fits) whole.reduced = reduced;
    if (fits || is_last) return {};
    std::vector<Block> parts = inOrder(components(block, control()));
    if (parts.size() == 1)
      parts = over_cap || depth >= kHalveFrom ? halves(block, on_plane_, control()) : bestSplit(block, clear ? hull : thin, depth);
    if (parts.size() == 1) complete();
    return parts;
  }

  const RunControl& control() const { return oracle_.control(); }

  ConvexHull hullOf(const std::vector<Eigen::Vector3d>& points) const { return roughHull(points, Corners::kNeeded, control()); }

  /// The same after the deadline.
  ConvexHull hullOfRest(const std::vector<Eigen::Vector3d>& points) const {
    RunControl to_the_end;
    to_the_end.whole = &control();
    return roughHull(points, Corners::kNeeded, to_the_end);
  }

  bool isFull() const { return leaves.size() >= options_.most_leaves || static_cast<double>(leaves.size()) >= budget_; }

  void leaf(Leaf leaf) {
    done_.add(area(leaf.block.surface));
    leaves.push_back(std::move(leaf));
  }

  /// Both sides of the best plane that divides the piece; the piece alone if no plane does.
  std::vector<Block> bestSplit(const Block& block, const ConvexHull& hull, int depth) {
    const SurfacePiece& piece = block.surface;
    if (options_.largest_side)
      if (const auto plane = depth == 0 ? options_.largest_side : largestSide(piece, oracle_)) {
        std::vector<Block> parts = parted(block, *plane, on_plane_, control());
        if (parts.size() > 1) return parts;
      }
    const Intruders intruders = oracle_.intruders(hull, kIntruders);
    Intruders few;
    for (std::size_t i = 0; i < intruders.size(); i += kRoughThinning) few.push_back(intruders[i]);
    const PlaneScore fine(piece, kVertices, intruders, volume(hull), options_.weights, control());
    const PlaneScore rough(fine.piece(), kRoughVertices, few, volume(hull), options_.weights, control());
    const bool own_edges = piece.triangles.size() <= kEdgesOfPiece;
    std::vector<HalfSpace> planes = splitPlanes(own_edges ? piece : fine.piece(), intruders, oracle_.solid(), oracle_.tolerance());
    if (planes.size() > kFinalists) planes = rough.best(planes, kFinalists);
    for (const HalfSpace& plane : fine.best(planes, kFinalists)) {
      std::vector<Block> parts = parted(block, plane, on_plane_, control());
      if (parts.size() > 1 && !isPared(parts, plane)) return parts;  // a plane that divides the simplified piece may miss the real one
    }
    return halves(block, on_plane_, control());
  }

  /// Whether one side is so slim and small that nothing is gained: such splits, repeated, only multiply triangles.
  bool isPared(const std::vector<Block>& sides, const HalfSpace& plane) const {
    const auto slim = [&](const SurfacePiece& side) {
      return std::all_of(side.vertices.begin(), side.vertices.end(),
                         [&](const Eigen::Vector3d& v) { return std::abs(plane.distance(v)) < kSlim * oracle_.tolerance(); });
    };
    const double first = area(sides[0].surface), second = area(sides[1].surface);
    return std::min(first, second) < kSmall * (first + second) && slim(sides[first < second ? 0 : 1].surface);
  }

  ProtrusionOracle& oracle_;
  const SplitOptions options_;
  const double on_plane_;
  const std::size_t apart_;  // [triangles]
  double budget_;            // [leaves]
  Done& done_;
};

}  // namespace

std::vector<Leaf> splitIntoLeaves(const RepairedMesh& mesh, ProtrusionOracle& oracle, const SplitOptions& options,
                                  const std::function<void(double)>& progress) {
  SurfacePiece whole = withLoose(mesh);
  Done done(area(whole), progress);
  // Where only the surface counts, faces along a plane need not be cut by it because their vertices are not quite in it.
  const double on_plane = options.fill ? kOnPlane * boundingBox(whole).sizes().maxCoeff() : kAlongPlane * oracle.tolerance();
  Splitting splitting(oracle, options, on_plane, std::max(kApart, whole.triangles.size() / kShares),
                      static_cast<double>(options.most_in_all), done);
  const Cell cell = options.fill ? Cell(boundingBox(whole), oracle.solid()) : Cell();
  std::vector<Block> blocks;
  blocks.push_back({std::move(whole), cell});
  splitting.run(std::move(blocks), 0);
  return std::move(splitting.leaves);
}

}  // namespace collision_hulls
