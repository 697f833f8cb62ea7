// From a repaired mesh to its hulls as they are written, with how far they protrude: steps 3 and 4 of the flow.
#pragma once

#include "collision_hulls/check/measures.h"
#include "collision_hulls/check/solid.h"
#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/pipeline/report.h"

namespace collision_hulls {

/// Of the tolerance: how far apart the two bounds of the protrusion may stay.
constexpr double kCertificateGap = 0.001;

/// A mesh as it was read and scaled, and what is made of it.
struct MeshSource {
  const TriangleMesh& original;
  const RepairedMesh& repaired;
  const Solid& solid;
  double margin = 0;  ///< [m] how far the surfaces of `original` and `solid` may lie apart
};

struct MeshHulls {
  std::vector<ConvexHull> hulls;  ///< they cover the original in the coordinates as written
  Protrusion protrusion;          ///< [m] its bound has the margin added
  double nudge = 0;               ///< [m] see ElementReport
  double thickness = 0;           ///< [m]
  bool capped = false;            ///< caps made the hulls coarser
  double blunted = 0;             ///< [m] see FittedHulls
};

/// The hulls' protrusion with the margin in its bound, of which the gap to what was found is kCertificateGap of the tolerance at most; less
/// where it alone would take the bound above the tolerance.
Protrusion certificate(const std::vector<ConvexHull>& hulls, const Solid& solid, double margin, double tolerance,
                       const RunControl& control = {});

/// The method `certified` gets further attempts with a lower aim where the certificate finds more than the tolerance. Adds to
/// seconds.decompose and seconds.certify. With a tree hulls are cut from it instead. Throws what decompose() throws.
MeshHulls meshHulls(const MeshSource& source, const DecomposeOptions& options, StageSeconds& seconds, const RunControl& decomposing = {},
                    const RunControl& certifying = {}, const HullTree* tree = nullptr);

}  // namespace collision_hulls
