// The segmentation of a mesh, the first result of Mamou & Ghorbel 2009, and its files: what
// Options::segments asks for.
#pragma once

#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/decompose/hacd.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {

struct Segments {
  TriangleMesh mesh;          ///< as repaired, in the frame of the mesh that it was made from [m]
  Segmentation segmentation;  ///< clusters of its triangles
};

/// Repairs a mesh as decomposing does, so that hull k of the method hacd is that of cluster k
/// unless a limit joined hulls. `epsilon` [m]: see hacdPartition(). Throws as that and as repair().
Segments segmentsOf(const TriangleMesh& original, double epsilon, const RunControl& control = {});

/// The colour of cluster k. Those of consecutive clusters differ clearly.
Rgb clusterColour(std::size_t k);

/// The mesh as binary PLY, in its clusters' colours; see encodePly().
std::string segmentsPly(const Segments& segments);

/// The hierarchy as CSV: `concavity,clusters`, a row for each concavity [m] at which clusters
/// merge, once there are at most 1,000: K(e) is in the last row whose concavity is at most e.
std::string hierarchyCsv(const Segments& segments);

}  // namespace collision_hulls
