// A partition across a box, as CAD exports have them, makes edges with three triangles: which two of them are the skin? Those that border
// the outer space.
//
// Each patch has two sides, and each side borders one space. Around an edge, what faces each other in order of angle borders the same
// space; at an open edge, and along the seam of a patch that cannot be oriented, both sides of a patch do. So the sides fall into sets, one
// for each space, by a union-find over the edges where patches meet. A space's volume is that within its patches: positive for a space
// that is enclosed, and negative for the outer one, since the volumes of all spaces of a component sum to zero. The space with the least
// volume is therefore the outer one, and what is enclosed is as large as it can be. Patches with one side there are the skin, all others
// lie inside or hang outside. Fins take no part.
//
// Parts of a surface that touch along an edge may cross there, as decimation leaves them, and the order of angle then takes the inside of
// one for the outside of another. So where the triangles at an edge are balanced, they are ordered among those between the same two winding
// numbers.
//
// The skin is closed whatever the mesh is, even where it crosses itself: around each edge, skin lies between a sector of the outer space
// and one of another space. Such sectors alternate in each of these orders, so the skin, once it faces the outer space, uses the edge
// equally often in both directions. At an open edge there is no skin.
//
// A wall that crosses the skin, though, borders the inner space at one of its edges and the outer one at another. That joins the two, and
// hardly anything is enclosed. So walls are looked for in a second way as well, by what is closed without them (left_out.h), and of the
// two results that which encloses more counts. A component of which neither encloses much has openings rather than walls, and stays as it
// is.
//
// Near-linear: the halves of edges are sorted. To try all sets of walls, and to compare volumes, would take exponential time.
#include "mesh/sheets/inner_walls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/looks.h"
#include "mesh/boundary.h"
#include "mesh/sheets/left_out.h"
#include "mesh/sheets/meetings.h"

namespace collision_hulls {
namespace {

constexpr double kMore = 1.01;       // times what the first way encloses: with less, it is the same solid
constexpr double kLeastShare = 0.1;  // of what a component's triangles enclose as they are: with less, its spaces were told apart wrongly

/// The spaces on either side of all patches but those that are left out.
class Division {
 public:
  Division(const TriangleMesh& mesh, const Edges& edges, const OrientedPatches& oriented, const Meetings& meetings,
           std::vector<char> left_out, Looks& look)
      : mesh_(mesh),
        edges_(edges),
        oriented_(oriented),
        look_(look),
        left_out_(std::move(left_out)),
        spaces_(2 * oriented.patches),
        volume_(2 * oriented.patches, 0),
        outer_(edges.components, -1) {
    joinSides(meetings);
    findOuterSpaces();
  }

  bool isSkin(int t) { return !isLeftOut(t) && isOuter(t, frontOf(t)) != isOuter(t, backOf(t)); }
  bool facesOuterSpace(int t) { return isOuter(t, frontOf(t)); }

  /// [m^3] Within a component's skin.
  double enclosed(std::size_t component) const { return outer_[component] < 0 ? 0 : -volume_[at(outer_[component])]; }

 private:
  int count() const { return static_cast<int>(mesh_.triangles.size()); }
  bool isLeftOut(int t) const { return left_out_[at(oriented_.patch[at(t)])] != 0; }
  static int front(int patch) { return 2 * patch; }
  static int back(int patch) { return 2 * patch + 1; }
  int frontOf(int t) const { return front(oriented_.patch[at(t)]); }
  int backOf(int t) const { return back(oriented_.patch[at(t)]); }
  bool isOuter(int t, int side) { return spaces_.find(side) == outer_[at(edges_.component[at(t)])]; }

  void joinSides(const Meetings& meetings) {
    meetings.forEach([&](const MeetingHalf& half) { return left_out_[at(half.patch)] != 0; },
                     [&](const Meetings::Halves& here) {
                       for (const auto& [level, ring] : rings(byAngle(here))) joinAround(ring);
                     });
    for (int h = 0; h < 3 * count(); ++h) {
      look_();
      const int twin = edges_.twin[at(h)];
      const auto from = [&](int half) { return boundaryEdge(mesh_, half, oriented_.turn, oriented_.patch).from; };
      if (twin == Edges::kOpen || (twin >= 0 && from(h) == from(twin))) spaces_.join(frontOf(h / 3), backOf(h / 3));
    }
  }

