// Answers about points, balls and patches from their distance to the surface, and from the winding number, which tells inside from outside
// (walls.h).
//
// Points closer to the surface than the trees' blur (1e-9 of the extent) count as outside, which is never wrong by more than that: the
// distance to the surface bounds the distance to the solid. Balls inside the solid are smaller by the blur. So neither the step aside of
// signedCrossings() nor the rounding of distances makes a point seem nearer to the solid than it is, but beside cracks and openings: there
// a ball may have shrunk to nothing around a point that is outside by less than the blur. sideError() says so, and the bound includes it.
#include "collision_hulls/measure/solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <utility>

#include "base/looks.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "geometry/own_axes.h"
#include "measure/flat_sheets.h"
#include "measure/flat_walls.h"
#include "measure/inverted.h"
#include "measure/lids.h"
#include "measure/rim.h"
#include "measure/walls.h"
#include "mesh/edges.h"
#include "mesh/loose_segments.h"

namespace collision_hulls {

namespace {

/// The triangles that are not in sheets.
TriangleMesh wallsOf(const RepairedMesh& mesh, const RunControl& control) {
  Looks look(control);
  TriangleMesh result;
  result.vertices = mesh.mesh.vertices;
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t)
    if (look(); !mesh.sheet[t]) result.triangles.push_back(mesh.mesh.triangles[t]);
  return result;
}

/// Whether flat walls may have the inside on both sides: sheets that meet walls, and walls that face each other.
bool mayTouch(const RepairedMesh& mesh, const Walls& walls, const TriangleMesh& triangles, const RunControl& control) {
  if (walls.hasOpenings() || (mesh.counts.components < 2 && mesh.counts.nonmanifold_edges == 0)) return false;
  return (walls.has_sheets && !triangles.triangles.empty()) || someFaceEachOther(triangles, control);
}

/// The triangles on the rim: an opening or a crack begins there.
std::vector<char> onRim(const RepairedMesh& mesh, const Rim& rim, const RunControl& control) {
  Looks look(control);
  std::vector<std::array<int, 2>> edges;
  for (const auto& [from, to] : rim) edges.push_back({std::min(from, to), std::max(from, to)});
  std::sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) { return look(), a < b; });
  std::vector<char> result(mesh.mesh.triangles.size());
  for (std::size_t h = 0; h < 3 * result.size() && !edges.empty(); ++h) {
    look();
    const int from = startOf(mesh.mesh.triangles, static_cast<int>(h)), to = endOf(mesh.mesh.triangles, static_cast<int>(h));
    if (std::binary_search(edges.begin(), edges.end(), std::array<int, 2>{std::min(from, to), std::max(from, to)})) result[h / 3] = 1;
  }
  return result;
}

/// Per triangle of withLoose(): whether a point outside S may be nearest to its back. Not so where the winding number is proved not to be
/// negative in front of it; with openings, which blur the winding number, that is not attempted. `before`: null, or the solid of the same
/// mesh elsewhere; what is a crack in one place may be an opening in the other.
std::vector<char> twoSided(const RepairedMesh& mesh, const TriangleMesh& walls, const Rim& rim, const Lids& lids, const Solid* before,
                           const RunControl& control) {
  const std::size_t count = mesh.mesh.triangles.size();
  std::vector<char> result(count + mesh.loose.size(), 1);
  if (!lids.of_openings.empty()) return result;
  if (before) return before->surface().twoSided();
  const std::vector<char> inverted = mayFaceInverted(closedSurface(walls, lids), control), on_rim = onRim(mesh, rim, control);
  for (std::size_t t = 0, wall = 0; t < count; ++t)
    if (!mesh.sheet[t]) result[t] = inverted[wall++] || on_rim[t];
  return result;
}

/// From afar, one asks only which way a surface faces; one that faces both ways everywhere does without, as with openings.
TriangleBvh::Keeps keptOf(const std::vector<char>& two_sided) {
  const bool any_way = std::find(two_sided.begin(), two_sided.end(), 0) == two_sided.end();
  return any_way ? TriangleBvh::Keeps::kNothing : TriangleBvh::Keeps::kFarView;
}

