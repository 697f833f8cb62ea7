// Simulated starvation: fewer hulls by dissolving some and merging again.
//
//   while evaluations are left and the last gain is not too long ago:
//     dissolve a group (preferably a small one) and up to three of its neighbours
//     hand elements that another group's hull covers anyway to that group
//     let the rest fall into random halves, single elements or the parts of each leaf, at random
//     merge again with nearby groups, by a random kind of cost and with noise       (on trust: nothing is proven yet)
//     accept if there are fewer groups, or as many and the sum of their squared areas does not fall
//
// That sum is why it works: among covers of equal number, large groups grow at the expense of small ones until one can be dispensed with.
// Proofs are expensive: only a cover with fewer groups is proven, and if the proof fails, the search goes back to the last proven cover.
//
// Evaluations are counted, not seconds: the result is the same on every machine. A move costs a few dozen evaluations, most of which are
// remembered from earlier moves (surface_groups.h). Covers grown from seeds instead were as good and slower.
#include "decompose/certified/local_search.h"

#include <algorithm>

#include "base/random.h"
#include "decompose/certified/in_time.h"
#include "decompose/certified/merging.h"

namespace collision_hulls {

namespace {

constexpr std::size_t kMostNeighbours = 3;        // dissolved together with a group
constexpr double kInHalves = 0.4, kSingly = 0.2;  // probability that dissolved groups fall into random halves, into single elements
constexpr int kNoiseLevels = 4;                   // 0, 0.1, ...
constexpr double kNoiseStep = 0.1;
constexpr long kIdleMovesPerGroup = 20, kIdleMoves = 200;  // moves without gain before the search ends
constexpr long kIdleWork = 2'000'000;   // the same as a limit on groups looked at: with thousands of them each move takes long
constexpr std::size_t kMostGroups = 8;  // most groups to prove minimal: with more it hardly ever succeeds
constexpr double kAreaRounding = 1e-12;

double squaredAreas(const Cover& cover) {
  double sum = 0;
  for (const Group& g : cover) sum += g.area * g.area;
  return sum;
}

class Search {
 public:
  Search(SurfaceGroups& groups, std::uint64_t seed) : groups_(groups), dice_(seed) {}

  /// A random neighbour of a cover in the search space; not proven.
  Cover moved(const Cover& cover) {
    const std::vector<char> dissolve = chosen(cover);
    Cover kept;
    std::vector<int> loose;
    for (std::size_t i = 0; i < cover.size(); ++i) {
      if (dissolve[i])
        loose.insert(loose.end(), cover[i].elements.begin(), cover[i].elements.end());
      else
        kept.push_back(cover[i]);
    }
    std::sort(loose.begin(), loose.end());
    handOver(loose, kept);
    const Cover pieces = parted(loose);
    Cover near, result;
    for (Group& g : kept) {
      const bool is_near = std::any_of(pieces.begin(), pieces.end(), [&](const Group& p) { return !farApart(p, g, groups_.tolerance()); });
      (is_near ? near : result).push_back(std::move(g));
    }
    near.insert(near.end(), pieces.begin(), pieces.end());
    for (Group& g : merged(std::move(near), groups_, randomCost(), Proof::kLater)) result.push_back(std::move(g));
    return result;
  }

 private:
  std::vector<char> chosen(const Cover& cover) {
    std::size_t seed = dice_.below(cover.size());
    const std::size_t other = dice_.below(cover.size());
    if (cover[other].area < cover[seed].area) seed = other;
    std::vector<std::size_t> neighbours;
    for (std::size_t i = 0; i < cover.size(); ++i)
      if (i != seed && !farApart(cover[seed], cover[i], groups_.tolerance())) neighbours.push_back(i);
    std::vector<char> dissolve(cover.size(), 0);
    dissolve[seed] = 1;
    const std::size_t more = std::min(neighbours.size(), dice_.below(kMostNeighbours + 1));
    for (std::size_t i = 0; i < more; ++i) dissolve[neighbours[dice_.below(neighbours.size())]] = 1;
    return dissolve;
  }