  /// [rad] Of a half-edge's triangle around the edge, seen against the direction from its low end to its high end.
  double angleOf(const MeetingHalf& half) const {
    const Eigen::Vector3d& low = mesh_.vertices[at(half.low)];
    const Eigen::Vector3d along = (mesh_.vertices[at(half.high)] - low).normalized();
    const Eigen::Vector3d u = along.unitOrthogonal(), v = along.cross(u);
    const Eigen::Vector3d across = mesh_.corner(half.half_edge / 3, (half.half_edge + 2) % 3) - low;
    return std::atan2(v.dot(across), u.dot(across));
  }

  Meetings::Halves byAngle(const Meetings::Halves& here) const {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < here.size(); ++i) order.emplace_back(angleOf(here[i]), i);
    std::sort(order.begin(), order.end());
    Meetings::Halves result;
    for (const auto& [angle, i] : order) result.push_back(here[i]);
    return result;
  }

  /// What faces each other around an edge. Where the halves are balanced, they are those between the same two winding numbers: the
  /// triangles there are pieces of as many surfaces as there are such pairs, which may cross each other.
  static std::map<int, Meetings::Halves> rings(const Meetings::Halves& by_angle) {
    if (sumOfDirections(by_angle) != 0) return {{0, by_angle}};
    std::map<int, Meetings::Halves> result;
    int level = 0;  // relative to the winding number before the first half
    for (const MeetingHalf& half : by_angle) {
      result[half.direction > 0 ? level : level + 1].push_back(half);
      level -= half.direction;
    }
    return result;
  }

  void joinAround(const Meetings::Halves& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      look_();
      const MeetingHalf &half = ring[i], &next = ring[(i + 1) % ring.size()];
      spaces_.join(half.direction > 0 ? front(half.patch) : back(half.patch), next.direction > 0 ? back(next.patch) : front(next.patch));
    }
  }

  void findOuterSpaces() {
    const Eigen::Vector3d origin = boundingBox(mesh_).center();
    for (int t = 0; t < count(); ++t) {
      look_();
      if (isLeftOut(t)) continue;
      const double behind = (oriented_.turn[at(t)] ? -1 : 1) * volumeBehind(mesh_, t, origin);
      volume_[at(spaces_.find(backOf(t)))] += behind;
      volume_[at(spaces_.find(frontOf(t)))] -= behind;
    }
    for (int t = 0; t < count(); ++t) {
      if (isLeftOut(t)) continue;
      for (const int side : {frontOf(t), backOf(t)}) {
        look_();
        int& outer = outer_[at(edges_.component[at(t)])];
        const int space = spaces_.find(side);
        if (outer < 0 || volume_[at(space)] < volume_[at(outer)]) outer = space;
      }
    }
  }

  const TriangleMesh& mesh_;
  const Edges& edges_;
  const OrientedPatches& oriented_;
  Looks& look_;
  const std::vector<char> left_out_;  // per patch
  DisjointSets spaces_;               // of sides of patches
  std::vector<double> volume_;        // [m^3] per space
  std::vector<int> outer_;            // per component: its outer space
};

class InnerWalls {
 public:
  InnerWalls(const TriangleMesh& mesh, const Edges& edges, OrientedPatches& oriented, std::vector<char>& sheet, const RunControl& control)
      : mesh_(mesh),
        edges_(edges),
        oriented_(oriented),
        sheet_(sheet),
        control_(control),
        look_(control),
        meetings_(mesh, edges, oriented, look_) {}

  void setApart() {
    const std::vector<char> wanted = findWanted();
    if (std::find(wanted.begin(), wanted.end(), 1) == wanted.end()) return;
    const std::vector<char> fins = findFinPatches();
    Division all(mesh_, edges_, oriented_, meetings_, fins, look_);
    Division others(mesh_, edges_, oriented_, meetings_, leftOutOf(wanted, fins), look_);
    std::vector<Division*> chosen(edges_.components, nullptr);
    for (std::size_t c = 0; c < chosen.size(); ++c)
      if (wanted[c]) chosen[c] = others.enclosed(c) > kMore * all.enclosed(c) ? &others : &all;
    dropThoseWithoutSkin(chosen);
    std::vector<char> turned = oriented_.turn;
    for (int t = 0; t < count(); ++t) {
      look_();
      Division* const division = chosen[at(component(t))];
      if (!division) continue;
      sheet_[at(t)] = division->isSkin(t) ? 0 : 1;
      if (division->isSkin(t) && !division->facesOuterSpace(t)) turned[at(t)] = !turned[at(t)];
    }
    oriented_.turn = std::move(turned);
  }

 private:
  int count() const { return static_cast<int>(mesh_.triangles.size()); }
  int component(int t) const { return edges_.component[at(t)]; }

