// Points shared out to few sets: what cliques cannot prove.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "decompose/least/apart.h"
#include "decompose/least/pairs.h"

namespace collision_hulls {

/// Proves that, however some points are shared out to so many sets, one set holds two or three that are apart. Then no so many hulls within
/// the tolerance hold all points. Not thread safe.
class Sharing {
 public:
  static constexpr std::size_t kMostPoints = 64;
  struct Limits {
    long triples;  ///< that are tested; others count as not apart
    long steps;    ///< of a search
  };

  /// `points`: all that may be added.
  Sharing(const Points& points, const PairTest& pairs, const Apart& apart, const Limits& limits);

  /// Adds one of the points, kMostPoints at most.
  void add(std::size_t point);

  /// Whether it is proved that so many sets do not suffice; no, too, if the steps ran out.
  bool needsMoreThan(std::size_t sets);

  /// After that was not proved: of the points that were not added, the one that most of the sets refuse because of a pair; of several,
  /// the one furthest from all that were added.
  std::size_t mostRefused() const;

  std::size_t size() const { return added_.size(); }

 private:
  using Mask = std::uint64_t;  // of added points, by their place in added_
  struct Set {
    Mask members = 0, refused = 0;  // points that are apart from members, as far as known
  };

  bool placeRest(Mask rest);
  std::size_t hardestOf(Mask rest) const;
  bool takes(const Set& set, std::size_t place);
  bool areApart(std::size_t a, std::size_t b, std::size_t c);

  const Points& points_;
  const PairTest& pairs_;
  const Apart& apart_;
  Limits limits_;
  long steps_ = 0;
  std::vector<std::size_t> added_;
  std::vector<Mask> apart_from_;                                        // per point: the added ones that are apart from it
  std::vector<std::array<Mask, kMostPoints>> tested_, apart_from_two_;  // per two added points: third ones that were tested; that are apart
  std::vector<Set> sets_;
};

}  // namespace collision_hulls