/// What the surface consists of.
struct Anatomy {
  Anatomy(const RepairedMesh& mesh, const Solid* before, const RunControl& control)
      : edges(findEdges(mesh.mesh.triangles, mesh.mesh.vertices.size(), control)),
        walls(wallsOf(mesh, control)),
        rim(rimOf(mesh, edges, control)),
        lids(lidsOf(mesh.mesh, rim, control)),
        two_sided(twoSided(mesh, walls, rim, lids, before, control)) {}
  Edges edges;
  TriangleMesh walls;
  Rim rim;
  Lids lids;
  std::vector<char> two_sided;  // per triangle of withLoose()
};

}  // namespace

struct Solid::Impl {
  Impl(const RepairedMesh& mesh, const Solid* before, const RunControl& control) : Impl(mesh, Anatomy(mesh, before, control), control) {}
  Impl(const RepairedMesh& mesh, const Anatomy& anatomy, const RunControl& control)
      : surface(std::make_shared<TriangleBvh>(withLoose(mesh), anatomy.two_sided, control, keptOf(anatomy.two_sided))),
        walls(anatomy.walls, anatomy.lids, mesh.mesh.triangles.size(), surface, control),
        sheets(mesh, anatomy.edges, anatomy.two_sided, control),
        may_touch(mayTouch(mesh, walls, anatomy.walls, control)),
        interior(interiorOf(mesh)),
        axes(ownAxes(mesh.mesh)),
        weld_distance(mesh.counts.weld_distance),
        component_points(pointsOfComponents(mesh)) {}
  std::shared_ptr<const TriangleBvh> surface;
  Walls walls;
  FlatSheets sheets;
  bool may_touch;  // whether flat walls may have the inside on both sides
  Interior interior;
  Eigen::Matrix3d axes;
  double weld_distance;
  std::vector<Eigen::Vector3d> component_points;
};

Solid::Solid(const RepairedMesh& mesh, const RunControl& control) {
  control.check();
  impl_ = std::make_unique<Impl>(mesh, nullptr, control);
}
Solid::Solid(const RepairedMesh& moved, const Solid& before, const RunControl& control) {
  control.check();
  impl_ = std::make_unique<Impl>(moved, &before, control);
}
Solid::~Solid() = default;
Solid::Solid(Solid&&) noexcept = default;

