// The mesh of a job, as a benchmark writes it down and as the job reads it.
#pragma once

#include <nlohmann/json.hpp>

#include "bench/inputs.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

/// The job `rest` with the "file" and "scale" of a mesh.
nlohmann::json toJob(const BenchmarkMesh& mesh, nlohmann::json rest = nlohmann::json::object());

/// The mesh of a job's "file" and "scale". Throws what readMesh() and scaled() throw.
TriangleMesh meshOf(const nlohmann::json& job);

/// A mesh as read and scaled, and its repaired form.
struct Original {
  TriangleMesh mesh;
  RepairedMesh repaired;
  double margin = 0;  ///< [m] how far apart the two may lie
};

/// The same mesh with its repaired form.
Original readOriginal(const nlohmann::json& job);

}  // namespace collision_hulls
