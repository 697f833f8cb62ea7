// The margin adds the reader's rounding, in the mesh's scale, to the distance over which vertices were welded.
#include "bench/original.h"

#include <utility>

#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {
namespace {

using nlohmann::json;

Eigen::Vector3d scaleOf(const json& job) {
  return Eigen::Vector3d(job["scale"][0], job["scale"][1], job["scale"][2]);
}

}  // namespace

json toJob(const BenchmarkMesh& mesh, json rest) {
  rest["file"] = mesh.file;
  rest["scale"] = {mesh.scale.x(), mesh.scale.y(), mesh.scale.z()};
  return rest;
}

TriangleMesh meshOf(const json& job) {
  return scaled(readMesh(job["file"]).mesh, scaleOf(job));
}

Original readOriginal(const json& job) {
  const Eigen::Vector3d scale = scaleOf(job);
  const LoadedMesh loaded = readMesh(job["file"]);
  Original original{scaled(loaded.mesh, scale), {}, 0};
  original.repaired = repair(original.mesh);
  original.margin = readingError(loaded.resolution) * scale.cwiseAbs().maxCoeff() + original.repaired.counts.weld_distance;
  return original;
}

}  // namespace collision_hulls
