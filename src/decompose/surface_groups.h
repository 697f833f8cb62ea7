// Who covers what: elements of surface, groups of them that share a hull, and a memory of which groups may.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "decompose/cutting.h"
#include "decompose/protrusion_oracle.h"
#include "decompose/widths.h"

namespace collision_hulls {

/// A piece of surface that is not divided any more.
struct Element {
  std::vector<Eigen::Vector3d> points;  ///< vertices of its hull
  std::vector<Eigen::Vector3d> likely;  ///< of these those that matter most: all if they are few
  double area = 0;                      ///< [m^2]
  int leaf = 0;                         ///< that it was cut from
};

/// The leaves as elements, halved, largest first, until there are `count` (0: the leaves as they are). Ordered by leaf. `tolerance` [m]
/// decides how many points are likely to matter.
std::vector<Element> elementsOf(const std::vector<Leaf>& leaves, std::size_t count, double tolerance);

/// Elements that one hull covers.
struct Group {
  std::vector<int> elements;               ///< ascending
  std::uint64_t key = 0;                   ///< of the set of elements
  double area = 0;                         ///< [m^2]
  Widths widths;                           ///< of the elements
  std::shared_ptr<const ConvexHull> hull;  ///< of their likely points
};

/// Whether two groups are so far apart that a common hull hardly fits unless what lies between is solid.
bool farApart(const Group& a, const Group& b, double tolerance);

/// Groups that have every element among them, in one of them.
using Cover = std::vector<Group>;

/// Groups and what is known of their hulls. The same set of elements is never asked about twice.
class SurfaceGroups {
 public:
  /// A hull with more than `max_vertices` (0: no cap) has to fit also when reduced to so many, as the leaves' hulls do.
  /// `element_count` as for elementsOf().
  SurfaceGroups(const std::vector<Leaf>& leaves, std::size_t element_count, ProtrusionOracle& oracle, int max_vertices);

  const Group& single(int element) const { return singles_[static_cast<std::size_t>(element)]; }
  Cover leaves();

  /// These elements (ascending), parted by leaf: each part lies in its leaf, which fits.
  Cover byLeaf(const std::vector<int>& elements);

  /// The group of these elements (ascending), if its hull may fit; without a hull if not.
  Group whole(const std::vector<int>& elements);

  /// The union of two groups, if its hull may fit; without a hull if not.
  Group merged(const Group& a, const Group& b);

  /// Whether the group's hull fits, by proof; what it may do was taken on trust.
  bool proven(const Group& group);
  bool proven(const Cover& cover);

  /// Finds out which of the groups' hulls fit, all at once.
  void prove(std::vector<const Group*> groups);

  /// Whether the group's hull covers the element, be it its own or not.
  bool covers(const Group& group, int element) const;

  /// Takes another group's element over; the hull must cover it.
  void add(int element, Group& group) const;

  /// The hull of all points of the group's elements. If it has more vertices than the cap it is, to the last bit, what was proven with
  /// its vertices capped.
  ConvexHull exactHull(const Group& group) const;

  /// The same with its vertices capped.
  ConvexHull cappedHull(const Group& group) const;

  long evaluations() const { return evaluations_; }  ///< hulls built and asked about so far
  double tolerance() const { return oracle_.tolerance(); }
  const RunControl& control() const { return oracle_.control(); }

 private:
  struct Known {
    bool may_fit = false, asked = false, proven = false;
    std::shared_ptr<const ConvexHull> hull;     // where it may fit
    std::shared_ptr<const ConvexHull> reduced;  // what is proven, where that has fewer vertices than the group's own
  };
  struct Candidate {
    ConvexHull hull;  // as it is to be written
    bool is_reduced = false;
  };
  Group groupOf(const std::vector<int>& elements) const;
  std::vector<Eigen::Vector3d> pointsOf(const std::vector<int>& elements) const;
  std::vector<Eigen::Vector3d> likelyPointsOf(const std::vector<int>& elements) const;
  ConvexHull hullOf(const Group& group) const;
  std::shared_ptr<const ConvexHull> reducedHull(const Group& group) const;  // that was proven; null: none
  bool needsProof(const Group& group) const;
  bool isWholeLeaf(const Group& group) const;
  bool hasSolidBetween(const Group& a, const Group& b) const;
  void ask(const std::vector<Eigen::Vector3d>& points, Known& known);
  bool overCap(const ConvexHull& hull) const;

  struct WholeLeaf {
    ConvexHull hull;
    std::shared_ptr<const ConvexHull> reduced;
    std::size_t elements = 0;
  };
  std::vector<Element> elements_;
  std::vector<WholeLeaf> leaves_;
  std::vector<Group> singles_;
  ProtrusionOracle& oracle_;
  int max_vertices_;
  std::unordered_map<std::uint64_t, Known> known_;
  long evaluations_ = 0;
};

}  // namespace collision_hulls
