// Primitives and spheres in place of hulls.
#pragma once

#include <string>

#include "collision_hulls/decompose/hull_tree.h"
#include "pipeline/stages.h"

namespace collision_hulls {

/// [m] The tolerance of the leaves of a mesh's hull tree.
double treeLeaves(const LinkOptions& options, double diagonal);

/// Stages 3 and 4 as in decomposeAndCertify(), for options whose shapes are other ones than hulls. In the result primitives come last among
/// the hulls, which are polyhedra about them, and spheres last among these.
void shapeAndCertify(const ReadMesh& read, const LinkOptions& options, const HullTree* tree, const std::string& uri, std::uint64_t seed,
                     const RunControl& control, MeshResult& result);

}  // namespace collision_hulls