  void handOver(std::vector<int>& loose, Cover& kept) const {
    std::vector<int> left;
    for (int e : loose) {
      const auto taker = std::find_if(kept.begin(), kept.end(), [&](const Group& g) { return groups_.covers(g, e); });
      if (taker == kept.end())
        left.push_back(e);
      else
        groups_.add(e, *taker);
    }
    loose = std::move(left);
  }

  Cover parted(const std::vector<int>& loose) {
    const double way = dice_.unit();
    if (way > kInHalves + kSingly) return groups_.byLeaf(loose);
    Cover parts;
    if (way < kInHalves)
      halve(loose, parts);
    else
      for (int e : loose) parts.push_back(groups_.single(e));
    return parts;
  }

  /// Divides at random until each part is likely to fit the tolerance.
  void halve(const std::vector<int>& elements, Cover& parts) {
    if (elements.empty()) return;
    Group whole = groups_.whole(elements);
    if (whole.hull) {
      parts.push_back(std::move(whole));
      return;
    }
    const int direction = static_cast<int>(dice_.below(Widths::kDirections));
    std::vector<std::pair<double, int>> order;
    for (int e : elements) order.push_back({groups_.single(e).widths.middle(direction), e});
    std::sort(order.begin(), order.end());
    const std::size_t first = 1 + dice_.below(order.size() - 1);
    std::vector<int> low, high;
    for (std::size_t i = 0; i < order.size(); ++i) (i < first ? low : high).push_back(order[i].second);
    std::sort(low.begin(), low.end());
    std::sort(high.begin(), high.end());
    halve(low, parts);
    halve(high, parts);
  }

  MergeCost randomCost() {
    MergeCost cost;
    cost.kind = static_cast<MergeCost::Kind>(dice_.below(MergeCost::kSquares + 1));
    cost.noise = kNoiseStep * static_cast<double>(dice_.below(kNoiseLevels));
    cost.seed = dice_.bits();
    return cost;
  }

  SurfaceGroups& groups_;
  Dice dice_;
};

/// Whether each group has an element such that no two of these elements may share a hull: no cover then has fewer groups.
bool leastPossible(const Cover& cover, SurfaceGroups& groups) {
  if (cover.size() > kMostGroups) return false;
  std::vector<int> chosen;
  const auto apart_from_all = [&](int e) {
    return std::all_of(chosen.begin(), chosen.end(), [&](int c) { return !groups.merged(groups.single(c), groups.single(e)).hull; });
  };
  for (const Group& g : cover) {
    const auto e = std::find_if(g.elements.begin(), g.elements.end(), apart_from_all);
    if (e == g.elements.end()) return false;
    chosen.push_back(*e);
  }
  return true;
}

}  // namespace

namespace {

/// Leaves in `cover` the best proven one at any time.
void improve(Cover& cover, SurfaceGroups& groups, const SearchOptions& options, const std::function<void(double)>& progress) {
  const auto is_least = [&] { return cover.size() <= options.enough || leastPossible(cover, groups); };
  if (is_least()) return;
  Search search(groups, options.seed);
  Cover current = cover;  // no more groups than `cover`; only `cover` is proven
  long first = groups.evaluations();
  long idle = 0;
  const auto most_idle = [&] {
    const auto size = static_cast<long>(cover.size());
    return std::min(kIdleMovesPerGroup * size + kIdleMoves, kIdleWork / size);
  };
  while (idle < most_idle()) {
    const long made = groups.evaluations() - first;
    if (made >= options.evaluations) break;
    groups.control().check();
    progress(static_cast<double>(made) / static_cast<double>(options.evaluations));
    ++idle;
    Cover next = search.moved(current);
    if (next.size() >= cover.size()) {
      if (next.size() == cover.size() && squaredAreas(next) >= squaredAreas(current) * (1 - kAreaRounding)) current = std::move(next);
    } else if (groups.proven(next)) {
      cover = current = std::move(next);
      idle = 0;
      const long before = groups.evaluations();
      if (is_least()) break;
      first += groups.evaluations() - before;
    } else {
      current = cover;  // some of its merges were refuted
    }
  }
}

}  // namespace

Cover improved(Cover cover, SurfaceGroups& groups, const SearchOptions& options, const std::function<void(double)>& progress) {
  inTime([&] { improve(cover, groups, options, progress); });
  return cover;
}

}  // namespace collision_hulls
