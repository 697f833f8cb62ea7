// The distance to a solid throughout space, sampled on demand: an octree that grows with the queries.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <deque>
#include <limits>
#include <optional>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/measure/solid.h"

namespace collision_hulls {

/// Cells are cubes along the solid's axes(); few of them then meet both a flat wall and the space beside it. A cell stores the signed
/// distance at its centre (positive outside), which bounds the distance over the cell to within the cell's radius. Queries descend where
/// that bound leaves something open, and later queries reuse what earlier ones computed. A bound may be tighter after other queries; the
/// same queries in the same order give the same answers. Not thread safe.
class OutsideDistance {
 public:
  /// `box` should contain most of the hulls to be queried; `solid` must outlive this object.
  OutsideDistance(const Solid& solid, const Eigen::AlignedBox3d& box);

  /// Whether the hull lies in that box, up to a small margin. For other hulls, what is found is still valid, and so is the bound on summits
  /// if the box contains the solid: outside the box the distance grows outward.
  bool reaches(const ConvexHull& hull) const;

  /// Takes over what another octree, for the same solid and box, knows about the cells that meet `part`.
  void learn(const OutsideDistance& other, const Eigen::AlignedBox3d& part) { learn(0, other, 0, turned(part, solid_.axes())); }

  struct Query {
    double floor = 0;                                                ///< [m] distances up to this do not matter
    double ceiling = 0;                                              ///< [m] the search ends once it finds a larger distance
    double resolution = 0;                                           ///< [m] cells with a smaller radius are not divided
    double surface_bound = std::numeric_limits<double>::infinity();  ///< [m] upper bound on the distance of the hull's surface
    double depth = std::numeric_limits<double>::infinity();  ///< [m] upper bound on the depth of the hull's points below its surface
    std::size_t most_visits = 60000;                         ///< to cells; beyond this, the largest remaining bound is returned
    bool summits_only = false;  ///< skip cells without a local maximum: for hulls whose surface was searched separately
  };
  struct Largest {
    double found = 0;  ///< [m] largest distance found at a point of the hull
    double bound = 0;  ///< [m] upper bound for all points of the hull, or for its summits; infinite if the ceiling ended the search
    Eigen::Vector3d where = Eigen::Vector3d::Zero();
    std::size_t visits = 0;  ///< visits to cells
  };
  Largest largest(const ConvexHull& hull, const Query& query, const RunControl& control = {});  ///< throws kCancelled

  /// Whether, as far as cells are known, no point of the triangle is further than `distance` [m]; false if it leaves the box. Measures
  /// nothing.
  bool isWithin(const std::array<Eigen::Vector3d, 3>& triangle, double distance) const;

  struct Intruder {
    Eigen::Vector3d p;
    double distance = 0;  ///< [m]
    double weight = 0;    ///< [m^3] of the cell
  };
  /// Points of the hull at a distance above `tolerance`, one per cell, from cells of one size: the largest cells that give `wanted` points,
  /// or the smallest of radius >= resolution.
  std::vector<Intruder> intruders(const ConvexHull& hull, double tolerance, std::size_t wanted, double resolution);

 private:
  static constexpr double kNoSide = std::numeric_limits<double>::quiet_NaN();  // the side of the surface is not told yet

  /// A cell's place is its family's: memory is what limits such a tree.
  struct Cell {
    double to_surface = 0;                                     // [m] from the centre
    double distance = kNoSide;                                 // [m] the same, signed: see Solid::signedDistance()
    double level = std::numeric_limits<double>::infinity();    // [m] another upper bound on the distance of its points, if known,
    double summits = std::numeric_limits<double>::infinity();  // [m] and one on the distance of its local maxima
    int triangle = -1;                                         // the nearest one; -1: not measured yet
    int children = -1;                                         // first of eight
  };
  /// Eight siblings; the root has none, and is the first of its family.
  struct Family {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // where they meet, in the frame of the solid's axes
    double half = 0;                                   // of a cell's side
    std::array<Cell, 8> cells;
    std::array<signed char, 8> summit{-1, -1, -1, -1, -1, -1, -1, -1};  // whether each may contain a local maximum; -1: not determined yet
    std::array<bool, 8> levelled{};  // whether each one's level is already what isLevelWithin() can prove
    std::array<signed char, 8> one_side{-1, -1, -1, -1, -1, -1, -1, -1};     // what isOneSide() answers; -1: not asked yet
    std::array<signed char, 8> among_walls{-1, -1, -1, -1, -1, -1, -1, -1};  // what isAmongWalls() answers; -1: not asked yet
  };
  /// Where a cell is.
  struct Cube {
    Eigen::Vector3d centre;
    double half = 0;
  };
  /// Four faces of a hull. Missing ones are placed far above.
  struct Four {
    Eigen::Array4f distance(const Eigen::Vector3f& p) const { return normal[0] * p.x() + normal[1] * p.y() + normal[2] * p.z() + offset; }
    std::array<Eigen::Array4f, 3> normal{Eigen::Array4f::Zero(), Eigen::Array4f::Zero(), Eigen::Array4f::Zero()};  // by axis
    Eigen::Array4f offset = Eigen::Array4f::Constant(std::numeric_limits<float>::lowest());
    Eigen::Array4f width = Eigen::Array4f::Zero();  // how far a cube of half side 1 about the origin extends along the normal
  };
  struct Memory {
    std::vector<Four> fours;
    std::vector<int> lists;
  };
  struct Faces;  // of a hull
  struct View;   // of a cell by a hull

  /// The box along `axes` around a box along the world's axes.
  static Eigen::AlignedBox3d turned(const Eigen::AlignedBox3d& box, const Eigen::Matrix3d& axes);
  Eigen::Vector3d inWorld(const Eigen::Vector3d& p) const { return solid_.axes().transpose() * p; }
  void measure(int cell, int parent);
  void tellSide(int cell, int parent);
  bool isOneSide(int cell);
  double knownBound(int cell) const;
  double boundBelow(double enough, int cell, int parent);
  std::optional<Eigen::Vector3d> outsidePoint(int cell, const Faces& hull, const View& view) const;
  bool canDivide(int cell) const;  // bounds the memory
  int children(int cell);
  const Cell& measuredChild(int cell, int parent);
  bool mayHoldSummit(int cell);
  bool isLevelWithin(double distance, int cell);
  bool isAmongWalls(int cell);
  double summitBound(int cell) const { return std::min(knownBound(cell), at(cell).summits); }
  void boundByChildren(int cell);
  void learn(int cell, const OutsideDistance& other, int known, const Eigen::AlignedBox3d& part);

  /// Cells are numbered in the order of their families.
  Family& family(int id) { return families_[static_cast<std::size_t>(id) / 8]; }
  const Family& family(int id) const { return families_[static_cast<std::size_t>(id) / 8]; }
  Cell& at(int id) { return family(id).cells[static_cast<std::size_t>(id) % 8]; }
  const Cell& at(int id) const { return family(id).cells[static_cast<std::size_t>(id) % 8]; }
  bool& levelled(int id) { return family(id).levelled[static_cast<std::size_t>(id) % 8]; }
  signed char& summit(int id) { return family(id).summit[static_cast<std::size_t>(id) % 8]; }
  Cube cube(int id) const;
  double radius(int id) const;

  const Solid& solid_;
  std::deque<Family> families_;  // a deque, as cells must not move
  Memory memory_;                // for the current query
};

}  // namespace collision_hulls
