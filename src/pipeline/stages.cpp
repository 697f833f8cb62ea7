// Reads and repairs a mesh, builds its tree, measures its hulls, validates all uses of meshes.
//
// A mesh's size is checked as soon as it is read: in the wrong unit it would keep the later stages busy for minutes, for nothing.
#include "pipeline/stages.h"

#include <cstdio>
#include <optional>
#include <utility>

#include "base/stopwatch.h"
#include "collision_hulls/check/validate.h"
#include "collision_hulls/decompose/certified.h"
#include "collision_hulls/error.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {
namespace {

double toleranceFor(const TriangleMesh& mesh, const Options& options) {
  const double tolerance = options.tolerance.metres(diagonal(mesh));
  if (tolerance > 0) return tolerance;
  throw Error(ErrorCode::kEmptyMesh, "all " + std::to_string(mesh.triangles.size()) +
                                         " triangles lie in one point, so a percentage of the mesh's size is no tolerance for it; give "
                                         "only a length, such as 1mm, or repair the mesh");
}

/// A percentage of the diagonal takes the same work in every unit, so it stays allowed: for the link that really is that large.
void checkSize(const std::string& uri, double diagonal, const Length& tolerance) {
  if (diagonal <= kLargestLink || tolerance.limit == Length::kUnset) return;
  char size[64];
  std::snprintf(size, sizeof size, "%.3g m", diagonal);
  throw Error(ErrorCode::kTooLarge,
              "'" + uri + "' is " + size +
                  " across, larger than any robot link: if its numbers are millimetres, scale it by 0.001 (--scale "
                  "0.001 for a mesh file, scale=\"0.001 0.001 0.001\" in a description's <mesh>); if it really is that "
                  "large, give the tolerance only as a percentage, such as 1%");
}

MeshLimits meshLimits(const Options& options) {
  MeshLimits limits;
  limits.reader_memory = static_cast<std::uintmax_t>(options.reader_memory) << 20;
  limits.reader_seconds = options.reader_time;
  return limits;
}

}  // namespace

void checkForRobot(const Options& options) {
  if (options.scale == 1) return;
  char scale[64];
  std::snprintf(scale, sizeof scale, "%g", options.scale);
  const std::string s = scale;
  throw Error(ErrorCode::kBadOption, "scale '" + s +
                                         "' is for a single mesh; a robot's description scales its meshes itself: write scale=\"" + s +
                                         " " + s + " " + s + "\" in its <mesh> elements");
}

ReadMesh readAndRepair(const MeshTask& task, const Options& options, const RunControl& control, MeshResult& result) {
  MeshFacts& facts = result.mesh;
  Stopwatch stage;

  // 1. Read, and scale as the description says.
  facts.sha256 = task.sha256;
  LoadedMesh loaded = parseMesh(contentOf(task, control), task.file, meshLimits(options), control);
  facts.triangles = loaded.mesh.triangles.size();
  facts.skipped_primitives = loaded.skipped_primitives;
  result.original = scaled(loaded.mesh, task.scale);
  loaded.mesh = {};
  facts.diagonal = diagonal(result.original);
  checkSize(task.uri, facts.diagonal, options.tolerance);
  facts.tolerance = toleranceFor(result.original, options);
  result.seconds.read = stage.lap();

  // 2. Repair: a mesh with topology, and the solid that it stands for.
  ReadMesh read{repair(result.original, {}, control)};
  facts.repair = read.repaired.counts;
  read.margin = loaded.resolution * task.scale.cwiseAbs().maxCoeff() + read.repaired.counts.weld_distance;
  result.solid = std::make_shared<const Solid>(read.repaired, control);
  facts.interior = name(result.solid->interior());
  facts.volume = result.solid->volume();
  result.seconds.repair = stage.lap();
  return read;
}

/// The tree is built without a cap on hulls: caps choose a cut, so one tree serves them all.
CachedTree cachedTree(const MeshTask& task, const RepairedMesh& mesh, const Options& options, double tolerance, Cache& cache,
                      const RunControl& control) {
  const std::string key = treeKey(task, options, tolerance);
  if (std::optional<HullTree> known = cache.findTree(key)) return {std::move(*known), true};
  HullTree tree = hullTree(mesh, {options.method, tolerance, 0, options.max_vertices, options.seed, options.effort, options.fill}, control);
  cache.storeTree(key, tree);
  return {std::move(tree), false};
}

HullFacts factsOf(const std::vector<ConvexHull>& hulls, std::size_t primitives, const Solid& solid, const Protrusion& proof) {
  HullFacts facts;
  facts.primitives = primitives;
  facts.hulls = hulls.size() - primitives;
  for (std::size_t i = 0; i < facts.hulls; ++i) facts.hull_vertices += hulls[i].vertices.size();
  facts.protrusion = proof.bound;
  facts.protrusion_found = proof.found;
  facts.worst = proof.where;
  facts.worst_nearest = proof.nearest;
  facts.hull_volume = unionVolume(hulls);
  facts.covered_share = coveredShare(hulls, solid);
  return facts;
}

Validation validateUses(const std::vector<MeshUse>& uses, const MeshResults& results, std::uint64_t seed, const RunControl& control) {
  std::vector<ValidationPair> pairs;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const MeshUse& use = uses[i];
    const MeshResult& mesh = *results[i];
    if (mesh.hulls.empty()) continue;
    ValidationPair pair;
    pair.name = use.link + "/" + std::to_string(use.element);
    pair.original = transformed(mesh.original, use.pose);
    for (const ConvexHull& hull : mesh.hulls) pair.hulls.push_back(transformed(hull, use.pose));
    pair.protrusion = mesh.model.protrusion;
    pair.solid = mesh.solid;
    pair.solid_pose = use.pose;
    pairs.push_back(std::move(pair));
  }
  ValidationOptions options;
  options.seed = seed;
  return validate(pairs, options, control);
}

}  // namespace collision_hulls
