// Collision and distance queries of one model of a robot or part, timed, and held against those of its meshes.
#pragma once

#include <nlohmann/json.hpp>

namespace collision_hulls {

/// The job `query`:
///   "workload"   "scene" (against a cluttered table and shelf, at random configurations or, for a single mesh, poses) or "self" (a robot
///                against itself; adjacent links, and pairs that touch at rest as meshes, are left out)
///   "urdf"       the description; empty: one part that flies freely
///   "parts"      each "link" (index), "origin" (3 x 4, row by row), "file", "scale", "hulls" (OBJ; empty: the mesh itself)
///   "answers"    of the meshes: written where "original" is true, else read
///   "seed", "states"
/// gives "collisions_per_second", "distances_per_second" (of states, each with all of its pairs, by a BoxedModel),
/// "tree_collisions_per_second" (the former in FCL's dynamic trees), "bodies", "hit_rate", and but for the
/// original "phantom_rate" (share of the states that hit no mesh where the hulls are hit), "missed" (states that hit a mesh and no hull),
/// "distance_error_mean", "distance_error_max" (how much too near the hulls are [m], over those of the first hundred states in
/// which the meshes are free).
/// Rates are null where no state counts.
nlohmann::json query(const nlohmann::json& job);

}  // namespace collision_hulls
