// The rows of the report, and the geometry beside them: put together once, when everything is known.
#pragma once

#include <vector>

#include "collision_hulls/pipeline/result.h"
#include "pipeline/mesh_uses.h"

namespace collision_hulls {

/// Fills the rows and elements of a result, with a file for each hull, relative to the output folder: meshes/<link>/ for a robot; for a
/// single mesh the folder itself, where an OBJ of all hulls comes first. Equal hulls of several models share a file. Adds the files of
/// segments to the extra ones. Notes meshes of suspicious sizes: above 20 m, and below their tolerance; and those of many hulls.
void putTogether(const std::vector<MeshUse>& uses, const MeshResults& results, RobotResult& result, const RunControl& control = {});

}  // namespace collision_hulls
