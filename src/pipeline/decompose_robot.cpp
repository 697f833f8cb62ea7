// The flow on one screen, with numbered steps. Meshes run in parallel, the largest first, and equal meshes only once; a mesh that fails
// becomes a row and stops nothing else.
#include "collision_hulls/pipeline/decompose_robot.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "collision_hulls/check/validate.h"
#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/error.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/measure/solid.h"
#include "pipeline/cache.h"
#include "pipeline/cached_tree.h"
#include "pipeline/collision_model.h"
#include "pipeline/earlier_output.h"
#include "pipeline/element_stages.h"
#include "pipeline/elements.h"
#include "pipeline/mesh_hulls.h"
#include "pipeline/progress.h"

namespace collision_hulls {
namespace {

constexpr double kMeshesShare = 0.9;     // of a run's time, approximately; the rest is the validation
constexpr double kDecomposeShare = 0.7;  // of an element's time, approximately
constexpr double kMuch = 0.1;            // of the protrusion: if blunting exceeds this share, it is named as the cause

/// Why hulls protrude further than the tolerance, and what to do about it.
std::string excuse(const Options& options, const MeshHulls& made) {
  if (options.method == Method::kSingleHull || options.method == Method::kBoundingBox)
    return std::string(name(options.method)) + " ignores the tolerance; use another method";
  const std::string vertices = "max-vertices " + std::to_string(options.max_vertices);
  if (made.capped && (options.max_hulls > 0 || options.method == Method::kCertified))
    return "the limits (max-hulls " + std::to_string(options.max_hulls) + ", " + vertices + ") made the hulls coarser; raise them";
  if (options.method == Method::kHacd) {
    return "hacd measures concavity along rays, which does not bound the protrusion; give a smaller tolerance, which makes more hulls";
  }
  if (options.method == Method::kAcd) {
    return "acd measures concavity at reflex edges, which does not bound the protrusion; give a smaller tolerance, which makes more hulls";
  }
  if (made.blunted > kMuch * made.protrusion.bound)
    return "with so few vertices (" + vertices + ") thin hulls protrude up to " + millimetres(made.blunted) + " further; raise that limit";
  return "the surface has details there that no plane divided; repair the mesh or accept it";
}

void grade(ElementReport& row, const Options& options, const MeshHulls& made) {
  if (row.uncovered > 0) {
    throw Error(ErrorCode::kInternal, "the hulls leave the surface uncovered by up to " + millimetres(row.uncovered) +
                                          "; the limit is 0. Please report the mesh '" + row.uri + "'");
  }
  if (row.protrusion <= row.tolerance) return;
  row.status = Status::kDegraded;
  row.reason = "the hulls protrude by up to " + millimetres(row.protrusion) + ", more than the tolerance of " + millimetres(row.tolerance) +
               ": " + excuse(options, made);
}

/// The stages for one mesh. Fills report, original and hulls of `element`, whose row holds the scale.
void decomposeElement(const MeshTask& mesh, const Options& options, Cache& cache, Progress& progress, std::size_t task,
                      ElementResult& element) {
  ElementReport& row = element.report;
  RunControl decomposing, certifying;
  progress.follow(decomposing, task, 0, kDecomposeShare);
  progress.follow(certifying, task, kDecomposeShare, 1);
  // 1. Read, and scale as the description says. 2. Repair: a mesh with topology, and the solid that it encloses.
  const ReadMesh read = readElement(mesh, options, decomposing, element);

  // 3. Decompose, then make the hulls as written cover the mesh as read.
  // 4. Certify. The solid is known only up to the margin, so the bound includes it.
  const DecomposeOptions method{options.method, row.tolerance,  options.max_hulls, options.max_vertices,
                                options.seed,   options.effort, options.fill};
  Stopwatch stage;
  std::optional<HullTree> tree;
  if (options.tree) {
    const double leaves = std::min(options.tree->metres(row.diagonal), row.tolerance);
    tree = cachedTree(mesh.file, row, read.repaired, options, leaves, cache, decomposing).tree;
    row.seconds.decompose = stage.lap();
  }
  MeshHulls made = meshHulls({element.original, read.repaired, *element.solid, read.margin}, method, row.seconds, decomposing, certifying,
                             tree ? &*tree : nullptr);
  element.hulls = std::move(made.hulls);
  row.nudge = made.nudge;
  row.thickness = made.thickness;
  row.protrusion = made.protrusion.bound;
  row.protrusion_found = made.protrusion.found;
  row.worst = made.protrusion.where;
  row.worst_nearest = made.protrusion.nearest;
  stage.lap();
  row.uncovered = uncovered(element.original, element.hulls, certifying);
  describe(element);
  row.seconds.certify += stage.lap();

  grade(row, options, made);
}

/// Takes the mesh's result from an earlier run; false if there is none.
bool takeFromCache(const std::string& key, Cache& cache, ElementResult& element) {
  Stopwatch stage;
  const std::optional<ElementResult> known = cache.findElement(key);
  if (!known) return false;
  copyResult(*known, element);
  element.report.cached = true;
  element.report.seconds.read = stage.lap();
  return true;
}

void decomposeTask(const MeshTask& task, std::size_t index, const Options& options, Cache& cache, Progress& progress,
                   std::vector<ElementResult>& elements) {
  ElementResult& first = elements[task.elements.front()];
  const std::string key = elementKey(first.report, task.file, options);
  try {
    if (takeFromCache(key, cache, first)) {
      progress.skip(index);
    } else {
      decomposeElement(task, options, cache, progress, index, first);
      cache.storeElement(key, first);
    }
  } catch (...) {
    fail(first);
  }
  progress.finish(index);
  for (const std::size_t i : task.elements) {
    if (i != task.elements.front()) copyResult(first, elements[i]);
    progress.finishElement(elements[i].report.link, elements[i].hulls.size());
  }
}

/// Fills the report's validation, from the cache if possible.
void validateOrRemember(RobotResult& result, const std::vector<MeshTask>& tasks, Cache& cache, Progress& progress) {
  const Options& options = result.report.options;
  std::vector<std::string> keys(result.elements.size());
  for (const MeshTask& task : tasks) {
    for (const std::size_t i : task.elements) keys[i] = elementKey(result.elements[i].report, task.file, options);
  }
  const std::string key = validationKey(result.elements, keys, options);
  const std::optional<Validation> known = cache.findValidation(key);
  RunControl validating;
  progress.follow(validating, 0);
  if (known) progress.skip(0);
  result.report.validation = known ? *known : validateElements(result.elements, options.seed, validating);
  result.report.validation_cached = known.has_value();
  if (!known) cache.storeValidation(key, result.report.validation);
}

using UriResolver = std::function<std::string(const std::string& uri)>;

/// All elements of a result, then the validation.
void decomposeElements(RobotResult& result, const UriResolver& resolve, const RunControl& control, const StepCallback& step) {
  const Options& options = result.report.options;
  std::vector<ElementResult>& elements = result.elements;
  Cache cache(options.cache ? cacheFolder() : std::filesystem::path());
  withJobs(options.jobs, [&] {
    Progress progress(control, step, elements.size());
    const std::vector<MeshTask> tasks = meshTasks(elements, resolve);
    progress.begin("decompose", options.validate ? kMeshesShare : 1, expectedCosts(tasks));
    for (const ElementResult& element : elements) {
      if (element.report.status == Status::kFailed) progress.finishElement(element.report.link, 0);
    }
    // Steps 1 to 4, once per mesh.
    forEachInTurn(tasks.size(), [&](std::size_t i) { decomposeTask(tasks[i], i, options, cache, progress, elements); });
    // 5. Validate by queries: the original against the hulls.
    if (options.validate) {
      progress.begin("validate", 1);
      validateOrRemember(result, tasks, cache, progress);
    }
    progress.end();
  });
  cache.trim();
  result.report.notes = cache.notes();
  for (ElementResult& element : elements) element.solid = nullptr;
  reportElements(result);
  noteSmallMeshes(result.report);
}

}  // namespace

RobotResult decomposeRobot(const RobotDescription& robot, const PackageFinder& find_package, const Options& options,
                           const std::string& output, const RunControl& control, const StepCallback& step) {
  check(options);
  checkForRobot(options);
  Stopwatch run;
  refuseLosingVisuals(robot, output, find_package);
  RobotResult result = robotResult(robot, options);
  decomposeElements(
      result, [&](const std::string& uri) { return resolveUri(uri, robot.path, find_package); }, control, step);
  rewriteDescription(robot, find_package, output, {}, result);
  result.report.seconds = run.lap();
  return result;
}

RobotResult decomposeMesh(const std::string& path, const Options& options, const RunControl& control, const StepCallback& step) {
  check(options);
  Stopwatch run;
  RobotResult result;
  result.single_mesh = true;
  result.robot_name = std::filesystem::path(path).stem().string();
  result.report.input_path = path;
  result.report.options = options;
  ElementResult element;
  element.source.uri = path;
  element.report.link = result.robot_name;
  element.report.uri = path;
  element.report.scale.setConstant(options.scale);
  element.report.method = options.method;
  result.elements.push_back(element);
  decomposeElements(
      result, [](const std::string& file) { return file; }, control, step);
  result.report.input_sha256 = result.elements.front().report.sha256;
  result.report.seconds = run.lap();
  return result;
}

RobotResult decompose(const Input& input, const Options& options, const std::string& output, const RunControl& control,
                      const StepCallback& step) {
  if (input.kind == Input::Kind::kRobot) return decomposeRobot(input.robot, input.find_package, options, output, control, step);
  refuseLosingInput(input.path, output);
  return decomposeMesh(input.path, options, control, step);
}

}  // namespace collision_hulls
