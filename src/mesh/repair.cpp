// Repairs a mesh in this order: weld, also along seams, drop degenerate and duplicate triangles, find edges, orient, find fins and inner
// walls, decide per component how to tell its inside (closed, winding number, or none). Each step is a file of its own; repair() below
// calls them in order.
#include "collision_hulls/mesh/repair.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/at.h"
#include "base/decimal.h"
#include "base/looks.h"
#include "collision_hulls/error.h"
#include "mesh/boundary.h"
#include "mesh/edges.h"
#include "mesh/hash.h"
#include "mesh/orient.h"
#include "mesh/seams.h"
#include "mesh/sheets/fins.h"
#include "mesh/sheets/inner_walls.h"
#include "mesh/slits.h"
#include "mesh/weld.h"

namespace collision_hulls {
namespace {

/// A triangle is flat if its height over its longest edge is below this share of the mesh's extent, which is what double precision leaves
/// of three collinear points.
constexpr double kFlatHeight = 1e-14;

constexpr double kLargestWeldTolerance = 0.1;
constexpr double kSeamTolerance = 10;  // times the weld tolerance

void check(const TriangleMesh& mesh, const RepairOptions& options, const RunControl& control) {
  if (!(options.weld_tolerance >= 0 && options.weld_tolerance <= kLargestWeldTolerance))
    throw Error(ErrorCode::kBadOption, "weld tolerance " + fixedDecimal(options.weld_tolerance) +
                                           " is out of range; give a share of the mesh's extent from 0 to " +
                                           fixedDecimal(kLargestWeldTolerance));
  check(mesh, control);
}

bool isDegenerate(const std::vector<Eigen::Vector3d>& vertices, const Triangle& t, double extent) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  const Eigen::Vector3d a = vertices[at(t[1])] - vertices[at(t[0])], b = vertices[at(t[2])] - vertices[at(t[0])];
  const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
  return a.cross(b).norm() <= kFlatHeight * extent * longest;
}

/// The triangles seen so far, found by their corners in any order.
class TriangleSet {
 public:
  TriangleSet(const std::vector<Triangle>& triangles, std::size_t most) : triangles_(triangles) {
    std::size_t size = 64;
    while (size < 2 * most) size *= 2;
    table_.assign(size, -1);
  }

  /// Inserts triangle `t` of the list unless one with the same corners is present; returns that one, or `t`.
  int insert(int t) {
    const Triangle key = sorted(t);
    for (std::size_t place = bucketOf(key, table_.size());; place = (place + 1) & (table_.size() - 1)) {
      if (table_[place] < 0) {
        table_[place] = t;
        return t;
      }
      if (sorted(table_[place]) == key) return table_[place];
    }
  }

 private:
  Triangle sorted(int t) const {
    Triangle key = triangles_[at(t)];
    std::sort(key.begin(), key.end());
    return key;
  }

