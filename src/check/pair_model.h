// What the queries on one element work with.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "check/unit_frame.h"
#include "check/validate_probes.h"
#include "collision_hulls/check/validate.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "query/fcl_queries.h"

namespace collision_hulls {

/// A nearby hull of another element, in the pair's frame.
struct Neighbour {
  std::string name;
  const ConvexHull* hull;
};

/// The original and the hulls of a sound pair, in units. Immutable, thread safe.
class PairModel {
 public:
  /// `boxes`: see boxShapes(). Keeps references to the pair's name and to the boxes, and takes the pair's original. Throws kCancelled.
  PairModel(ValidationPair& pair, const std::vector<ProbeShape>& boxes, const std::vector<Neighbour>& neighbours,
            const RunControl& control);
  PairModel(const PairModel&) = delete;
  PairModel& operator=(const PairModel&) = delete;

  const TriangleMesh& withArea() const { return with_area_ ? *with_area_ : original; }  ///< the triangles given to FCL
  TriangleMesh nearestWithArea(const Eigen::Vector3d& p) const;                         ///< only the triangle nearest to p
  TriangleMesh withAreaNear(const Eigen::AlignedBox3d& box) const;                      ///< those whose boxes meet a box
  const Sphere* sphereAt(std::size_t hull) const;                                       ///< null: it is a hull indeed
  bool inSolid(const Eigen::Vector3d& p) const;
  bool hasOpenings() const;

  const std::string& name;
  const std::shared_ptr<const Solid> solid;
  const UnitFrame frame;
  const TriangleMesh original;
  const std::vector<ConvexHull> hulls;
  const std::vector<Sphere> spheres;  // in place of the last hulls
  const std::vector<ProbeShape>& boxes;
  std::vector<ProbeShape> neighbours;
  std::vector<FclHull> fcl_hulls;
  std::vector<Eigen::AlignedBox3d> hull_boxes;
  TriangleMesh without_area;
  std::unique_ptr<const TriangleBvh> bvh, bvh_without_area;
  std::unique_ptr<const FclMesh> fcl_original;
  const std::vector<ConvexHull> inner;  // the hulls, and polyhedra inside the spheres
  const PoseSampler sampler;
  double tolerance = 0;                           // for a verdict
  double allowed = 0;                             // the certified protrusion plus the allowance for tolerance and welding
  std::vector<Eigen::Vector3d> component_points;  // one for each component of the surface

 private:
  std::optional<TriangleMesh> with_area_;  // if there are others
  Eigen::Isometry3d to_solid_;             // from the pair's frame [m]
};

}  // namespace collision_hulls
