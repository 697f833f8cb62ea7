// What lies inside a mesh's surface, by the winding number.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "measure/lids.h"
#include "measure/rim_field.h"

namespace collision_hulls {

/// The surface without its sheets, closed by lids. The winding number is that of the closed surface, by counting crossings, minus that of
/// the lids of openings, which are few.
struct Walls {
  /// `open`: the walls of a mesh. `surface`: a tree over all of its triangles, reused if all of them are walls and there is no rim.
  Walls(const TriangleMesh& open, const Lids& all_lids, std::size_t triangles, const std::shared_ptr<const TriangleBvh>& surface,
        const RunControl& control);

  bool hasOpenings() const { return !lids.empty(); }

  /// [m] How far cracks can mislead (lemma 7 of doc/certified.md). A lid's points lie within a width of the segment along which the loop
  /// runs there and back, and so does some point of the loop beside each point of the segment: no point of a lid is further from the
  /// surface than two widths.
  double crackSlack() const { return 2 * crack_width; }

  /// [m] How far away the nearest wall or lid is, for a point inside. Sheets that are nearer lie inside, too.
  double toWalls(const Eigen::Vector3d& p, double to_surface) const {
    return has_sheets ? std::max(to_surface, closed->nearest(p).distance) : to_surface;
  }

  /// How far from the middle of a ball of this radius the surface may be that is nearest to one of its points, if that is no further than
  /// `furthest` from the point. Never so little that rounding could leave it out.
  double reach(double radius, double furthest) const { return radius + furthest + crackSlack() + blur; }

  std::shared_ptr<const TriangleBvh> closed;
  TriangleBvh lids;
  RimField rim;        // of openings
  double crack_width;  // [m]
  bool has_sheets;     // whether some of the surface is no wall
  double blur;         // [m] what rounding may hide; see the top of solid.cpp
  double volume;       // [m^3] signed
};

/// A mesh and all lids.
TriangleMesh closedSurface(const TriangleMesh& mesh, const Lids& lids);

/// What the winding number of a point tells. With openings, rough numbers, ever finer, tell as much of most points as an exact one would,
/// which is asked where they do not. Each is computed once, when it is needed first.
class Winding {
 public:
  Winding(const Walls& walls, const Eigen::Vector3d& p)
      : walls_(walls), p_(p), aside_(walls.closed->aside(p)), crossings_(walls.closed->signedCrossings(p)) {}

  const Eigen::Vector3d& point() const { return p_; }

  /// With openings, points that might be outside count as outside, so that no hull reaches there unnoticed.
  bool isInside();

  /// A lower bound on the length of any path from the point to where isInside() changes that does not cross the surface; if it is more than
  /// `enough`, it need not be close. Lemma 6 of doc/certified.md.
  double wayToBorder(double enough);
  double exactWayToBorder();

  /// Whether that is longer, if the roughest number tells: false says nothing.
  bool isBorderBeyond(double length);

  /// The same to where the true winding number is 1/2.
  double wayToHalf();

  /// Whether that is longer.
  bool isHalfBeyond(double length);

 private:
  const TriangleBvh::RoughWinding& rough(std::size_t i);
  double margin(std::size_t i);
  double exact();
  double wayTo(double margin);

  const Walls& walls_;
  const Eigen::Vector3d p_, aside_;
  const int crossings_;
  std::array<std::optional<TriangleBvh::RoughWinding>, 2> rough_;  // ever closer
  std::optional<double> exact_;
  std::optional<RimField::Seen> rim_;
};

}  // namespace collision_hulls
