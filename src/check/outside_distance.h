// The distance to a solid over space, sampled where it is asked for: an octree that grows under the queries.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "collision_hulls/check/solid.h"
#include "collision_hulls/control.h"
#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Cells are cubes along the solid's axes(), so that few of them meet both a flat wall and the space beside it. A cell knows the signed
/// distance at its centre (positive outside), which bounds it over the cell by the cell's radius. Queries descend where the bound leaves
/// something open, and what one query computed the next one finds. Values are a function of the solid and the box alone, so answers do not
/// depend on the order of queries until the octree is full (eight million cells). Not thread safe.
class OutsideDistance {
 public:
  /// `box`: what most queried hulls lie in; `solid` must live as long.
  OutsideDistance(const Solid& solid, const Eigen::AlignedBox3d& box);

  /// Whether the hull lies in that box, or hardly outside. Of others what is found holds, and, if the box holds the solid,
  /// the bound of summits: beyond it the distance grows outward.
  bool reaches(const ConvexHull& hull) const;

  /// Takes over what another one, of the same solid and box, knows of the cells that meet `part`.
  void learn(const OutsideDistance& other, const Eigen::AlignedBox3d& part) { learn(0, other, 0, turned(part, solid_.axes())); }

  struct Query {
    double floor = 0;                                                ///< [m] distances up to here do not matter
    double ceiling = 0;                                              ///< [m] the search ends when a larger distance is found
    double resolution = 0;                                           ///< [m] cells of a smaller radius are not divided
    double surface_bound = std::numeric_limits<double>::infinity();  ///< [m] no point of the hull's surface is further
    double depth = std::numeric_limits<double>::infinity();          ///< [m] no point of the hull lies deeper beneath its surface
    std::size_t most_visits = 60000;                                 ///< to cells; then the largest bound left over is the answer's
    bool summits_only = false;  ///< leave out cells without a local maximum: for hulls whose surface was searched already
  };
  struct Largest {
    double found = 0;  ///< [m] largest distance found at a point of the hull
    double bound = 0;  ///< [m] no point of the hull, or no summit in it, is further; infinite if the ceiling ended the search
    Eigen::Vector3d where = Eigen::Vector3d::Zero();
    std::size_t visits = 0;  ///< that it took
  };
  Largest largest(const ConvexHull& hull, const Query& query, const RunControl& control = {});  ///< throws kCancelled

  /// Whether no point of the triangle is further than `distance` [m], as far as cells are known; false of one that leaves the box.
  /// Measures nothing.
  bool isWithin(const std::array<Eigen::Vector3d, 3>& triangle, double distance) const;

  struct Intruder {
    Eigen::Vector3d p;
    double distance = 0;  ///< [m]
    double weight = 0;    ///< [m^3] of the cell
  };
  /// Points of the hull at a distance above `tolerance`, one per cell, all cells of one size: the largest cells that give
  /// `wanted` points, or the smallest of radius >= resolution.
  std::vector<Intruder> intruders(const ConvexHull& hull, double tolerance, std::size_t wanted, double resolution);

 private:
  struct Cell {
    Eigen::Vector3d centre;   // along the solid's axes
    double half = 0;          // side / 2
    double to_surface = 0;    // at the centre
    double distance = 0;      // the same, signed: see Solid::signedDistance()
    int triangle = -1;        // nearest; -1: not yet measured
    int children = -1;        // first of eight
    signed char summit = -1;  // whether it may hold a local maximum; -1: not yet asked
  };
  /// Four faces of a hull. Those that are missing lie far above.
  struct Four {
    Eigen::Array4f distance(const Eigen::Vector3f& p) const { return normal[0] * p.x() + normal[1] * p.y() + normal[2] * p.z() + offset; }
    std::array<Eigen::Array4f, 3> normal{Eigen::Array4f::Zero(), Eigen::Array4f::Zero(), Eigen::Array4f::Zero()};  // by axis
    Eigen::Array4f offset = Eigen::Array4f::Constant(std::numeric_limits<float>::lowest());
    Eigen::Array4f width = Eigen::Array4f::Zero();  // how far a cube of half side 1 about the origin reaches along the normal
  };
  struct Memory {
    std::vector<Four> fours;
    std::vector<int> lists;
  };
  struct Faces;  // of a hull
  struct View;   // of a cell by a hull

  /// The box along `axes` about one along the world's.
  static Eigen::AlignedBox3d turned(const Eigen::AlignedBox3d& box, const Eigen::Matrix3d& axes);
  double radius(const Cell& cell) const;
  Eigen::Vector3d inWorld(const Eigen::Vector3d& p) const { return solid_.axes().transpose() * p; }
  void measure(Cell& cell, const Cell* parent) const;
  double knownBound(int cell) const;
  std::optional<Eigen::Vector3d> outsidePoint(const Cell& cell, const Faces& hull, const View& view) const;
  bool canDivide(int cell) const;  // what it takes in memory is bounded
  int children(int cell);
  const Cell& measuredChild(int cell, int parent);
  bool mayHoldSummit(int cell);
  bool isLevelWithin(double distance, int cell);
  void learn(int cell, const OutsideDistance& other, int known, const Eigen::AlignedBox3d& part);

  const Solid& solid_;
  std::vector<Cell> cells_;
  Memory memory_;  // of the query under way
};

}  // namespace collision_hulls
