// Where patches meet: the edges of more than two triangles.
#pragma once

#include <tuple>
#include <vector>

#include "base/looks.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "mesh/edges.h"
#include "mesh/orient.h"

namespace collision_hulls {

/// A half-edge where patches meet.
struct MeetingHalf {
  int low, high;  // ends
  int half_edge;
  int patch;
  int direction;  // of its triangle as it is turned, 1: from low to high, -1: the other way

  auto edge() const { return std::tie(low, high); }
};

/// The half-edges where patches meet, by edge. Triangles marked in `oriented.turn` count as flipped.
class Meetings {
 public:
  using Halves = std::vector<MeetingHalf>;

  /// O(n log n) in the half-edges there. `look` must outlive it.
  Meetings(const TriangleMesh& mesh, const Edges& edges, const OrientedPatches& oriented, Looks& look);

  /// Calls visit() with the halves at each edge, in the mesh's order, without those that `is_left_out` holds for.
  template <class LeftOut, class Visit>
  void forEach(const LeftOut& is_left_out, const Visit& visit) const {
    Halves here;
    for (std::size_t i = 0; i < halves_.size(); ++i) {
      look_();
      if (!is_left_out(halves_[i])) here.push_back(halves_[i]);
      const bool is_last = i + 1 == halves_.size() || halves_[i + 1].edge() != halves_[i].edge();
      if (is_last && !here.empty()) visit(here);
      if (is_last) here.clear();
    }
  }

  template <class Visit>
  void forEach(const Visit& visit) const {
    forEach([](const MeetingHalf&) { return false; }, visit);
  }

 private:
  Looks& look_;
  Halves halves_;
};

/// How much more often an edge is used from its low end to its high end than the other way. The halves are *balanced* if it is 0.
int sumOfDirections(const Meetings::Halves& halves);

}  // namespace collision_hulls
