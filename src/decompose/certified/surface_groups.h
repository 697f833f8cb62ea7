// Who covers what. An *element* is a piece of surface that is not divided further; a *group* is a
// set of elements covered by one hull; a *cover* is a list of groups with every element in one of
// them. Also a memory of which groups may share a hull. As in protrusion_oracle.h, a hull *fits* if
// it protrudes no further than the tolerance.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "decompose/certified/protrusion_oracle.h"
#include "decompose/certified/splitting.h"
#include "decompose/certified/widths.h"

namespace collision_hulls {

/// A piece of surface that is not divided further.
struct Element {
  std::vector<Eigen::Vector3d> points;  ///< vertices of its hull
  std::vector<Eigen::Vector3d> likely;  ///< those of them that are likely to matter most; all if they are few
  double area = 0;                      ///< [m^2]
  int leaf = 0;                         ///< the leaf it was split from
};

/// The leaves as elements, or halved, largest first, until there are `count` elements (0: the
/// leaves as they are). Ordered by leaf. `tolerance` [m] determines how many points are likely to
/// matter.
std::vector<Element> elementsOf(const std::vector<Leaf>& leaves, std::size_t count, double tolerance, const RunControl& control = {});

/// Elements covered by one hull.
struct Group {
  std::vector<int> elements;               ///< in ascending order
  std::uint64_t key = 0;                   ///< hash of the set of elements
  double area = 0;                         ///< [m^2]
  Widths widths;                           ///< of the elements
  std::shared_ptr<const ConvexHull> hull;  ///< of their likely points
};

/// Whether two groups are so far apart that a common hull hardly fits unless solid lies in between.
bool farApart(const Group& a, const Group& b, double tolerance);

/// Groups that together contain every element, each in one group.
using Cover = std::vector<Group>;

/// Groups and what is known about their hulls. The same set of elements is never evaluated twice.
class SurfaceGroups {
 public:
  /// A hull of more than `max_vertices` (0: no cap) vertices must also fit after it is capped, as
  /// the leaves' hulls do. `element_count`: see elementsOf().
  SurfaceGroups(const std::vector<Leaf>& leaves, std::size_t element_count, ProtrusionOracle& oracle, int max_vertices);

  const Group& single(int element) const { return singles_[static_cast<std::size_t>(element)]; }
  Cover leaves();

  /// These elements (ascending), grouped by leaf: each group is part of a leaf, which fits.
  Cover byLeaf(const std::vector<int>& elements);

  /// The group of these elements (ascending); without a hull if its hull does not fit.
  Group whole(const std::vector<int>& elements);

  /// The union of two groups; without a hull if the common hull does not fit.
  Group merged(const Group& a, const Group& b);

  /// Whether the group's hull provably fits; without this, a fit is provisional.
  bool proven(const Group& group);
  bool proven(const Cover& cover);

  /// Whether that has been proven already; nothing is tried.
  bool isProven(const Group& group) const;

  /// Forgets the proofs of all other groups, because from now on the oracle asks for more.
  void keepProofsOf(const Cover& cover);

  /// Tests in parallel which of the groups' hulls fit.
  void prove(std::vector<const Group*> groups);

  /// Whether the group's hull covers the element, whether or not the element is in the group.
  bool covers(const Group& group, int element) const;

  /// Takes over another group's element, which the hull must cover.
  void add(int element, Group& group) const;

  /// The hull of all points of the group's elements. If it exceeds the vertex cap, it is, to the
  /// last bit, the hull that was proven after capping.
  ConvexHull exactHull(const Group& group) const;

  /// The same, with its vertices capped.
  ConvexHull cappedHull(const Group& group) const;

  long evaluations() const { return evaluations_; }  ///< hulls built and evaluated so far
  double tolerance() const { return oracle_.tolerance(); }
  const RunControl& control() const { return oracle_.control(); }

 private:
  struct Known {
    bool may_fit = false, asked = false, proven = false;
    std::shared_ptr<const ConvexHull> hull;     // if it may fit
    std::shared_ptr<const ConvexHull> reduced;  // the capped hull, if that is what was proven
  };
  struct Candidate {
    ConvexHull hull;  // as it will be written
    bool is_reduced = false;
  };
  Group groupOf(const std::vector<int>& elements) const;
  std::vector<Eigen::Vector3d> pointsOf(const std::vector<int>& elements) const;
  std::vector<Eigen::Vector3d> likelyPointsOf(const std::vector<int>& elements) const;
  ConvexHull hullOf(const Group& group, const RunControl& control) const;
  std::shared_ptr<const ConvexHull> reducedHull(const Group& group) const;  // the proven one; null: none
  bool needsProof(const Group& group) const;
  bool isWholeLeaf(const Group& group) const;
  bool hasSolidBetween(const Group& a, const Group& b) const;
  void ask(const std::vector<Eigen::Vector3d>& points, Known& known);

  struct WholeLeaf {
    ConvexHull hull;
    std::shared_ptr<const ConvexHull> reduced;
    bool fits = false;
    std::size_t elements = 0;
  };
  std::vector<Element> elements_;
  std::vector<WholeLeaf> leaves_;
  std::vector<Group> singles_;
  ProtrusionOracle& oracle_;
  int max_vertices_;
  RunControl to_the_end_;  // cancelled with the oracle's control, but without its deadline: for hulls that are wanted even then
  std::unordered_map<std::uint64_t, Known> known_;
  long evaluations_ = 0;
};

}  // namespace collision_hulls
