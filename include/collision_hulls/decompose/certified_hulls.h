// The promise in one call: hulls that cover a mesh, and a proved bound on how far they protrude.
//
// For example:
//
//     DecomposeOptions options;
//     options.tolerance = 0.005;  // [m]
//     const CertifiedHulls result = certifiedHulls(mesh, options);
//     std::cout << result.hulls.size() << " hulls protrude by at most " << result.bound << " m\n";
//     if (!result.within_tolerance) std::cout << result.reason << '\n';
//
// What is promised, of the mesh as it is given and of the hulls as they are returned:
//
//   cover   Every point of every triangle lies in a hull, up to the rounding errors of the test:
//           1e-12 of the coordinates' size, see uncovered().
//           With a padding, also every point that is no further from a triangle than that.
//   bound   No point of a hull is further than `bound` from S, the solid that the mesh represents:
//           its surface, and what that encloses. See Solid, also for what is assumed of meshes
//           with openings.
//
// Both hold for every method and also where the bound exceeds the tolerance, which then has a
// reason. The hulls' coordinates are single-precision numbers, so that both still hold after hulls
// are written to a file and read back. Nothing here reads files or knows robots.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/measure/solid.h"

namespace collision_hulls {

/// How far hulls protrude in a region: the true distance lies between `found` and `bound` [m]. Both
/// are 0 if no hull enters it.
struct RegionProof {
  double bound = 0, found = 0;
};

/// Hulls with their proof. Lengths in metres, in the mesh's frame.
struct CertifiedHulls {
  /// Cover the mesh; in a fixed order.
  std::vector<ConvexHull> hulls;
  /// Proved: no point of a hull is further from S. As close to the true protrusion as certificate()
  /// says: to a thousandth of the tolerance, as a rule.
  double bound = 0;
  /// The largest distance found, at `where`, a point of a hull; `nearest` is the point of S nearest
  /// to it. The true protrusion lies between `found` and `bound`. If S has openings, `found` refers
  /// to the surface; S may be nearer.
  double found = 0;
  Eigen::Vector3d where = Eigen::Vector3d::Zero();
  Eigen::Vector3d nearest = Eigen::Vector3d::Zero();
  /// Proved: no convex sets within the tolerance cover the mesh with fewer; see leastHulls().
  /// nullopt: the search did not need it, so it was not computed; leastHulls() does that.
  std::optional<std::size_t> least_hulls;
  /// What is proved of each of DecomposeOptions::regions: no point of a hull that is deeper in the
  /// region than its rim is further from S than this bound.
  std::vector<RegionProof> regions;
  /// bound <= tolerance + padding, and no more than its tolerance in each region
  bool within_tolerance = true;
  std::string reason;  ///< why not, and what to do about it; empty if it is
  /// What the deadline of the control cut short or left out, for people; empty: nothing.
  std::string untried;
  double nudge = 0;      ///< by which every hull was grown to absorb rounding
  double thickness = 0;  ///< given to flat hulls
  /// Wall clock [s] of the stages.
  struct Seconds {
    double repair = 0, decompose = 0, certify = 0;
  } seconds;
};

/// Repairs the mesh, decomposes it, and proves the result. Deterministic: the same mesh and options
/// give the same bytes, on any number of threads. With a deadline in the control the method
/// certified gives the best that it has by then; the search gets most of that time and the proof
/// the rest, but cover, rounding and a first bound take what they take.
///
/// Throws what repair() throws; kEmptyMesh for a mesh without triangles; kNonFiniteCoordinate and
/// kTooFarFromOrigin for one that single precision cannot hold or resolve, as readMesh();
/// kBadOption as check() of the options, for a tolerance that is not a positive length or below a
/// millionth of the mesh's diagonal (also with a method that ignores it), and for one of a region
/// that is below both that and kRegionSlack; kCancelled; kInternal if the result should fail its
/// own check.
CertifiedHulls certifiedHulls(const TriangleMesh& mesh, const DecomposeOptions& options,
                              const RunControl& control = {});

/// A mesh with what its caller has derived from it already. Refers to all of it, which must outlive
/// the call.
struct PreparedMesh {
  const TriangleMesh& original;  ///< what the hulls cover
  const RepairedMesh& repaired;  ///< what is decomposed
  const Solid& solid;            ///< of `repaired`: S
  /// [m] How far apart the surfaces of `original` and `solid` may lie; the bound includes it. At
  /// least repaired.counts.weld_distance; more if reading rounded the mesh. Less is kBadOption.
  double margin = 0;
  /// If given, the hulls are a cut through it, and nothing is decomposed. For the tolerance of its
  /// leaves or a larger one.
  const HullTree* tree = nullptr;
  std::string name = {};  ///< of the mesh, for messages
};

/// The same for a mesh that is prepared.
CertifiedHulls certifiedHulls(const PreparedMesh& mesh, const DecomposeOptions& options,
                              const RunControl& control = {});

/// The gap that certificate() leaves between bound and found value, as a share of the tolerance or
/// of the protrusion, whichever is more.
constexpr double kCertificateGap = 0.001;

/// The proof alone, for hulls from anywhere: their protrusion, with the margin [m] included in its
/// bound. Apart from the margin, bound and found value differ by at most kCertificateGap of the
/// tolerance [m], > 0, or of the protrusion where that is more, unless the search gives up (see
/// protrusion()). Where the bound would then exceed the tolerance, a second search goes on only
/// until it does not: the two then differ by at most the room that the found value leaves. Throws
/// kBadOption for a margin that is negative or not finite, or a tolerance that is not positive;
/// kCancelled, and what check() of hulls throws.
Protrusion certificate(const std::vector<ConvexHull>& hulls, const Solid& solid, double margin,
                       double tolerance, const RunControl& control = {});

/// Throws kInternal unless the hulls cover the mesh, and what uncovered() throws. `name`: of the
/// mesh, for the message.
void expectCovered(const TriangleMesh& mesh, const std::vector<ConvexHull>& hulls,
                   const std::string& name, const RunControl& control = {});

}  // namespace collision_hulls
