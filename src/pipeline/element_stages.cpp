// Reads and repairs a mesh, describes its hulls, validates all elements.
//
// A mesh's size is checked as soon as it is read: in the wrong unit it would keep the later stages busy for minutes, for nothing.
#include "pipeline/element_stages.h"

#include <algorithm>
#include <cstdio>

#include "base/stopwatch.h"
#include "collision_hulls/error.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/measure/solid.h"
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

// The longest links of robots, booms of large manipulators and gantries, are about 10 m. In millimetres read as metres, every link above
// 20 mm is larger than this limit.
constexpr double kLargestLink = 20;  // [m]

/// A percentage of the diagonal takes the same work in every unit, so it stays allowed: for the link that really is that large.
void checkSize(const ElementReport& row, const Length& tolerance) {
  if (row.diagonal <= kLargestLink || tolerance.limit == Length::kUnset) return;
  char size[64];
  std::snprintf(size, sizeof size, "%.3g m", row.diagonal);
  throw Error(ErrorCode::kTooLarge,
              "'" + row.uri + "' is " + size +
                  " across, larger than any robot link: if its numbers are millimetres, scale it by 0.001 (--scale "
                  "0.001 for a mesh file, scale=\"0.001 0.001 0.001\" in a description's <mesh>); if it really is that "
                  "large, give the tolerance only as a percentage, such as 1%");
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
  checkSize(row, options.tolerance);
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
  row.primitives = element.primitives.size();
  row.hulls = element.hulls.size() - row.primitives;
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

void noteSmallMeshes(Report& report) {
  const auto is_small = [](const ElementReport& row) { return row.status != Status::kFailed && row.tolerance > row.diagonal; };
  const auto first = std::find_if(report.links.begin(), report.links.end(), is_small);
  if (first == report.links.end()) return;
  const auto others = std::count_if(first, report.links.end(), is_small) - 1;
  report.notes.push_back("the tolerance of " + millimetres(first->tolerance) + " is larger than '" + first->uri + "', which is " +
                         millimetres(first->diagonal) + " across" +
                         (others > 0 ? ", and than " + std::to_string(others) + " other meshes" : "") +
                         ": one hull covers each; for more detail give a smaller tolerance, or one with a share, as in 1cm,5%");
}

std::string millimetres(double metres) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4g mm", 1000 * metres);
  return text;
}

}  // namespace collision_hulls
