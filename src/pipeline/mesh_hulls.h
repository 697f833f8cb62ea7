// From a repaired mesh to its hulls as written, and how far they protrude: steps 3 and 4 of the flow.
#pragma once

#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/measure/solid.h"
#include "collision_hulls/report/report.h"

namespace collision_hulls {

/// Share of the tolerance by which the two bounds of the protrusion may differ.
constexpr double kCertificateGap = 0.001;

/// A mesh as read and scaled, and what is derived from it.
struct MeshSource {
  const TriangleMesh& original;
  const RepairedMesh& repaired;
  const Solid& solid;
  double margin = 0;  ///< [m] how far the surfaces of `original` and `solid` may lie apart
};

struct MeshHulls {
  std::vector<ConvexHull> hulls;  ///< cover the original, with coordinates as written
  Protrusion protrusion;          ///< [m] its bound includes the margin
  double nudge = 0;               ///< [m] see ElementReport
  double thickness = 0;           ///< [m]
  bool capped = false;            ///< caps made the hulls coarser
  double blunted = 0;             ///< [m] see FittedHulls
};

/// The hulls' protrusion, with the margin included in its bound. Apart from the margin, bound and found value differ by at most
/// kCertificateGap of the tolerance; by less where only this gap would take the bound above the tolerance.
Protrusion certificate(const std::vector<ConvexHull>& hulls, const Solid& solid, double margin, double tolerance,
                       const RunControl& control = {});

/// Makes the hulls. The method `certified` gets further attempts with a lower aim if the certificate exceeds the tolerance. With a tree,
/// the hulls are a cut through it. Adds to seconds.decompose and seconds.certify. Throws what decompose() throws.
MeshHulls meshHulls(const MeshSource& source, const DecomposeOptions& options, StageSeconds& seconds, const RunControl& decomposing = {},
                    const RunControl& certifying = {}, const HullTree* tree = nullptr);

}  // namespace collision_hulls
