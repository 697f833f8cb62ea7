// The flow on one screen, with numbered steps. Meshes run in parallel, the largest first, and equal meshes only once; a mesh that fails
// becomes a row and stops nothing else.
#include "collision_hulls/pipeline/decompose_robot.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "pipeline/collision_model.h"
#include "pipeline/earlier_output.h"
#include "pipeline/run.h"
#include "pipeline/stages.h"

namespace collision_hulls {
namespace {

constexpr double kMeshesShare = 0.9;  // of a run's time, approximately; the rest is the validation
constexpr double kTreeShare = 0.7;    // of a mesh's time, approximately, if a tree is built first

/// Where steps 3 and 4 of a mesh take their hulls from, if not from a decomposition.
std::optional<HullTree> treeFor(const MeshTask& task, std::size_t index, const ReadMesh& read, const MeshFacts& facts, Run& run) {
  if (!run.options.tree) return std::nullopt;
  RunControl building;
  run.progress.follow(building, index, 0, kTreeShare);
  const double leaves = std::min(run.options.tree->metres(facts.diagonal), facts.tolerance);
  return cachedTree(task, read.repaired, run.options, leaves, run.cache, building).tree;
}

/// Steps 3 and 4: decompose, make the hulls as written cover the mesh as read, certify. The solid is known only up to the margin, so the
/// bound includes it.
void makeHulls(const MeshTask& task, std::size_t index, const ReadMesh& read, Run& run, MeshResult& result) {
  Stopwatch stage;
  const std::optional<HullTree> tree = treeFor(task, index, read, result.mesh, run);
  result.seconds.decompose = stage.lap();
  RunControl control;
  run.progress.follow(control, index);
  const Options& options = run.options;
  CertifiedHulls made = certifiedHulls(
      {result.original, read.repaired, *result.solid, read.margin, tree ? &*tree : nullptr, task.uri},
      {options.method, result.mesh.tolerance, options.max_hulls, options.max_vertices, options.seed, options.effort, options.fill},
      control);
  stage.lap();
  result.hulls = std::move(made.hulls);
  result.model = factsOf(result.hulls, 0, *result.solid, {made.bound, made.found, made.where, made.nearest});
  result.model.nudge = made.nudge;
  result.model.thickness = made.thickness;
  result.status = made.within_tolerance ? Status::kOk : Status::kDegraded;
  result.reason = made.reason;
  result.seconds.decompose += made.seconds.decompose;
  result.seconds.certify = made.seconds.certify + stage.lap();
}

/// Steps 1 to 4 for one mesh.
MeshResult decomposed(const MeshTask& task, std::size_t index, const std::string& key, Run& run) {
  MeshResult result;
  try {
    RunControl reading;
    run.progress.follow(reading, index);
    // 1. Read, and scale as the description says. 2. Repair: a mesh with topology, and the solid that it encloses.
    const ReadMesh read = readAndRepair(task, run.options, reading, result);
    makeHulls(task, index, read, run, result);
    run.cache.storeMesh(key, result);
  } catch (...) {
    fail(result);
  }
  return result;
}

/// The mesh's result from an earlier run, if there is one.
std::optional<MeshResult> remembered(const MeshTask& task, const std::string& key, Cache& cache) {
  Stopwatch stage;
  std::optional<MeshResult> known = cache.findMesh(key, task.sha256);
  if (!known) return std::nullopt;
  known->cached = true;
  known->seconds.read = stage.lap();
  return known;
}

/// The clusters, for hulls from the cache as well: it does not keep them.
void addSegments(std::size_t index, Run& run, MeshResult& result) {
  RunControl control;
  run.progress.follow(control, index, 1, 1);
  try {
    result.segments = std::make_shared<const Segments>(segmentsOf(result.original, result.mesh.tolerance, control));
  } catch (...) {
    fail(result);
  }
}

void decomposeTask(std::size_t index, Run& run) {
  const MeshTask& task = run.tasks[index];
  const std::string key = meshKey(task, run.options);
  std::optional<MeshResult> known = remembered(task, key, run.cache);
  if (known) run.progress.skip(index);
  MeshResult result = known ? *std::move(known) : decomposed(task, index, key, run);
  if (run.options.segments && result.status != Status::kFailed) addSegments(index, run, result);
  const std::size_t hulls = result.hulls.size();
  finishTask(index, std::make_shared<const MeshResult>(std::move(result)), hulls, run);
}

/// 5. Validate by queries: the original against the hulls. From the cache if possible.
void validateOrRemember(Run& run) {
  std::vector<std::string> keys(run.uses.size());
  for (const MeshTask& task : run.tasks) {
    for (const std::size_t i : task.uses) keys[i] = meshKey(task, run.options);
  }
  run.progress.begin("validate", 1);
  const std::string key = validationKey(run.uses, run.results, keys, run.options);
  const std::optional<Validation> known = run.cache.findValidation(key);
  RunControl validating;
  run.progress.follow(validating, 0);
  if (known) run.progress.skip(0);
  run.report.validation = known ? *known : validateUses(run.uses, run.results, run.options.seed, validating);
  run.report.validation_cached = known.has_value();
  if (!known) run.cache.storeValidation(key, run.report.validation);
}

/// Steps 1 to 4, once per mesh; then step 5.
void decomposeAll(Run& run) {
  forEachInTurn(run.tasks.size(), [&](std::size_t i) { decomposeTask(i, run); });
  if (run.options.validate) validateOrRemember(run);
}

double meshesEnd(const Options& options) {
  return options.validate ? kMeshesShare : 1;
}

}  // namespace

RobotResult decomposeRobot(const RobotDescription& robot, const PackageFinder& find_package, const Options& options,
                           const std::string& output, const RunControl& control, const StepCallback& step) {
  check(options);
  checkForRobot(options);
  Stopwatch run;
  refuseLosingVisuals(robot, output, find_package);
  RobotResult result = emptyResult(robot, options, control);
  const std::vector<MeshUse> uses = meshUses(robot, options);
  const auto resolve = [&](const std::string& uri) { return resolveUri(uri, robot.path, find_package); };
  runStages({uses, resolve, meshesEnd(options), control, step}, result, decomposeAll);
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
  MeshUse use;
  use.link = result.robot_name;
  use.source.uri = path;
  use.source.scale.setConstant(options.scale);
  const std::vector<MeshUse> uses{use};
  const auto resolve = [](const std::string& file) { return file; };
  runStages({uses, resolve, meshesEnd(options), control, step}, result, decomposeAll);
  result.report.input_sha256 = result.report.links.front().sha256;
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
