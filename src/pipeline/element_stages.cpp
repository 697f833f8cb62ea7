#include "pipeline/element_stages.h"

#include <cstdio>

#include "collision_hulls/check/measures.h"
#include "collision_hulls/check/solid.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "pipeline/stopwatch.h"

namespace collision_hulls {
namespace {

double toleranceFor(const TriangleMesh& mesh, const Options& options) {
  const double tolerance = options.tolerance.metres(diagonal(mesh));
  if (tolerance > 0) return tolerance;
  throw Error(ErrorCode::kEmptyMesh, "all " + std::to_string(mesh.triangles.size()) +
                                         " triangles lie in one point, so a share of the mesh's size is no tolerance for it; give a length "
                                         "alone, as in 1mm, or mend the mesh");
}

}  // namespace

ReadMesh readElement(const MeshTask& mesh, const Options& options, const RunControl& control, ElementResult& element) {
  ElementReport& row = element.report;
  Stopwatch stage;

  // 1. Read, and scale as the description says.
  LoadedMesh loaded = readMesh(mesh.file, {}, control);
  expectUnchanged(mesh);
  row.triangles = loaded.mesh.triangles.size();
  row.skipped_primitives = loaded.skipped_primitives;
  element.original = scaled(loaded.mesh, row.scale);
  loaded.mesh = {};
  row.diagonal = diagonal(element.original);
  row.tolerance = toleranceFor(element.original, options);
  row.seconds.read = stage.lap();

  // 2. Repair: a mesh with topology, and the solid that it stands for.
  ReadMesh read{repair(element.original, {}, control)};
  row.repair = read.repaired.counts;
  read.margin = loaded.resolution * row.scale.cwiseAbs().maxCoeff() + read.repaired.counts.weld_distance;
  element.solid = std::make_shared<const Solid>(read.repaired, control);
  row.interior = name(element.solid->interior());
  row.volume = element.solid->volume();
  row.seconds.repair = stage.lap();
  return read;
}

void describe(ElementResult& element) {
  ElementReport& row = element.report;
  row.hulls = element.hulls.size() - element.primitives.size();
  row.hull_volume = unionVolume(element.hulls);
  row.covered_share = coveredShare(element.hulls, *element.solid);
  for (std::size_t i = 0; i < row.hulls; ++i) row.hull_vertices += element.hulls[i].vertices.size();
}

void copyResult(const ElementResult& from, ElementResult& to) {
  ElementReport row = from.report;
  row.link = to.report.link;
  row.element = to.report.element;
  row.visual = to.report.visual;
  row.uri = to.report.uri;
  row.seconds = {};
  to.report = row;
  to.original = from.original;
  to.hulls = from.hulls;
  to.primitives = from.primitives;
  to.unneeded = from.unneeded;
  to.solid = from.solid;
}

Validation validateElements(const std::vector<ElementResult>& elements, std::uint64_t seed, const RunControl& control) {
  std::vector<ValidationPair> pairs;
  for (const ElementResult& element : elements) {
    if (element.hulls.empty()) continue;
    ValidationPair pair;
    pair.name = element.report.link + "/" + std::to_string(element.report.element);
    pair.original = transformed(element.original, element.pose);
    for (const ConvexHull& hull : element.hulls) pair.hulls.push_back(transformed(hull, element.pose));
    pair.protrusion = element.report.protrusion;
    pair.solid = element.solid;
    pair.solid_pose = element.pose;
    pairs.push_back(std::move(pair));
  }
  ValidationOptions options;
  options.seed = seed;
  return validate(pairs, options, control);
}

std::string millimetres(double metres) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4g mm", 1000 * metres);
  return text;
}

}  // namespace collision_hulls
