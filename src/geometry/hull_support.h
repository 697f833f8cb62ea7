// Support points of a hull, found by walking along its edges; and measures that compare all faces with all vertices, for proofs.
#pragma once

#include <cstddef>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"

namespace collision_hulls {

/// Takes a few steps if the walk starts nearby. Keeps a reference to the hull. Thread safe.
class HullSupport {
 public:
  explicit HullSupport(const ConvexHull& hull);

  /// The support point in a direction: climbs from vertex `start`; on a convex surface the climb ends at the maximum. May stop short of
  /// vertices that are higher by less than the hull's slack.
  int furthest(const Eigen::Vector3d& direction, int start) const;

 private:
  const ConvexHull& hull_;
  std::vector<std::size_t> first_;  // per vertex: its first neighbour
  std::vector<int> neighbours_;     // vertices joined to it by an edge
};

Eigen::Vector3d meanOfVertices(const ConvexHull& hull);

/// [m] An upper bound on the diameter of any ball in the hull: the least width across its faces, each compared with all vertices. Throws
/// kCancelled.
double leastWidth(const ConvexHull& hull, const RunControl& control = {});

/// [m] How far points may lie beyond the hull's triangles and yet be in the convex hull of its vertices, or below all its faces: an upper
/// bound, proved for triangles that are closed and enclose the mean of the vertices. Takes nothing on trust, slack included. Throws
/// kCancelled.
double overhang(const ConvexHull& hull, const RunControl& control = {});

/// [m] How far a vertex may move, straight away from the faces near it, to be as deep as `depth` [m] below all faces; infinite if that way
/// leads nearer to some face.
double wayInto(const ConvexHull& hull, const Eigen::Vector3d& vertex, double depth);

}  // namespace collision_hulls
