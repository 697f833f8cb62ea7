// Half-edges sorted by edge.
#include "mesh/sheets/meetings.h"

#include <algorithm>

#include "base/at.h"
#include "mesh/boundary.h"

namespace collision_hulls {

Meetings::Meetings(const TriangleMesh& mesh, const Edges& edges, const OrientedPatches& oriented, Looks& look) : look_(look) {
  for (int h = 0; h < static_cast<int>(edges.twin.size()); ++h) {
    look();
    if (edges.twin[at(h)] != Edges::kNonManifold) continue;
    const BoundaryEdge e = boundaryEdge(mesh, h, oriented.turn, oriented.patch);
    halves_.push_back({std::min(e.from, e.to), std::max(e.from, e.to), h, e.surface, e.from < e.to ? 1 : -1});
  }
  std::sort(halves_.begin(), halves_.end(), [&](const MeetingHalf& a, const MeetingHalf& b) {
    look();
    return std::tie(a.low, a.high, a.half_edge) < std::tie(b.low, b.high, b.half_edge);
  });
}

int sumOfDirections(const Meetings::Halves& halves) {
  int sum = 0;
  for (const MeetingHalf& half : halves) sum += half.direction;
  return sum;
}

}  // namespace collision_hulls
