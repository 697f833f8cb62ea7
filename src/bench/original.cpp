// The margin adds the reader's rounding, in the mesh's scale, to the distance over which vertices were welded.
#include "bench/original.h"

#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {

Original readOriginal(const nlohmann::json& job) {
  const Eigen::Vector3d scale(job["scale"][0], job["scale"][1], job["scale"][2]);
  const LoadedMesh loaded = readMesh(job["file"]);
  Original original{scaled(loaded.mesh, scale), {}, 0};
  original.repaired = repair(original.mesh);
  original.margin = loaded.resolution * scale.cwiseAbs().maxCoeff() + original.repaired.counts.weld_distance;
  return original;
}

}  // namespace collision_hulls
