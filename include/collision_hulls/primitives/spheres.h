// Few spheres that cover a mesh, for planners that check spheres alone.
//
// For example:
//
//     SphereOptions options;
//     options.tolerance = 0.02;  // [m]
//     const CertifiedSpheres result = certifiedSpheres(mesh, options);
//     std::cout << result.spheres.size() << " spheres, " << result.bound << " m\n";
//
// What is promised, of the mesh as it is given and of the spheres as they are returned:
//
//   cover   Every point of every triangle lies in a sphere, up to the rounding errors of the test:
//           1e-12 of the coordinates' size. See covers().
//   bound   No point of a sphere is further than `bound` from S, the solid that the mesh
//           represents; see Solid.
//
// Centres and radii are single-precision numbers, so both still hold after spheres are written to a
// file and read back.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/measure/solid.h"

namespace collision_hulls {

/// A closed ball. In metres, in the mesh's frame.
struct Sphere {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;
};

struct SphereOptions {
  /// [m] has to be set: acceptable protrusion, a millionth of the mesh's diagonal or more
  double tolerance = 0;
  /// most spheres per mesh, at least 1; time grows with it, see certifiedSpheres()
  std::size_t max_spheres = 10000;
  Effort effort = Effort::kQuick;  ///< how long to look for fewer
};

/// Spheres with their proof. Lengths in metres, in the mesh's frame.
struct CertifiedSpheres {
  std::vector<Sphere> spheres;  ///< cover the mesh; the largest first
  std::vector<double> bounds;   ///< per sphere: proved, no point of it is further from S
  double bound = 0;             ///< the largest of these
  bool within_tolerance = true;
  /// why not, and what to do about it; empty if it is
  std::string reason;
};

/// Covers the mesh with spheres that protrude by no more than the tolerance, and few of them. If
/// the tolerance is below what single precision and the mesh's margin allow, it is raised to that.
/// If it takes more spheres than the limit, those are returned that protrude least among covers
/// within the limit, as far as a search finds. `reason` says how far they protrude. Deterministic:
/// the same mesh and options give the same spheres, on any number of threads.
///
/// Time goes with spheres times points, both of which grow with the square of the mesh's size over
/// the tolerance: 5,000 spheres take about a minute, and the limit's 10,000 several; a limit of
/// 100 keeps it to seconds. The control's deadline is not heeded, but for stops_at_deadline.
///
/// Throws what repair() throws, kEmptyMesh, kBadOption (as certifiedHulls(): also for a tolerance
/// below a millionth of the mesh's diagonal), kCancelled, and kInternal if the result should fail
/// its own check.
CertifiedSpheres certifiedSpheres(const TriangleMesh& mesh, const SphereOptions& options,
                                  const RunControl& control = {});

/// The same for a mesh that is prepared; its `tree` is not used.
CertifiedSpheres certifiedSpheres(const PreparedMesh& mesh, const SphereOptions& options,
                                  const RunControl& control = {});

/// Whether the spheres, from anywhere, cover the mesh: true only if that is proved, up to 1e-12 of
/// the coordinates' size. Surface that no sphere holds by more than 1e-6 of it counts as uncovered.
bool covers(const std::vector<Sphere>& spheres, const TriangleMesh& mesh,
            const RunControl& control = {});

}  // namespace collision_hulls