  /// Per component: whether it is to be divided.
  std::vector<char> findWanted() {
    std::vector<char> wanted(edges_.components, 0);
    meetings_.forEach([&](const MeetingHalf& half) { return sheet_[at(half.half_edge / 3)] != 0; },
                      [&](const Meetings::Halves& here) {
                        if (sumOfDirections(here) != 0) wanted[at(component(here[0].half_edge / 3))] = 1;
                      });
    for (int h = 0; h < 3 * count(); ++h)
      if (look_(); edges_.twin[at(h)] == Edges::kOpen && !sheet_[at(h / 3)]) wanted[at(component(h / 3))] = 0;
    return wanted;
  }

  /// Per patch.
  std::vector<char> findFinPatches() {
    std::vector<char> result(oriented_.patches, 0);
    for (int t = 0; t < count(); ++t)
      if (look_(); sheet_[at(t)]) result[at(oriented_.patch[at(t)])] = 1;
    return result;
  }

  /// Per patch, in the second way: fins and walls.
  std::vector<char> leftOutOf(const std::vector<char>& wanted, const std::vector<char>& fins) {
    std::vector<double> areas(oriented_.patches, 0);
    for (int t = 0; t < count(); ++t) look_(), areas[at(oriented_.patch[at(t)])] += triangleArea(mesh_, t);
    std::vector<std::vector<int>> edges;
    const auto is_unwanted = [&](int t) { return sheet_[at(t)] != 0 || !wanted[at(component(t))]; };
    meetings_.forEach([&](const MeetingHalf& half) { return is_unwanted(half.half_edge / 3); },
                      [&](const Meetings::Halves& here) {
                        std::map<int, int> uses;
                        for (const MeetingHalf& half : here) ++uses[half.patch];
                        edges.emplace_back();
                        for (const auto& [patch, times] : uses)
                          if (times % 2 == 1) edges.back().push_back(patch);
                      });
    std::vector<char> result = leftOut(edges, areas, look_);
    for (std::size_t p = 0; p < result.size(); ++p) result[p] = result[p] || fins[p];
    return result;
  }

  /// Components of which too little is enclosed stay as they are.
  void dropThoseWithoutSkin(std::vector<Division*>& chosen) {
    std::vector<double> area(chosen.size(), 0);
    for (int t = 0; t < count(); ++t) {
      look_();
      Division* const division = chosen[at(component(t))];
      if (division && division->isSkin(t)) area[at(component(t))] += triangleArea(mesh_, t);
    }
    const std::vector<double> volume = volumes();
    for (std::size_t c = 0; c < chosen.size(); ++c)
      if (chosen[c] && !(chosen[c]->enclosed(c) > std::max(kNilVolume * area[c] * std::sqrt(area[c]), kLeastShare * volume[c])))
        chosen[c] = nullptr;
  }

  /// [m^3] Per component as it is, without fins: within its triangles and the fans over the edges that are not balanced.
  std::vector<double> volumes() {
    const Eigen::Vector3d origin = boundingBox(mesh_).center();
    std::vector<double> result(edges_.components, 0);
    for (int t = 0; t < count(); ++t)
      if (look_(); !sheet_[at(t)]) result[at(component(t))] += (oriented_.turn[at(t)] ? -1 : 1) * volumeBehind(mesh_, t, origin);
    std::vector<BoundaryEdge> rim;
    meetings_.forEach([&](const MeetingHalf& half) { return sheet_[at(half.half_edge / 3)] != 0; },
                      [&](const Meetings::Halves& here) {
                        for (const MeetingHalf& half : here)
                          rim.push_back(boundaryEdge(mesh_, half.half_edge, oriented_.turn, edges_.component));
                      });
    const std::vector<Closure> closing = closures(mesh_.vertices, std::move(rim), edges_.components, origin, control_);
    for (std::size_t c = 0; c < result.size(); ++c) result[c] += closing[c].volume;
    return result;
  }

  const TriangleMesh& mesh_;
  const Edges& edges_;
  OrientedPatches& oriented_;
  std::vector<char>& sheet_;
  const RunControl& control_;
  Looks look_;
  const Meetings meetings_;
};

}  // namespace

void setInnerWallsApart(const TriangleMesh& mesh, const Edges& edges, OrientedPatches& oriented, std::vector<char>& sheet,
                        const RunControl& control) {
  if (edges.nonmanifold > 0) InnerWalls(mesh, edges, oriented, sheet, control).setApart();
}

}  // namespace collision_hulls
