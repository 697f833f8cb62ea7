// Backtracking, as for colouring a graph (Brelaz, "New methods to color the vertices of a graph", 1979): the point that most sets refuse
// goes next, into each set in turn that takes it; of empty sets only the first, as all are alike. Triples are tested when a point comes
// to two others, and the answers are remembered. Exponential in the number of points; a search without an answer proves nothing.
#include "decompose/least/sharing.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/parallel.h"

namespace collision_hulls {

namespace {

std::uint64_t bit(std::size_t place) {
  return std::uint64_t{1} << place;
}

template <typename Visit>
void forEachIn(std::uint64_t mask, const Visit& visit) {
  for (std::size_t place = 0; mask != 0; ++place, mask >>= 1)
    if ((mask & 1) != 0) visit(place);
}

}  // namespace

Sharing::Sharing(const Points& points, const PairTest& pairs, const Apart& apart, const Limits& limits)
    : points_(points), pairs_(pairs), apart_(apart), limits_(limits), apart_from_(points.size()) {}

void Sharing::add(std::size_t point) {
  const Mask place = bit(added_.size());
  added_.push_back(point);
  tested_.push_back({});
  apart_from_two_.push_back({});
  forEach(points_.size(), [&](std::size_t other) {
    if (pairs_(point, other)) apart_from_[other] |= place;
  });
}

bool Sharing::needsMoreThan(std::size_t sets) {
  sets_.assign(sets, {});
  steps_ = 0;
  const Mask all = added_.size() == kMostPoints ? ~Mask{0} : bit(added_.size()) - 1;
  return !placeRest(all) && steps_ < limits_.steps;
}

std::size_t Sharing::mostRefused() const {
  std::size_t best = 0;
  std::pair<long, double> most{-1, 0};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const long refusals = std::count_if(sets_.begin(), sets_.end(), [&](const Set& set) { return (set.members & apart_from_[i]) != 0; });
    if (refusals < most.first) continue;
    double away = std::numeric_limits<double>::infinity();
    for (const std::size_t j : added_) away = std::min(away, (points_[i] - points_[j]).squaredNorm());
    if (away > 0 && std::pair(refusals, away) > most) most = {refusals, away}, best = i;
  }
  return best;
}

/// Whether `rest` can be shared out, too; if so, sets_ say how.
bool Sharing::placeRest(Mask rest) {
  if (rest == 0) return true;
  const std::size_t place = hardestOf(rest);
  for (Set& set : sets_) {
    if (++steps_ >= limits_.steps) return false;
    const Set before = set;
    if (!takes(set, place)) continue;
    set.members |= bit(place);
    set.refused |= apart_from_[added_[place]];
    forEachIn(before.members, [&](std::size_t other) { set.refused |= apart_from_two_[place][other]; });
    if (placeRest(rest & ~bit(place))) return true;
    set = before;
    if (before.members == 0) break;
  }
  return false;
}

/// The point that most sets refuse; of several, the one that was added first.
std::size_t Sharing::hardestOf(Mask rest) const {
  std::size_t best = 0;
  long most = -1;
  forEachIn(rest, [&](std::size_t place) {
    const long refusals = std::count_if(sets_.begin(), sets_.end(), [&](const Set& set) { return (set.refused & bit(place)) != 0; });
    if (refusals > most) most = refusals, best = place;
  });
  return best;
}

/// Whether the set stays free of points that are apart.
bool Sharing::takes(const Set& set, std::size_t place) {
  if ((set.refused & bit(place)) != 0) return false;
  bool fits = true;
  forEachIn(set.members,
            [&](std::size_t a) { forEachIn(set.members & (bit(a) - 1), [&](std::size_t b) { fits = fits && !areApart(place, a, b); }); });
  return fits;
}

bool Sharing::areApart(std::size_t a, std::size_t b, std::size_t c) {
  if ((tested_[a][b] & bit(c)) == 0) {
    if (limits_.triples-- <= 0) return false;
    const bool apart = apart_(points_[added_[a]], points_[added_[b]], points_[added_[c]]);
    for (const auto& [x, y, z] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
      tested_[x][y] |= bit(z), tested_[y][x] |= bit(z);
      if (apart) apart_from_two_[x][y] |= bit(z), apart_from_two_[y][x] |= bit(z);
    }
  }
  return (apart_from_two_[a][b] & bit(c)) != 0;
}

}  // namespace collision_hulls
