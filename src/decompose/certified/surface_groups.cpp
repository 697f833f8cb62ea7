// Groups are identified by a hash of their set of elements (an XOR of random keys, so that the key of a union is the XOR of the parts'),
// and everything learned about a set's hull is remembered under that key: most of a search's questions are repetitions.
//
// Two grades of answer. Quick: the hull of few, likely extreme points per element, against remembered intruders and the octree. Proof: the
// hull of all points, with its vertices capped as it will be written. A quick "no" is final, since the hull of some of the points lies in
// the hull of all; a quick "yes" is on trust until proven. What was proven is kept to the last bit, so that it is what gets written.
#include "decompose/certified/surface_groups.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>
#include <unordered_set>

#include "base/at.h"
#include "base/parallel.h"
#include "base/random.h"
#include "collision_hulls/decompose/reduce_vertices.h"

namespace collision_hulls {

namespace {

constexpr double kOnHalvingPlane = 1e-9;  // as a share of the largest extent
constexpr double kSmallest = 1e-6;        // the same: smaller pieces are not halved
constexpr std::ptrdiff_t kAtOnce = 2;     // groups proven in parallel: if the first is refuted, work on the other is wasted

Eigen::Vector3d meanOf(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

struct Part {
  double area;
  int leaf, number;
  Block block;

  bool operator<(const Part& o) const { return std::tie(area, o.leaf, o.number) < std::tie(o.area, leaf, number); }  // largest on top
};

/// A hull that had to be thickened contributes its piece's own points. Directions are spaced so that, on a round hull of this size, up to a
/// third of the tolerance may lie between them; what then wrongly seems to fit is refuted by its proof.
Element elementOf(const SurfacePiece& piece, const ConvexHull& hull, int leaf, double tolerance) {
  constexpr double kDirectionsPerTolerance = 4, kFewest = 100, kMost = 2000;
  const double directions = kDirectionsPerTolerance * boundingBox(hull).diagonal().norm() / tolerance;
  Element element;
  element.points = hull.thickness > 0 ? piece.vertices : hull.vertices;
  element.likely =
      hull.thickness > 0 ? piece.vertices : thinned(hull, static_cast<std::size_t>(std::clamp(directions, kFewest, kMost))).vertices;
  element.area = area(piece);
  element.leaf = leaf;
  return element;
}

}  // namespace

std::vector<Element> elementsOf(const std::vector<Leaf>& leaves, std::size_t count, double tolerance, const RunControl& control) {
  std::vector<Element> elements;
  if (count <= leaves.size()) {
    for (std::size_t i = 0; i < leaves.size(); ++i)
      elements.push_back(elementOf(leaves[i].block.surface, leaves[i].hull, static_cast<int>(i), tolerance));
    return elements;
  }
  Eigen::AlignedBox3d box;
  std::priority_queue<Part> large;
  int number = 0;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    large.push({area(leaves[i].block.surface), static_cast<int>(i), number++, leaves[i].block});
    box.extend(boundingBox(leaves[i].hull));
  }
  std::vector<Part> done;
  while (!large.empty()) {
    Part part = large.top();
    large.pop();
    std::vector<Block> blocks;
    const double extent = box.sizes().maxCoeff();
    const bool large_enough = boundingBox(part.block.surface).sizes().maxCoeff() > kSmallest * extent;
    if (large_enough && large.size() + done.size() + 1 < count) blocks = halves(part.block, kOnHalvingPlane * extent, control);
    if (blocks.size() < 2) {
      done.push_back(std::move(part));
      continue;
    }
    for (Block& block : blocks) {
      const double size = area(block.surface);
      large.push({size, part.leaf, number++, std::move(block)});
    }
  }
  std::sort(done.begin(), done.end(), [](const Part& a, const Part& b) { return std::tie(a.leaf, a.number) < std::tie(b.leaf, b.number); });
  for (const Part& part : done)
    elements.push_back(
        elementOf(part.block.surface, roughHull(part.block.surface.vertices, Corners::kNeeded, control), part.leaf, tolerance));
  return elements;
}

bool farApart(const Group& a, const Group& b, double tolerance) {
  constexpr double kNear = 2;  // in tolerances: a hull across a wider gap protrudes, unless solid lies in between
  return a.widths.gap(b.widths) > kNear * tolerance;
}

SurfaceGroups::SurfaceGroups(const std::vector<Leaf>& leaves, std::size_t element_count, ProtrusionOracle& oracle, int max_vertices)
    : oracle_(oracle), max_vertices_(max_vertices) {
  to_the_end_.whole = &oracle.control();
  elements_ = elementsOf(leaves, element_count, oracle.tolerance(), to_the_end_);
  for (const Leaf& leaf : leaves) leaves_.push_back({leaf.hull, leaf.reduced, leaf.fits, 0});
  for (const Element& e : elements_) ++leaves_[at(e.leaf)].elements;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    Group group;
    group.elements = {static_cast<int>(i)};
    group.key = mixed(i);
    group.area = elements_[i].area;
    for (const Eigen::Vector3d& p : elements_[i].points) group.widths.extend(p);
    singles_.push_back(std::move(group));
  }
  forEach(singles_.size(), [&](std::size_t i) {
    singles_[i].hull = std::make_shared<ConvexHull>(roughHull(elements_[i].likely, Corners::kNeeded, to_the_end_));
  });
}

