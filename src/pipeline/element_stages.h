// Stages that decomposing a robot and fitting it to a scene have in common, and checks of sizes before the long work.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/mesh/repair.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "pipeline/elements.h"

namespace collision_hulls {

struct ReadMesh {
  RepairedMesh repaired;
  double margin = 0;  ///< [m] how far original points may lie from the repaired mesh
};

/// Throws kBadOption for options that only a single mesh takes.
void checkForRobot(const Options& options);

/// Stages 1 and 2. `element`'s row has the scale; fills its original and solid, and what the row says about them. Throws kTooLarge for a
/// mesh above 20 m where the tolerance has a length: its numbers are probably millimetres, and the work would take minutes.
ReadMesh readElement(const MeshTask& mesh, const Options& options, const RunControl& control, ElementResult& element);

/// Fills the number of hulls, as files hold them, and the volumes in the element's row.
void describe(ElementResult& element);

/// Gives the result of `from` to an element with the same mesh. The seconds stay with `from`, so that they count once.
void copyResult(const ElementResult& from, ElementResult& to);

/// Stage 5, for the elements that have hulls.
Validation validateElements(const std::vector<ElementResult>& elements, std::uint64_t seed, const RunControl& control);

/// Notes meshes that are smaller than the tolerance: each becomes a single hull.
void noteSmallMeshes(Report& report);

/// "12.5 mm"
std::string millimetres(double metres);

}  // namespace collision_hulls
