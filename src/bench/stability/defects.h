// The part of troubled() that changes which triangles there are, not only where they lie.
#pragma once

#include "bench/stability/trouble.h"
#include "geometry/random_stream.h"

namespace collision_hulls {

/// The mesh with a defect: any kind from kUnwelded on.
TriangleMesh defective(const TriangleMesh& mesh, const Trouble& trouble, Random& random);

}  // namespace collision_hulls
