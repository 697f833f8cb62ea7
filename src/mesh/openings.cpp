// Rims are found on the repaired mesh, where vertices at one place are one. Lids are added to the mesh as it was given, with vertices of
// their own at the rims' places, so that nothing that repair() drops is lost; repairing the result welds them. Near-linear.
//
// Ear clipping in the rim's plane was the alternative: its lids of planar rims never overlap, but most rims of shells are not planar, and
// hulls cover a lid of either kind equally well.
#include "collision_hulls/mesh/openings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/at.h"
#include "base/decimal.h"
#include "base/looks.h"
#include "collision_hulls/error.h"
#include "mesh/boundary.h"
#include "mesh/edges.h"
#include "mesh/orient.h"

namespace collision_hulls {
namespace {

/// The mean point of a closed curve.
Eigen::Vector3d middleOf(const std::vector<Eigen::Vector3d>& rim) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double length = 0;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Eigen::Vector3d &a = rim[i], &b = rim[i + 1 < rim.size() ? i + 1 : 0];
    sum += (b - a).norm() / 2 * (a - rim[0] + b - rim[0]);
    length += (b - a).norm();
  }
  return rim[0] + sum / length;
}

Opening openingOf(const BoundaryLoop& loop, const TriangleMesh& mesh) {
  Opening opening;
  for (const int v : loop.vertices) opening.rim.push_back(mesh.vertices[at(v)]);
  opening.center = middleOf(opening.rim);
  for (const Eigen::Vector3d& p : opening.rim) opening.width = std::max(opening.width, 2 * (p - opening.center).norm());
  return opening;
}

/// The open edges of all components but those of fins.
std::vector<BoundaryEdge> openEdges(const RepairedMesh& mesh, const Edges& edges, Looks& look) {
  const std::vector<char> as_they_are(mesh.mesh.triangles.size(), 0);
  std::vector<BoundaryEdge> boundary;
  for (int h = 0; h < static_cast<int>(edges.twin.size()); ++h) {
    look();
    const std::size_t t = at(h / 3);
    const bool in_fin = mesh.sheet[t] && mesh.interior[at(mesh.component[t])] != Interior::kSurface;
    if (edges.twin[at(h)] == Edges::kOpen && !in_fin) boundary.push_back(boundaryEdge(mesh.mesh, h, as_they_are, edges.component));
  }
  return boundary;
}

/// Per component: whether it encloses nothing, even with lids.
std::vector<char> findFlat(const TriangleMesh& mesh, const Edges& edges, std::vector<BoundaryEdge> boundary, const RunControl& control) {
  Looks look(control);
  const Eigen::Vector3d& origin = mesh.vertices[0];
  std::vector<double> volume, area(edges.components, 0);
  for (const Closure& closure : closures(mesh.vertices, std::move(boundary), edges.components, origin, control))
    volume.push_back(closure.volume);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    look();
    volume[at(edges.component[at(t)])] += volumeBehind(mesh, t, origin);
    area[at(edges.component[at(t)])] += triangleArea(mesh, t);
  }
  std::vector<char> flat;
  for (std::size_t c = 0; c < area.size(); ++c) flat.push_back(std::abs(volume[c]) <= kNilVolume * area[c] * std::sqrt(area[c]));
  return flat;
}

}  // namespace

std::vector<Opening> openingsOf(const RepairedMesh& mesh, const RunControl& control) {
  if (mesh.counts.open_edges == 0) return {};
  Looks look(control);
  const Edges edges = findEdges(mesh.mesh.triangles, mesh.mesh.vertices.size(), control);
  std::vector<BoundaryEdge> boundary = openEdges(mesh, edges, look);
  const std::vector<BoundaryLoop> loops = boundaryLoops(mesh.mesh.vertices.size(), boundary, control);
  const std::vector<char> flat = findFlat(mesh.mesh, edges, std::move(boundary), control);
  std::vector<Opening> openings;
  for (const BoundaryLoop& loop : loops) {
    look();
    if (loop.returns && !flat[at(loop.surface)]) openings.push_back(openingOf(loop, mesh.mesh));
  }
  return openings;
}

/// The rim runs along its triangles' edges, so the lid's edges run the other way.
void addLid(const Opening& opening, TriangleMesh& mesh) {
  const int first = static_cast<int>(mesh.vertices.size()), count = static_cast<int>(opening.rim.size());
  mesh.vertices.insert(mesh.vertices.end(), opening.rim.begin(), opening.rim.end());
  mesh.vertices.push_back(opening.center);
  for (int i = 0; i < count; ++i) mesh.triangles.push_back({first + (i + 1) % count, first + i, first + count});
}

TriangleMesh closeOpenings(const TriangleMesh& mesh, double width, const RunControl& control) {
  if (!(std::isfinite(width) && width >= 0))
    throw Error(ErrorCode::kBadOption,
                "the width of openings to close is " + decimal(width) + " m; give that of the widest one to close, or 0 for none");
  TriangleMesh closed = mesh;
  if (width == 0) return closed;
  for (const Opening& opening : openingsOf(repair(mesh, {}, control), control))
    if (opening.width <= width) addLid(opening, closed);
  return closed;
}

}  // namespace collision_hulls
