// Jobs: the steps of a benchmark that run in a process of their own, so that a crash or hang becomes a row instead of ending the run.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// Does the job that a JSON file describes and writes the result to another file. Jobs, by "job":
///   prepare    "file", "scale"                          -> writes the repaired mesh to "cleaned" (OBJ);   "triangles", "diagonal"
///   decompose  "file", "scale", "method", "effort", "tolerance", "max_vertices", "seed"  -> writes the hulls to "hulls", one object each
///   score      "file", "scale", "tolerance", "hulls": [files of equal runs]  -> scores the first file against the mesh as it was read:
///              "hulls", "hull_vertices", "uncovered", "protrusion", "protrusion_found", "volume_ratio" (null: the mesh encloses nothing),
///              "hashes" of all files; if "least" is true also "least_hulls", by Effort::kBest
///   decide     "file", "scale", "tolerance", "hulls": [one file per method]  -> "results", one per file: "hulls", "uncovered",
///              "protrusion" (a bound within a tenth of the tolerance, closer only if needed to decide whether the tolerance is kept)
///              or, on failure, "error"; and CPU "seconds"
///   query      see query_job.h
///   cuts       see cuts.h
/// Throws Error and what the libraries throw.
void doJob(const std::string& job_file, const std::string& result_file);

/// A mesh as OBJ, with coordinates exact to the last bit.
std::string toObj(const TriangleMesh& mesh);

/// Scores hulls against a mesh: the job `score`, see above.
nlohmann::json score(const nlohmann::json& job);

}  // namespace collision_hulls