  const std::vector<Triangle>& triangles_;
  std::vector<int> table_;  // open addressing, at most half full
};

/// Whether two triangles with the same corners face the same way.
bool isTurnOf(const Triangle& a, const Triangle& b) {
  const auto k = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
  return b[(k + 1) % 3] == a[1];
}

/// The welded mesh's triangles, with the corners that represent theirs.
struct Surface {
  std::vector<Triangle> triangles;  // without duplicates and without flat ones
  std::vector<int> surplus;         // per triangle: the number of copies that face its way minus those that face the other
  std::size_t duplicates = 0;
  std::vector<Triangle> flat;  // those that have no area
  Edges edges;
};

Surface surfaceOf(const TriangleMesh& mesh, const Welding& welding, double extent, const RunControl& control) {
  Surface result;
  std::vector<Triangle>& kept = result.triangles;
  kept.reserve(mesh.triangles.size());
  result.surplus.reserve(mesh.triangles.size());
  TriangleSet seen(kept, mesh.triangles.size());
  Looks look(control);
  const auto cornerOf = [&](int v) { return welding.representative[at(v)]; };
  for (const Triangle& t : mesh.triangles) {
    look();
    const Triangle welded{cornerOf(t[0]), cornerOf(t[1]), cornerOf(t[2])};
    if (isDegenerate(mesh.vertices, welded, extent)) {
      result.flat.push_back(welded);
      continue;
    }
    kept.push_back(welded);
    const int mine = static_cast<int>(kept.size()) - 1, first = seen.insert(mine);
    if (first == mine) {
      result.surplus.push_back(1);
      continue;
    }
    ++result.duplicates;
    kept.pop_back();
    result.surplus[at(first)] += isTurnOf(kept[at(first)], welded) ? 1 : -1;
  }
  result.edges = findEdges(kept, mesh.vertices.size(), control);
  return result;
}

/// Without its seams. Where these close less than half of the open edges, vertices stay: to move them costs tolerance. Ends that have met
/// may give others partners.
std::pair<Welding, Surface> weldedSurface(const TriangleMesh& mesh, double tolerance, double extent, const RunControl& control) {
  Welding welding = weld(mesh, tolerance, control);
  Surface surface = surfaceOf(mesh, welding, extent, control);
  while (std::optional<Welding> wider = weldSeams(mesh, surface.triangles, surface.edges, kSeamTolerance * tolerance, welding, control)) {
    Surface whole = surfaceOf(mesh, *wider, extent, control);
    if (2 * whole.edges.open > surface.edges.open) break;
    welding = std::move(*wider);
    surface = std::move(whole);
  }
  return {std::move(welding), std::move(surface)};
}

/// A triangle's corners, longest side first.
Triangle longestSideFirst(const std::vector<Eigen::Vector3d>& vertices, const Triangle& t) {
  const auto length = [&](std::size_t k) { return (vertices[at(t[(k + 1) % 3])] - vertices[at(t[k])]).norm(); };
  std::size_t longest = 0;
  for (const std::size_t k : {1, 2})
    if (length(k) > length(longest)) longest = k;
  return {t[longest], t[(longest + 1) % 3], t[(longest + 2) % 3]};
}

using Side = std::pair<int, int>;

Side sideOf(int a, int b) {
  return std::minmax(a, b);
}

/// Sorts sides and keeps one of each.
void sortOnce(std::vector<Side>& sides, const RunControl& control) {
  Looks look(control);
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return look(), a < b; });
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
}

/// Those sides of kept triangles whose both ends belong to flat ones, sorted.
std::vector<Side> sidesBesideFlat(std::size_t vertices, const std::vector<Triangle>& kept, const std::vector<Triangle>& flat,
                                  const RunControl& control) {
  Looks look(control);
  std::vector<char> is_flat(vertices, 0);
  for (const Triangle& t : flat)
    for (const int v : t) look(), is_flat[at(v)] = 1;
  std::vector<Side> sides;
  for (const Triangle& t : kept)
    for (std::size_t k = 0; k < 3; ++k) {
      look();
      const int a = t[k], b = t[(k + 1) % 3];
      if (is_flat[at(a)] && is_flat[at(b)]) sides.push_back(sideOf(a, b));
    }
  sortOnce(sides, control);
  return sides;
}

/// What remains of flat triangles, each part once: the longest side, unless a kept triangle has it as a side or kept triangles have both
/// other sides; and points that nothing else contains.
std::vector<Segment> looseOf(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& kept,
                             const std::vector<Triangle>& flat, const RunControl& control) {
  Looks look(control);
  std::vector<char> held(vertices.size(), 0);
  for (const Triangle& t : kept)
    for (const int v : t) look(), held[at(v)] = 1;
  const std::vector<Side> sides = sidesBesideFlat(vertices.size(), kept, flat, control);
  const auto has = [&](int a, int b) { return std::binary_search(sides.begin(), sides.end(), sideOf(a, b)); };
  std::vector<Side> loose;
  for (const Triangle& t : flat) {
    look();
    const auto [a, b, middle] = longestSideFirst(vertices, t);
    if (a == b || has(a, b) || (has(a, middle) && has(middle, b))) continue;
    loose.push_back(sideOf(a, b));
    for (const int v : t) held[at(v)] = 1;
  }
  for (const Triangle& t : flat)
    if (t[0] == t[1] && t[1] == t[2] && !held[at(t[0])]) look(), loose.push_back(sideOf(t[0], t[0]));
  sortOnce(loose, control);
  std::vector<Segment> result;
  for (const auto& [a, b] : loose) look(), result.push_back({vertices[at(a)], vertices[at(b)]});
  return result;
}

/// Renumbers the vertices used by triangles, keeping their order.
void compact(const std::vector<Eigen::Vector3d>& vertices, const RunControl& control, RepairedMesh* result) {
  Looks look(control);
  std::vector<int> number(vertices.size(), -1);
  for (const Triangle& t : result->mesh.triangles)
    for (const int v : t) look(), number[at(v)] = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    look();
    if (number[v] < 0) continue;
    number[v] = static_cast<int>(result->mesh.vertices.size());
    result->mesh.vertices.push_back(vertices[v]);
  }
  for (Triangle& t : result->mesh.triangles)
    for (int& v : t) look(), v = number[at(v)];
}

