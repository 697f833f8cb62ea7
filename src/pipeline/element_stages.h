// Stages that decomposing a robot and fitting it to a scene have in common.
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

/// Stages 1 and 2. Fills original and solid of `element`, whose row says which scale it has, and what its row tells about them.
ReadMesh readElement(const MeshTask& mesh, const Options& options, const RunControl& control, ElementResult& element);

/// Number of an element's hulls, as files hold them, and volumes, for its row.
void describe(ElementResult& element);

/// Gives the result of `from` to an element that has the same mesh elsewhere; the time was spent once.
void copyResult(const ElementResult& from, ElementResult& to);

/// Stage 5, for the elements that have hulls.
Validation validateElements(const std::vector<ElementResult>& elements, std::uint64_t seed, const RunControl& control);

/// "12.5 mm"
std::string millimetres(double metres);

}  // namespace collision_hulls