Winding Solid::windingAt(const Eigen::Vector3d& p) const {
  return {impl_->walls, p};
}
bool Solid::contains(const Eigen::Vector3d& p) const {
  return windingAt(p).isInside();
}
double Solid::distanceToSurface(const Eigen::Vector3d& p) const {
  return impl_->surface->nearest(p).distance;
}
double Solid::distance(const Eigen::Vector3d& p) const {
  return contains(p) ? 0 : distanceToSurface(p);
}
/// A way from p to S ends at the surface, crosses the lid of a crack, or leads to where the winding number has risen to 1/2.
double Solid::leastDistance(const Eigen::Vector3d& p, double to_surface) const {
  const Walls& walls = impl_->walls;
  return std::max(0.0, std::min(to_surface - walls.crackSlack(), windingAt(p).wayToHalf()) - 2 * walls.blur);
}
bool Solid::isFurther(double distance, const Eigen::Vector3d& p, double to_surface) const {
  const Walls& walls = impl_->walls;
  const double length = distance + 2 * walls.blur;
  return to_surface - walls.crackSlack() > length && windingAt(p).isHalfBeyond(length);
}
bool Solid::isWithin(double distance, const Eigen::Vector3d& p) const {
  return impl_->surface->nearest(p, distance).triangle >= 0 || contains(p);
}
double Solid::signedDistance(const Eigen::Vector3d& p, double to_surface) const {
  Winding at = windingAt(p);
  return signedDistance(at, to_surface);
}
/// Lemma 2 of doc/certified.md.
double Solid::signedDistance(Winding& at, double to_surface) const {
  const Walls& walls = impl_->walls;
  if (to_surface <= walls.blur) return to_surface;
  if (!at.isInside()) return to_surface;
  const double least = to_surface - walls.crackSlack(), way = at.wayToBorder(least);
  if (way <= least) return -std::max(0.0, way - walls.blur);  // where the nearest wall is takes longer to tell
  const double free = walls.toWalls(at.point(), to_surface) - walls.crackSlack();
  return -std::max(0.0, std::min(free, at.wayToBorder(free)) - walls.blur);
}
double Solid::signedDistance(const Eigen::Vector3d& p, double to_surface, bool inside) const {
  const Walls& walls = impl_->walls;
  return inside ? -std::max(0.0, walls.toWalls(p, to_surface) - walls.crackSlack() - walls.blur) : to_surface;
}
double Solid::sideError() const {
  return hasOpenings() || impl_->walls.crack_width > 0 ? impl_->walls.blur : 0;
}
bool Solid::isOneSide(const Eigen::Vector3d& p, double to_surface, double radius) const {
  const Walls& walls = impl_->walls;
  return to_surface - walls.crackSlack() - walls.blur > radius && (!hasOpenings() || windingAt(p).isBorderBeyond(radius));
}
bool Solid::isOneSide(const std::array<Eigen::Vector3d, 3>& patch, Winding& near, const std::array<Eigen::Vector3d, 3>** met) const {
  const std::array<Eigen::Vector3d, 3>* const found = impl_->walls.closed->metBy(patch);
  if (met) *met = found;
  if (found || !hasOpenings()) return !found;
  double radius = 0;
  for (const Eigen::Vector3d& p : patch) radius = std::max(radius, (p - near.point()).norm());
  return radius < near.wayToBorder(radius);
}

/// Lemma 1 of doc/certified.md.
double Solid::distanceWithin(double radius, double signed_distance, double to_surface) const {
  const double bound = std::max(0.0, signed_distance + radius);
  return std::signbit(signed_distance) && bound > 0 && hasOpenings() ? to_surface + radius : bound;  // the ball may be a point: -0
}
double Solid::distanceAmongWalls(const Eigen::Vector3d& p, double to_surface, double radius) const {
  if (!impl_->may_touch || to_surface > radius) return std::numeric_limits<double>::infinity();
  return amongFlatWalls(*impl_->walls.closed, surface(), p, radius).any;
}
double Solid::summitAmongWalls(const Eigen::Vector3d& p, double to_surface, double radius) const {
  if (!impl_->may_touch) return std::numeric_limits<double>::infinity();
  return amongFlatWalls(*impl_->walls.closed, surface(), p, impl_->walls.reach(radius, to_surface + radius)).summit;
}
double Solid::wayToBorder(const Eigen::Vector3d& p) const {
  return hasOpenings() ? windingAt(p).exactWayToBorder() : std::numeric_limits<double>::infinity();
}
bool Solid::hasOpenings() const {
  return impl_->walls.hasOpenings();
}
double Solid::volume() const {
  return impl_->walls.volume;
}
Interior Solid::interior() const {
  return impl_->interior;
}
double Solid::heightAboveSheet(const std::array<Eigen::Vector3d, 3>& patch, const TriangleBvh::Nearest& near, double slack) const {
  return impl_->sheets.bound(patch, near, slack);
}
bool Solid::mayHoldSummit(const Eigen::Vector3d& p, double to_surface, double radius) const {
  return !surface().facesOneWay(p, impl_->walls.reach(radius, to_surface + radius));
}
const Eigen::Matrix3d& Solid::axes() const {
  return impl_->axes;
}
double Solid::weldDistance() const {
  return impl_->weld_distance;
}
const std::vector<Eigen::Vector3d>& Solid::componentPoints() const {
  return impl_->component_points;
}
const TriangleBvh& Solid::surface() const {
  return *impl_->surface;
}

}  // namespace collision_hulls
