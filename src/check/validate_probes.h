// The bodies that validation probes an element with, and their poses: seeded, independent of the order of queries.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "geometry/random_stream.h"
#include "query/fcl_queries.h"

namespace collision_hulls {

/// A polyhedral probe, for FCL and for our own computation.
struct ProbeShape {
  explicit ProbeShape(std::string probe_name, const ConvexHull& probe_hull);
  std::string name;  ///< for messages
  ConvexHull hull;
  FclHull convex;
  FclMesh mesh;
};

/// Boxes, plates and rods about the origin, from a thousandth to a third of the size of an element of unit size.
std::vector<ProbeShape> boxShapes();

/// A sphere, or a shape at some pose.
struct Probe {
  const ProbeShape* shape = nullptr;  ///< null: a sphere
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  ConvexHull body;                                   ///< the shape at the pose
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< some point of the probe
  double radius = 0;                                 ///< of the sphere, or of a ball about `centre` that contains the body
  Eigen::AlignedBox3d box;
};
Probe sphere(const Eigen::Vector3d& centre, double radius);
Probe placed(const ProbeShape& shape, const Eigen::Isometry3d& pose);  ///< keeps the address of the shape

/// Poses around an element of unit size.
class PoseSampler {
 public:
  /// Keeps references. `original` must have triangles.
  PoseSampler(const TriangleMesh& original, const std::vector<ConvexHull>& hulls);

  Eigen::Vector3d onOriginal(Random& random) const;  ///< a vertex, a point on an edge, or a point in a triangle
  Eigen::Vector3d inHull(Random& random) const;      ///< a vertex, a point on a face, or an inner point of a hull; requires hulls
  // Never exactly in place: contact to the last bit, as between flush faces, can trigger an assert of FCL, which ends the process.
  Eigen::Vector3d sphereCentre(Random& random, double radius) const;      ///< near contact, or anywhere
  Eigen::Isometry3d pose(Random& random, const ConvexHull& probe) const;  ///< any orientation, near contact or anywhere
  Eigen::Isometry3d nudge(Random& random) const;                          ///< a small motion

 private:
  Eigen::Vector3d anchor(Random& random) const;
  Eigen::Vector3d offset(Random& random) const;

  const TriangleMesh& original_;
  const std::vector<ConvexHull>& hulls_;
  std::vector<double> area_below_;  // cumulative: of the triangles up to and including each
  Eigen::AlignedBox3d surroundings_;
};

}  // namespace collision_hulls