Cover SurfaceGroups::leaves() {
  std::vector<int> all(elements_.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  return byLeaf(all);
}

Cover SurfaceGroups::byLeaf(const std::vector<int>& elements) {
  std::map<int, std::vector<int>> leaves;
  for (int e : elements) leaves[elements_[at(e)].leaf].push_back(e);
  Cover parts;
  for (const auto& [leaf, mine] : leaves) {
    if (mine.size() == 1) {
      parts.push_back(single(mine[0]));
      continue;
    }
    Group part = groupOf(mine);
    Known& known = known_[part.key];
    if (!known.hull) known.hull = std::make_shared<ConvexHull>(roughHull(likelyPointsOf(mine), Corners::kNeeded, to_the_end_));
    known.asked = known.may_fit = true;
    part.hull = known.hull;
    parts.push_back(std::move(part));
  }
  return parts;
}

Group SurfaceGroups::groupOf(const std::vector<int>& elements) const {
  Group group;
  group.elements = elements;
  for (int e : elements) {
    group.key ^= single(e).key;
    group.area += single(e).area;
    group.widths = group.widths.merged(single(e).widths);
  }
  return group;
}

std::vector<Eigen::Vector3d> SurfaceGroups::pointsOf(const std::vector<int>& elements) const {
  std::vector<Eigen::Vector3d> points;
  for (int e : elements) points.insert(points.end(), elements_[at(e)].points.begin(), elements_[at(e)].points.end());
  return points;
}

std::vector<Eigen::Vector3d> SurfaceGroups::likelyPointsOf(const std::vector<int>& elements) const {
  std::vector<Eigen::Vector3d> points;
  for (int e : elements) points.insert(points.end(), elements_[at(e)].likely.begin(), elements_[at(e)].likely.end());
  return points;
}

bool SurfaceGroups::isWholeLeaf(const Group& group) const {
  const int leaf = elements_[at(group.elements.front())].leaf;
  const auto of_leaf = [&](int e) { return elements_[at(e)].leaf == leaf; };
  return group.elements.size() == leaves_[at(leaf)].elements && std::all_of(group.elements.begin(), group.elements.end(), of_leaf);
}

ConvexHull SurfaceGroups::hullOf(const Group& group, const RunControl& control) const {
  if (isWholeLeaf(group)) return leaves_[at(elements_[at(group.elements.front())].leaf)].hull;
  return roughHull(pointsOf(group.elements), Corners::kNeeded, control);
}

ConvexHull SurfaceGroups::exactHull(const Group& group) const {
  ConvexHull hull = hullOf(group, to_the_end_);
  return exceedsCap(hull, max_vertices_) ? hull : convexHull(pointsOf(group.elements), to_the_end_);
}

std::shared_ptr<const ConvexHull> SurfaceGroups::reducedHull(const Group& group) const {
  if (isWholeLeaf(group)) return leaves_[at(elements_[at(group.elements.front())].leaf)].reduced;
  const auto known = known_.find(group.key);
  return known == known_.end() ? nullptr : known->second.reduced;
}

ConvexHull SurfaceGroups::cappedHull(const Group& group) const {
  if (const auto reduced = reducedHull(group)) return *reduced;
  return capped(exactHull(group), max_vertices_, to_the_end_);
}

void SurfaceGroups::ask(const std::vector<Eigen::Vector3d>& points, Known& known) {
  known.asked = true;
  ++evaluations_;
  if (oracle_.refutes(points)) return;
  auto hull = std::make_shared<ConvexHull>(roughHull(points, Corners::kNeeded, control()));
  known.may_fit = oracle_.mayFit(*hull);
  if (known.may_fit) known.hull = std::move(hull);
}

Group SurfaceGroups::whole(const std::vector<int>& elements) {
  if (elements.size() == 1) return single(elements[0]);
  Group group = groupOf(elements);
  Known& known = known_[group.key];
  if (!known.asked) ask(likelyPointsOf(elements), known);
  if (known.may_fit) group.hull = known.hull;
  return group;
}

Group SurfaceGroups::merged(const Group& a, const Group& b) {
  Group both;
  both.key = a.key ^ b.key;
  Known& known = known_[both.key];
  if (!known.asked && farApart(a, b, tolerance()) && !hasSolidBetween(a, b)) known.asked = true;
  if (!known.asked) {
    std::vector<Eigen::Vector3d> points = a.hull->vertices;
    points.insert(points.end(), b.hull->vertices.begin(), b.hull->vertices.end());
    ask(points, known);
  }
  if (!known.may_fit) return both;
  both.elements.resize(a.elements.size() + b.elements.size());
  std::merge(a.elements.begin(), a.elements.end(), b.elements.begin(), b.elements.end(), both.elements.begin());
  both.area = a.area + b.area;
  both.widths = a.widths.merged(b.widths);
  both.hull = known.hull;
  return both;
}

bool SurfaceGroups::needsProof(const Group& group) const {
  if (isWholeLeaf(group)) return false;
  const auto known = known_.find(group.key);
  return known == known_.end() || !known->second.asked || (known->second.may_fit && !known->second.proven);
}

/// Whether all sample points between two groups are within the tolerance of the solid; if not, no common hull fits.
bool SurfaceGroups::hasSolidBetween(const Group& a, const Group& b) const {
  constexpr std::size_t kSamples = 16;
  const auto fits = [&](const Eigen::Vector3d& p) { return oracle_.solid().isWithin(tolerance(), p); };
  const std::vector<Eigen::Vector3d>&of_a = a.hull->vertices, &of_b = b.hull->vertices;
  const Eigen::Vector3d from = meanOf(of_a), to = meanOf(of_b);
  for (const double share : {0.5, 0.25, 0.75})
    if (!fits(from + share * (to - from))) return false;
  for (std::uint64_t i = 0; i < kSamples; ++i)
    if (!fits((of_a[mixed(2 * i) % of_a.size()] + of_b[mixed(2 * i + 1) % of_b.size()]) / 2)) return false;
  return true;
}

bool SurfaceGroups::isProven(const Group& group) const {
  if (isWholeLeaf(group)) return leaves_[at(elements_[at(group.elements.front())].leaf)].fits;
  const auto known = known_.find(group.key);
  return known != known_.end() && known->second.proven;
}

bool SurfaceGroups::proven(const Group& group) {
  prove({&group});
  return isWholeLeaf(group) || known_.at(group.key).proven;
}

void SurfaceGroups::keepProofsOf(const Cover& cover) {
  std::unordered_set<std::uint64_t> kept;
  for (const Group& group : cover) kept.insert(group.key);
  for (auto& [key, known] : known_)
    if (kept.count(key) == 0) known.proven = false, known.reduced = nullptr;
}

void SurfaceGroups::prove(std::vector<const Group*> groups) {
  groups.erase(std::remove_if(groups.begin(), groups.end(), [&](const Group* g) { return !needsProof(*g); }), groups.end());
  std::vector<Candidate> candidates(groups.size());
  forEach(groups.size(), [&](std::size_t i) { candidates[i] = {hullOf(*groups[i], oracle_.control()), false}; });
  // A capped hull contains the uncapped one: whatever refutes the latter refutes the former.
  for (Candidate& c : candidates) c.is_reduced = exceedsCap(c.hull, max_vertices_) && oracle_.mayWellFit(c.hull);
  forEach(groups.size(), [&](std::size_t i) {
    if (candidates[i].is_reduced) candidates[i].hull = reduceVertices(candidates[i].hull, max_vertices_, oracle_.control());
  });
  std::vector<const ConvexHull*> hulls;
  for (const Candidate& c : candidates) hulls.push_back(&c.hull);
  const std::vector<char> fits = oracle_.fit(hulls);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Known& known = known_[groups[i]->key];
    known.asked = true;
    known.proven = known.may_fit = fits[i] != 0;
    if (known.may_fit && !known.hull) known.hull = groups[i]->hull;
    known.proven = known.proven && (candidates[i].is_reduced || !exceedsCap(candidates[i].hull, max_vertices_));
    if (known.proven && candidates[i].is_reduced) known.reduced = std::make_shared<ConvexHull>(std::move(candidates[i].hull));
  }
}

/// Widest first, because those are refuted most often.
bool SurfaceGroups::proven(const Cover& cover) {
  std::vector<const Group*> order;
  for (const Group& group : cover) order.push_back(&group);
  std::stable_sort(order.begin(), order.end(), [](const Group* a, const Group* b) { return a->widths.mean() > b->widths.mean(); });
  for (auto begin = order.cbegin(), end = begin; begin != order.cend(); begin = end) {
    end += std::min(kAtOnce, order.cend() - begin);
    prove({begin, end});
    if (!std::all_of(begin, end, [&](const Group* group) { return proven(*group); })) return false;
  }
  return true;
}

bool SurfaceGroups::covers(const Group& group, int element) const {
  if (!group.widths.contains(single(element).widths)) return false;
  const std::vector<Eigen::Vector3d>& points = elements_[at(element)].likely;
  return std::all_of(points.begin(), points.end(), [&](const Eigen::Vector3d& p) { return holds(*group.hull, p); });
}

void SurfaceGroups::add(int element, Group& group) const {
  group.elements.insert(std::lower_bound(group.elements.begin(), group.elements.end(), element), element);
  group.key ^= single(element).key;
  group.area += single(element).area;
}

}  // namespace collision_hulls
