// Times collision and distance queries of one model of a robot or part, and compares them with those of its meshes.
#pragma once

#include <nlohmann/json.hpp>

namespace collision_hulls {

/// The job `query`:
///   "workload"   "scene" (against a cluttered table and shelf, at random configurations or, for a single mesh, poses) or "self" (a robot
///                against itself, without adjacent links and pairs whose meshes touch at rest)
///   "urdf"       the robot description; empty: one part that moves freely
///   "parts"      each "link" (index), "origin" (3 x 4, row by row), "file", "scale", "hulls" (OBJ; empty: the mesh itself)
///   "answers"    file with the meshes' answers: written if "original" is true, otherwise read
///   "seed", "states"
/// gives "collisions_per_second" and "distances_per_second" (states per second, each with all of its pairs, with a BoxedModel),
/// "tree_collisions_per_second" (collisions with FCL's dynamic trees), "bodies", "hit_rate" and, except for the original, "phantom_rate"
/// (share of the states without a hit on the meshes in which the hulls are hit), "missed" (states in which a mesh is hit and no hull),
/// "distance_error_mean" and "distance_error_max" (how much too near the hulls are [m], over those of the first hundred states in which the
/// meshes are free). Rates are null if no state counts.
nlohmann::json query(const nlohmann::json& job);

}  // namespace collision_hulls
