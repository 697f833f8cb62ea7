// A partition across a box, as CAD exports have them, makes edges with three triangles: which two of them are the skin? Those that border
// the outer space.
//
// Each patch has two sides, and each side borders one space. Around an edge, what faces each other in order of angle borders the same
// space; at an open edge, and along the seam of a patch that cannot be oriented, both sides of a patch do. So the sides fall into sets, one
// for each space, by a union-find over the edges where patches meet. A space's volume is that within its patches: positive for a space
// that is enclosed, and negative for the outer one, since the volumes of all spaces of a component sum to zero. The space with the least
// volume is therefore the outer one, and what is enclosed is as large as it can be. Patches with one side there are the skin, all others
// lie inside or hang outside.
//
// The skin is closed whatever the mesh is, even where it crosses itself: around each edge, skin lies between a sector of the outer space
// and one of another space. Such sectors alternate, so the skin, once it faces the outer space, uses the edge equally often in both
// directions. At an open edge there is no skin.
//
// A wall that crosses the skin, though, borders the inner space at one of its edges and the outer one at another. That joins the two, and
// hardly anything is enclosed. So walls are looked for in a second way as well, by what is closed without them (left_out.h), and of the
// two results that which encloses more counts.
//
// Near-linear: the halves of edges are sorted. To try all sets of walls, and to compare volumes, would take exponential time.
#include "mesh/sheets/inner_walls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/looks.h"
#include "mesh/boundary.h"
#include "mesh/sheets/left_out.h"

namespace collision_hulls {
namespace {

constexpr double kMore = 1.01;  // times what the first way encloses: with less, it is the same solid

/// A half-edge where patches meet.
struct MeetingHalf {
  int low, high;  // ends
  int half_edge;
  int direction;  // 1: from low to high
  double angle;   // [rad] of its triangle around the edge, seen against the direction from low to high

  auto edge() const { return std::tie(low, high); }
};

/// Where patches meet: by edge, then in order of angle.
class Meetings {
 public:
  Meetings(const TriangleMesh& mesh, const Edges& edges, const OrientedPatches& oriented, Looks& look) : look_(look) {
    for (int h = 0; h < static_cast<int>(edges.twin.size()); ++h)
      if (look(); edges.twin[at(h)] == Edges::kNonManifold) halves_.push_back(meetingHalf(mesh, oriented, h));
    std::sort(halves_.begin(), halves_.end(), [&](const MeetingHalf& a, const MeetingHalf& b) {
      look();
      return std::tie(a.low, a.high, a.angle, a.half_edge) < std::tie(b.low, b.high, b.angle, b.half_edge);
    });
  }

  /// Calls visit() with the halves at each edge, in order of angle, without those of triangles that are left out.
  template <class LeftOut, class Visit>
  void forEach(const LeftOut& is_left_out, const Visit& visit) const {
    std::vector<MeetingHalf> here;
    for (std::size_t i = 0; i < halves_.size(); ++i) {
      look_();
      if (!is_left_out(halves_[i].half_edge / 3)) here.push_back(halves_[i]);
      const bool is_last = i + 1 == halves_.size() || halves_[i + 1].edge() != halves_[i].edge();
      if (is_last && !here.empty()) visit(here);
      if (is_last) here.clear();
    }
  }

 private:
  static MeetingHalf meetingHalf(const TriangleMesh& mesh, const OrientedPatches& oriented, int h) {
    const BoundaryEdge e = boundaryEdge(mesh, h, oriented.turn, oriented.patch);
    const int low = std::min(e.from, e.to), high = std::max(e.from, e.to);
    const Eigen::Vector3d along = (mesh.vertices[at(high)] - mesh.vertices[at(low)]).normalized();
    const Eigen::Vector3d u = along.unitOrthogonal(), v = along.cross(u);
    const Eigen::Vector3d across = mesh.corner(h / 3, (h + 2) % 3) - mesh.vertices[at(low)];
    return {low, high, h, e.from == low ? 1 : -1, std::atan2(v.dot(across), u.dot(across))};
  }

  Looks& look_;
  std::vector<MeetingHalf> halves_;
};

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
  // Side 2 p is the front of patch p, 2 p + 1 its back.
  int frontOf(int t) const { return 2 * oriented_.patch[at(t)]; }
  int backOf(int t) const { return frontOf(t) + 1; }
  bool isOuter(int t, int side) { return spaces_.find(side) == outer_[at(edges_.component[at(t)])]; }