/// Per component, without its fins; triangles marked in `turn` count as flipped.
std::vector<Interior> findInteriors(const TriangleMesh& mesh, const Edges& edges, const std::vector<char>& turn,
                                    const std::vector<char>& fin, const RunControl& control) {
  Looks look(control);
  std::vector<double> area(edges.components, 0);
  std::vector<Interior> interior(edges.components, Interior::kClosed);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    look();
    if (fin[at(t)]) continue;
    area[at(edges.component[at(t)])] += triangleArea(mesh, t);
  }
  std::vector<BoundaryEdge> boundary;
  for (int h = 0; h < static_cast<int>(edges.twin.size()); ++h) {
    look();
    if (edges.twin[at(h)] == Edges::kOpen && !fin[at(h / 3)]) boundary.push_back(boundaryEdge(mesh, h, turn, edges.component));
  }
  for (const BoundaryEdge& edge : boundary) interior[at(edge.surface)] = Interior::kWinding;
  const std::vector<Closure> closing = closures(mesh.vertices, boundary, edges.components, Eigen::Vector3d::Zero(), control);
  for (std::size_t c = 0; c < interior.size(); ++c)
    if (interior[c] == Interior::kWinding && closing[c].area >= kSmallOpening * area[c]) interior[c] = Interior::kSurface;
  if (std::count(interior.begin(), interior.end(), Interior::kSurface) == 0) return interior;
  const std::vector<char> closed = closedButForSlits(mesh.vertices, std::move(boundary), area, control);
  for (std::size_t c = 0; c < interior.size(); ++c)
    if (interior[c] == Interior::kSurface && closed[c]) interior[c] = Interior::kWinding;
  return interior;
}

}  // namespace

const char* name(Interior interior) {
  switch (interior) {
    case Interior::kClosed: return "closed";
    case Interior::kWinding: return "winding";
    case Interior::kSurface: return "surface";
  }
  return "unknown";
}

RepairedMesh repair(const TriangleMesh& mesh, const RepairOptions& options, const RunControl& control) {
  control.check();
  check(mesh, options, control);
  RepairedMesh result;
  if (mesh.triangles.empty()) return result;
  const double extent = boundingBox(mesh).sizes().maxCoeff();

  auto [welding, surface] = weldedSurface(mesh, options.weld_tolerance * extent, extent, control);
  result.counts.welded = welding.joined;
  result.counts.weld_distance = welding.distance;
  result.counts.degenerate = surface.flat.size();
  result.counts.duplicate = surface.duplicates;
  result.mesh.triangles = std::move(surface.triangles);
  if (!surface.flat.empty()) result.loose = looseOf(mesh.vertices, result.mesh.triangles, surface.flat, control);
  compact(mesh.vertices, control, &result);

  Edges& edges = surface.edges;
  result.counts.components = edges.components;
  result.counts.open_edges = edges.open;
  result.counts.nonmanifold_edges = edges.nonmanifold;

  OrientedPatches oriented = orient(result.mesh, edges, control);
  result.sheet = findFins(result.mesh, edges, oriented, surface.surplus, control);
  setInnerWallsApart(result.mesh, edges, oriented, result.sheet, control);
  const std::vector<char>& turn = oriented.turn;
  result.counts.flipped = static_cast<std::size_t>(std::count(turn.begin(), turn.end(), 1));
  result.interior = findInteriors(result.mesh, edges, turn, result.sheet, control);
  for (std::size_t t = 0; t < turn.size(); ++t)
    if (turn[t]) std::swap(result.mesh.triangles[t][1], result.mesh.triangles[t][2]);
  for (std::size_t t = 0; t < turn.size(); ++t)
    if (result.interior[at(edges.component[t])] == Interior::kSurface) result.sheet[t] = 1;
  result.component = std::move(edges.component);
  return result;
}

Interior interiorOf(const RepairedMesh& mesh) {
  const auto all = [&](Interior kind) {
    return std::all_of(mesh.interior.begin(), mesh.interior.end(), [&](Interior i) { return i == kind; });
  };
  if (all(Interior::kSurface)) return Interior::kSurface;
  return all(Interior::kClosed) ? Interior::kClosed : Interior::kWinding;
}

}  // namespace collision_hulls
