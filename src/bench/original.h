// The mesh of a job.
#pragma once

#include <nlohmann/json.hpp>

#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

/// A mesh as read and scaled, and its repaired form.
struct Original {
  TriangleMesh mesh;
  RepairedMesh repaired;
  double margin = 0;  ///< [m] how far apart the two may lie
};

/// The mesh of a job's "file" and "scale". Throws what readMesh() and scaled() throw.
Original readOriginal(const nlohmann::json& job);

}  // namespace collision_hulls