  void joinSides(const Meetings& meetings) {
    meetings.forEach([&](int t) { return isLeftOut(t); },
                     [&](const std::vector<MeetingHalf>& here) {
                       for (std::size_t i = 0; i < here.size(); ++i) {
                         const MeetingHalf &half = here[i], &next = here[(i + 1) % here.size()];
                         const int t = half.half_edge / 3, of_next = next.half_edge / 3;
                         spaces_.join(half.direction > 0 ? frontOf(t) : backOf(t), next.direction > 0 ? backOf(of_next) : frontOf(of_next));
                       }
                     });
    for (int h = 0; h < 3 * count(); ++h) {
      look_();
      const int twin = edges_.twin[at(h)];
      const auto from = [&](int half) { return boundaryEdge(mesh_, half, oriented_.turn, oriented_.patch).from; };
      if (twin == Edges::kOpen || (twin >= 0 && from(h) == from(twin))) spaces_.join(frontOf(h / 3), backOf(h / 3));
    }
  }

  void findOuterSpaces() {
    const Eigen::Vector3d origin = boundingBox(mesh_).center();
    for (int t = 0; t < count(); ++t) {
      look_();
      if (isLeftOut(t)) continue;
      const Eigen::Vector3d a = mesh_.corner(t, 0) - origin, b = mesh_.corner(t, 1) - origin, c = mesh_.corner(t, 2) - origin;
      const double behind = (oriented_.turn[at(t)] ? -1 : 1) * a.cross(b).dot(c) / 6;
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
      : mesh_(mesh), edges_(edges), oriented_(oriented), sheet_(sheet), look_(control), meetings_(mesh, edges, oriented, look_) {}

  void setApart() {
    const std::vector<char> wanted = findWanted();
    if (std::find(wanted.begin(), wanted.end(), 1) == wanted.end()) return;
    Division all(mesh_, edges_, oriented_, meetings_, std::vector<char>(oriented_.patches, 0), look_);
    Division others(mesh_, edges_, oriented_, meetings_, leftOutOf(wanted), look_);
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
    meetings_.forEach([&](int t) { return sheet_[at(t)] != 0; },
                      [&](const std::vector<MeetingHalf>& here) {
                        int sum = 0;
                        for (const MeetingHalf& half : here) sum += half.direction;
                        if (sum != 0) wanted[at(component(here[0].half_edge / 3))] = 1;
                      });
    for (int h = 0; h < 3 * count(); ++h)
      if (look_(); edges_.twin[at(h)] == Edges::kOpen && !sheet_[at(h / 3)]) wanted[at(component(h / 3))] = 0;
    return wanted;
  }

  /// Per patch, in the second way.
  std::vector<char> leftOutOf(const std::vector<char>& wanted) {
    std::vector<double> areas(oriented_.patches, 0);
    for (int t = 0; t < count(); ++t) look_(), areas[at(oriented_.patch[at(t)])] += triangleArea(mesh_, t);
    std::vector<std::vector<int>> edges;
    meetings_.forEach([&](int t) { return sheet_[at(t)] != 0 || !wanted[at(component(t))]; },
                      [&](const std::vector<MeetingHalf>& here) {
                        std::map<int, int> uses;
                        for (const MeetingHalf& half : here) ++uses[oriented_.patch[at(half.half_edge / 3)]];
                        edges.emplace_back();
                        for (const auto& [patch, times] : uses)
                          if (times % 2 == 1) edges.back().push_back(patch);
                      });
    return leftOut(edges, areas, look_);
  }

  /// Components that enclose next to nothing stay as they are.
  void dropThoseWithoutSkin(std::vector<Division*>& chosen) {
    std::vector<double> area(chosen.size(), 0);
    for (int t = 0; t < count(); ++t) {
      look_();
      Division* const division = chosen[at(component(t))];
      if (division && division->isSkin(t)) area[at(component(t))] += triangleArea(mesh_, t);
    }
    for (std::size_t c = 0; c < chosen.size(); ++c)
      if (chosen[c] && !(chosen[c]->enclosed(c) > kNilVolume * area[c] * std::sqrt(area[c]))) chosen[c] = nullptr;
  }

  const TriangleMesh& mesh_;
  const Edges& edges_;
  OrientedPatches& oriented_;
  std::vector<char>& sheet_;
  Looks look_;
  const Meetings meetings_;
};

}  // namespace

void setInnerWallsApart(const TriangleMesh& mesh, const Edges& edges, OrientedPatches& oriented, std::vector<char>& sheet,
                        const RunControl& control) {
  if (edges.nonmanifold > 0) InnerWalls(mesh, edges, oriented, sheet, control).setApart();
}

}  // namespace collision_hulls
