// The steps of a run that are done in a process of their own, so that whatever happens there is a row and not the end.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// Does the job that a JSON file describes and writes what came of it to another file. Jobs, by "job":
///   prepare    "file", "scale"                          -> writes the repaired mesh to "cleaned" (OBJ);   "triangles", "diagonal"
///   decompose  "file", "scale", "method", "effort", "tolerance", "max_vertices", "seed"  -> writes the hulls to "hulls", an object each
///   score      "file", "scale", "tolerance", "hulls": [files of equal runs]  -> scores the first against the mesh as it was read:
///              "hulls", "hull_vertices", "uncovered", "protrusion", "protrusion_found", "volume_ratio" (null: encloses nothing),
///              "hashes" of all
///   decide     "file", "scale", "tolerance", "hulls": [a file for each method]  -> "results", one for each: "hulls", "uncovered",
///              "protrusion" (a bound within a tenth of the tolerance, and closer only where it takes that to tell whether it keeps the
///              tolerance), or why there is none: "error"; and "seconds" of CPU
///   query      see query_job.h
///   cuts       see cuts.h
/// Throws Error and what the libraries throw.
void doJob(const std::string& job_file, const std::string& result_file);

/// A mesh as OBJ, its coordinates to the last bit.
std::string toObj(const TriangleMesh& mesh);

/// Scores hulls against a mesh: what the job `score` does. See there.
nlohmann::json score(const nlohmann::json& job);

}  // namespace collision_hulls
