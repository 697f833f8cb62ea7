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
// Near-linear: the halves of edges are sorted. The alternative, to leave out patches one by one while what remains is balanced and to
// compare volumes, has as many choices as there are sets of walls.
#include "mesh/sheets/inner_walls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/looks.h"
#include "mesh/boundary.h"

namespace collision_hulls {
namespace {

/// A half-edge where patches meet.
struct MeetingHalf {
  int low, high;  // ends
  int half_edge;
  int direction;  // 1: from low to high
  double angle;   // [rad] of its triangle around the edge, seen against the direction from low to high

  auto edge() const { return std::tie(low, high); }
};

class InnerWalls {
 public:
  InnerWalls(const TriangleMesh& mesh, const Edges& edges, OrientedPatches& oriented, std::vector<char>& sheet, const RunControl& control)
      : mesh_(mesh),
        edges_(edges),
        oriented_(oriented),
        sheet_(sheet),
        look_(control),
        wanted_(edges.components, 0),
        spaces_(2 * oriented.patches),
        outer_(edges.components, -1) {}

  void setApart() {
    findMeetings();
    findWanted();
    if (std::find(wanted_.begin(), wanted_.end(), 1) == wanted_.end()) return;
    joinSides();
    findOuterSpaces();
    dropThoseWithoutSkin();
    for (int t = 0; t < count(); ++t) {
      look_();
      if (!wanted_[at(component(t))]) continue;
      sheet_[at(t)] = isSkin(t) ? 0 : 1;
      if (isSkin(t) && !isOuter(t, frontOf(t))) oriented_.turn[at(t)] = !oriented_.turn[at(t)];
    }
  }

 private:
  int count() const { return static_cast<int>(mesh_.triangles.size()); }
  int component(int t) const { return edges_.component[at(t)]; }
  int frontOf(int t) const { return 2 * oriented_.patch[at(t)]; }
  int backOf(int t) const { return frontOf(t) + 1; }
  bool isOuter(int t, int side) { return spaces_.find(side) == outer_[at(component(t))]; }
  bool isSkin(int t) { return isOuter(t, frontOf(t)) != isOuter(t, backOf(t)); }

  MeetingHalf meetingHalf(int h) const {
    const BoundaryEdge e = boundaryEdge(mesh_, h, oriented_.turn, oriented_.patch);
    const int low = std::min(e.from, e.to), high = std::max(e.from, e.to);
    const Eigen::Vector3d along = (mesh_.vertices[at(high)] - mesh_.vertices[at(low)]).normalized();
    const Eigen::Vector3d u = along.unitOrthogonal(), v = along.cross(u);
    const Eigen::Vector3d across = mesh_.corner(h / 3, (h + 2) % 3) - mesh_.vertices[at(low)];
    return {low, high, h, e.from == low ? 1 : -1, std::atan2(v.dot(across), u.dot(across))};
  }

  void findMeetings() {
    for (int h = 0; h < 3 * count(); ++h)
      if (look_(); edges_.twin[at(h)] == Edges::kNonManifold) meetings_.push_back(meetingHalf(h));
    std::sort(meetings_.begin(), meetings_.end(), [&](const MeetingHalf& a, const MeetingHalf& b) {
      look_();
      return std::tie(a.low, a.high, a.angle, a.half_edge) < std::tie(b.low, b.high, b.angle, b.half_edge);
    });
  }

  /// Calls visit(first, last) with the halves at each edge where patches meet.
  template <class Visit>
  void forEachMeeting(Visit visit) {
    for (auto first = meetings_.cbegin(); first != meetings_.cend();) {
      const auto last = std::find_if(first, meetings_.cend(), [&](const MeetingHalf& h) { return h.edge() != first->edge(); });
      visit(first, last);
      first = last;
    }
  }

  void findWanted() {
    forEachMeeting([&](auto first, auto last) {
      int sum = 0;
      for (auto h = first; h != last; ++h)
        if (look_(); !sheet_[at(h->half_edge / 3)]) sum += h->direction;
      if (sum != 0) wanted_[at(component(first->half_edge / 3))] = 1;
    });
    for (int h = 0; h < 3 * count(); ++h)
      if (look_(); edges_.twin[at(h)] == Edges::kOpen && !sheet_[at(h / 3)]) wanted_[at(component(h / 3))] = 0;
  }

  void joinSides() {
    forEachMeeting([&](auto first, auto last) {
      for (auto h = first; h != last; ++h) {
        look_();
        const MeetingHalf& next = h + 1 == last ? *first : *(h + 1);
        const int t = h->half_edge / 3, of_next = next.half_edge / 3;
        spaces_.join(h->direction > 0 ? frontOf(t) : backOf(t), next.direction > 0 ? backOf(of_next) : frontOf(of_next));
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
    volume_.assign(2 * oriented_.patches, 0);
    const Eigen::Vector3d origin = boundingBox(mesh_).center();
    for (int t = 0; t < count(); ++t) {
      look_();
      const Eigen::Vector3d a = mesh_.corner(t, 0) - origin, b = mesh_.corner(t, 1) - origin, c = mesh_.corner(t, 2) - origin;
      const double behind = (oriented_.turn[at(t)] ? -1 : 1) * a.cross(b).dot(c) / 6;
      volume_[at(spaces_.find(backOf(t)))] += behind;
      volume_[at(spaces_.find(frontOf(t)))] -= behind;
    }
    for (int t = 0; t < count(); ++t)
      for (const int side : {frontOf(t), backOf(t)}) {
        look_();
        int& outer = outer_[at(component(t))];
        const int space = spaces_.find(side);
        if (outer < 0 || volume_[at(space)] < volume_[at(outer)]) outer = space;
      }
  }

  /// Components that enclose next to nothing stay as they are.
  void dropThoseWithoutSkin() {
    std::vector<double> area(wanted_.size(), 0);
    for (int t = 0; t < count(); ++t)
      if (look_(); wanted_[at(component(t))] && isSkin(t)) area[at(component(t))] += triangleArea(mesh_, t);
    for (std::size_t c = 0; c < wanted_.size(); ++c)
      if (wanted_[c]) wanted_[c] = -volume_[at(outer_[c])] > kNilVolume * area[c] * std::sqrt(area[c]);
  }

  const TriangleMesh& mesh_;
  const Edges& edges_;
  OrientedPatches& oriented_;
  std::vector<char>& sheet_;
  Looks look_;
  std::vector<MeetingHalf> meetings_;  // by edge, then in order of angle
  std::vector<char> wanted_;           // per component: whether it is to be divided
  // by space: the sides of patches that border it. Side 2 p is the front of patch p, 2 p + 1 its back
  DisjointSets spaces_;
  std::vector<double> volume_;  // [m^3] per space
  std::vector<int> outer_;      // per component: its outer space
};

}  // namespace

void setInnerWallsApart(const TriangleMesh& mesh, const Edges& edges, OrientedPatches& oriented, std::vector<char>& sheet,
                        const RunControl& control) {
  if (edges.nonmanifold > 0) InnerWalls(mesh, edges, oriented, sheet, control).setApart();
}

}  // namespace collision_hulls
