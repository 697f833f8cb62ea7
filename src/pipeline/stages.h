// Stages that decomposing a robot and fitting it to a scene have in common, and checks of sizes before the long work.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/mesh/repair.h"
#include "pipeline/cache.h"
#include "pipeline/mesh_uses.h"

namespace collision_hulls {

/// Throws kBadOption for options that only a single mesh takes.
void checkForRobot(const Options& options);

/// A mesh after stages 1 and 2, for the stages that follow.
struct ReadMesh {
  RepairedMesh repaired;
  double margin = 0;  ///< [m] how far original points may lie from the repaired mesh
};

/// Stages 1 and 2. `result` gets the original, its solid and what is known of it, as far as the work goes: a mesh that fails keeps it.
/// Throws kTooLarge for a mesh above 20 m where the tolerance has a length: its numbers are probably millimetres, and the work would take
/// minutes.
ReadMesh readAndRepair(const MeshTask& task, const Options& options, const RunControl& control, MeshResult& result);

struct CachedTree {
  HullTree tree;
  bool found = false;  ///< in the cache
};

/// The hull tree of a task's mesh, with leaves for `tolerance` [m]: from the cache, or built and stored there.
CachedTree cachedTree(const MeshTask& task, const RepairedMesh& mesh, const Options& options, double tolerance, Cache& cache,
                      const RunControl& control);

/// What is known of certified hulls. `primitives`: how many of them, the last ones, stand for primitives, and are written as such.
HullFacts factsOf(const std::vector<ConvexHull>& hulls, std::size_t primitives, const Solid& solid, const Protrusion& proof);

/// Stage 5, for the uses that have hulls.
Validation validateUses(const std::vector<MeshUse>& uses, const MeshResults& results, std::uint64_t seed, const RunControl& control);

}  // namespace collision_hulls
