// The flow on one screen, with numbered steps. Meshes run in parallel, the largest first, and equal meshes only once; a mesh that fails
// becomes a row and stops nothing else.
#include "collision_hulls/pipeline/decompose_robot.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/counted.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/decompose/least_hulls.h"
#include "collision_hulls/report/totals.h"
#include "decompose/coarser/coarser_cuts.h"
#include "pipeline/collision_model.h"
#include "pipeline/contacts/rest_contacts.h"
#include "pipeline/earlier_output.h"
#include "pipeline/run.h"
#include "pipeline/shapes/shapes.h"
#include "pipeline/stages.h"

namespace collision_hulls {
namespace {

constexpr double kMeshesShare = 0.9;  // of a run's time, approximately; the rest is the validation
constexpr double kTreeShare = 0.7;    // of a mesh's time, approximately, if a tree is built first

constexpr std::size_t kMostHulls = 33'333;  // of a model: each takes three elements of its description, which may have 100,000

/// The hulls that a robot's models have so far, so that too many end the run at once: nobody could read their description. Thread safe.
class HullCount {
 public:
  explicit HullCount(const Run& run) : run_(run), of_model_(1 + run.report.models.size()) {}

  /// Throws kTooLarge.
  void add(const MeshVariant& variant, std::size_t hulls) { replace(variant, 0, hulls); }

  /// The same for a variant that has counted as `before`.
  void replace(const MeshVariant& variant, std::size_t before, std::size_t hulls) {
    if (run_.report.urdf.empty()) return;  // a single mesh, which has no description
    for (const std::size_t use : variant.uses) {
      if ((of_model_[run_.uses[use].model] += hulls - before) <= kMostHulls) continue;
      throw Error(ErrorCode::kTooLarge, "the robot has more than " + std::to_string(kMostHulls) + " hulls with those of link '" +
                                            run_.uses[use].link +
                                            "', above the limit of a model; give a larger tolerance, fewer max-hulls or fewer links");
    }
  }

 private:
  const Run& run_;
  std::vector<std::atomic<std::size_t>> of_model_;
};

/// The work on one variant of a task.
struct VariantWork {
  std::size_t task = 0;
  const LinkOptions& options;
  std::size_t variants = 1;  // of the task, from this one on
  double from = 0, to = 1;   // of the work on the task

  void follow(RunControl& control, Run& run, double part_from = 0, double part_to = 1) const {
    run.progress.follow(control, task, from + (to - from) * part_from, from + (to - from) * part_to);
  }
};

/// Where steps 3 and 4 of a mesh take their hulls from, if not from a decomposition.
std::shared_ptr<const HullTree> treeFor(const VariantWork& work, const MeshFacts& facts, SharedMesh& mesh, Run& run) {
  if (!work.options.tree && work.options.shapes != Shapes::kPrimitives) return nullptr;
  RunControl building;
  work.follow(building, run, 0, kTreeShare);
  return mesh.tree(work.options, treeLeaves(work.options, facts.diagonal), building);
}

/// The search may have found the bound already. For other methods, which take a fraction of the time, and for padded hulls and other shapes
/// nobody looks for one; nor without time left, which is then told.
std::size_t leastHullsOf(const LinkOptions& options, const RunControl& control, MeshResult& mesh) {
  if (options.method != Method::kCertified || options.padding > 0 || options.shapes != Shapes::kHulls) return 1;
  if (mesh.model.least_hulls > 1) return mesh.model.least_hulls;
  const std::vector<ConvexHull> none;
  const std::vector<ConvexHull>& hulls = mesh.status == Status::kOk ? mesh.hulls : none;
  if (hulls.size() == 1) return 1;
  const std::size_t least =
      control.late() ? 1 : leastHulls(mesh.original, *mesh.solid, mesh.mesh.tolerance, hulls, options.effort, control);
  if (control.late()) mesh.untried += std::string(mesh.untried.empty() ? "" : ", ") + "a lower bound on hulls";
  return least;
}

/// When one of `count` equal pieces of work that end at `end` should be done.
RunControl::Time partOf(const RunControl::Time& end, std::size_t count) {
  if (end == RunControl::Time::max()) return end;
  const RunControl::Time now = std::chrono::steady_clock::now();
  return now + (end - now) / static_cast<RunControl::Time::rep>(count);
}

bool heedsTimeLimit(const LinkOptions& options) {
  return options.method == Method::kCertified && !options.tree && (options.shapes == Shapes::kHulls || options.shapes == Shapes::kMixed);
}

/// Steps 3 and 4: decompose, make the hulls as written cover the mesh as read, certify.
void makeHulls(const VariantWork& work, const ReadMesh& read, SharedMesh& mesh, Run& run, MeshResult& result) {
  Stopwatch stage;
  const std::shared_ptr<const HullTree> tree = treeFor(work, result.mesh, mesh, run);
  result.seconds.decompose = stage.lap();
  RunControl control;
  work.follow(control, run);
  if (heedsTimeLimit(work.options)) control.deadline = partOf(run.time.begin(work.task), work.variants);
  decomposeAndCertify(read, work.options, tree.get(), run.tasks[work.task].uri, run.options.seed, control, result);
  if (tree && work.options.shapes == Shapes::kHulls && work.options.padding == 0)
    result.coarser = coarserCuts(*tree, {result.hulls, result.model.protrusion, result.mesh.tolerance, work.options.max_hulls,
                                         work.options.max_vertices, read.margin, result.model.nudge});
  stage.lap();
  result.model.least_hulls = leastHullsOf(work.options, control, result);
  result.seconds.certify += stage.lap();
}

/// Steps 1 to 4 for one mesh.
MeshResult decomposed(const VariantWork& work, SharedMesh& mesh, Run& run) {
  MeshResult result;
  try {
    RunControl reading;
    work.follow(reading, run);
    // 1. Read, and scale as the description says. 2. Repair: a mesh with topology, and the solid that it encloses.
    const ReadMesh& read = mesh.read(work.options, reading, result);
    makeHulls(work, read, mesh, run, result);
    if (result.untried.empty()) run.cache.storeMesh(meshKey(run.tasks[work.task], work.options, run.options.seed), result);
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

/// What the cache has of each variant.
std::vector<std::optional<MeshResult>> rememberedVariants(const MeshTask& task, Run& run) {
  std::vector<std::optional<MeshResult>> known;
  for (const MeshVariant& variant : task.variants)
    known.push_back(remembered(task, meshKey(task, variant.options, run.options.seed), run.cache));
  return known;
}

void decomposeTask(std::size_t index, HullCount& written, Run& run) {
  const MeshTask& task = run.tasks[index];
  std::vector<std::optional<MeshResult>> results = rememberedVariants(task, run);
  if (std::all_of(results.begin(), results.end(), [](const auto& known) { return known.has_value(); })) run.progress.skip(index);
  SharedMesh mesh(task, run.options, run.cache);
  const auto count = static_cast<double>(results.size());
  for (std::size_t v = 0; v < results.size(); ++v) {
    const auto before = static_cast<double>(v);
    const VariantWork work{index, task.variants[v].options, results.size() - v, before / count, (before + 1) / count};
    if (!results[v]) results[v] = decomposed(work, mesh, run);
    const bool clustered = run.options.segments && work.options.method == Method::kHacd;
    if (clustered && results[v]->status != Status::kFailed) addSegments(index, run, *results[v]);
  }
  run.time.finish(index);
  run.progress.finish(index);
  for (std::size_t v = 0; v < results.size(); ++v) {
    const auto result = std::make_shared<const MeshResult>(std::move(*results[v]));
    written.add(task.variants[v], result->hulls.size());
    finishVariant(task, task.variants[v], result, result->hulls.size(), run);
  }
}

/// The keys of all uses' results.
std::vector<std::string> keysOf(const Run& run) {
  std::vector<std::string> keys(run.uses.size());
  for (const MeshTask& task : run.tasks) {
    for (const MeshVariant& variant : task.variants) {
      const std::string key = meshKey(task, variant.options, run.options.seed);
      for (const std::size_t use : variant.uses) keys[use] = key;
    }
  }
  return keys;
}

/// 5. Validate by queries: the original against the hulls. From the cache if possible; its key names no hulls that time cut short.
void validateOrRemember(std::size_t model, const std::vector<std::string>& keys, Run& run) {
  ModelReport& report = reportOf(model, run.report);
  const std::string key = validationKey(run.uses, run.results, keys, model, run.options.seed);
  const bool complete = std::all_of(run.results.begin(), run.results.end(), [](const auto& mesh) { return mesh->untried.empty(); });
  const std::optional<Validation> known = complete ? run.cache.findValidation(key) : std::nullopt;
  RunControl validating;
  run.progress.follow(validating, model);
  if (known) run.progress.skip(model);
  report.validation = known ? *known : validateUses(run.uses, run.results, model, run.options.seed, validating);
  report.validation_cached = known.has_value();
  if (complete && !known) run.cache.storeValidation(key, report.validation);
}

bool isCut(const MeshVariant& variant, const Run& run) {
  return !run.results[variant.uses.front()]->untried.empty();
}

/// Whether `a` is the better result of a mesh; both have hulls.
bool isBetter(const MeshResult& a, const MeshResult& b) {
  if (a.status != b.status) return a.status == Status::kOk;
  if (a.status != Status::kOk) return a.model.protrusion < b.model.protrusion;
  return a.hulls.size() < b.hulls.size() || (a.hulls.size() == b.hulls.size() && a.untried.empty());
}

StageSeconds sum(const StageSeconds& a, const StageSeconds& b) {
  return {a.read + b.read, a.repair + b.repair, a.decompose + b.decompose, a.certify + b.certify, a.write + b.write};
}

/// Steps 1 to 4 once more, for a task that time cut short; its results are replaced by better ones.
void decomposeAgain(std::size_t index, HullCount& written, Run& run) {
  const MeshTask& task = run.tasks[index];
  std::vector<const MeshVariant*> cut;
  for (const MeshVariant& variant : task.variants)
    if (isCut(variant, run)) cut.push_back(&variant);
  SharedMesh mesh(task, run.options, run.cache);
  const auto count = static_cast<double>(cut.size());
  for (std::size_t v = 0; v < cut.size(); ++v) {
    const auto before = static_cast<double>(v);
    const VariantWork work{index, cut[v]->options, cut.size() - v, before / count, (before + 1) / count};
    auto result = std::make_shared<MeshResult>(decomposed(work, mesh, run));
    const MeshResult& first = *run.results[cut[v]->uses.front()];
    if (result->status == Status::kFailed || !isBetter(*result, first)) continue;
    written.replace(*cut[v], first.hulls.size(), result->hulls.size());
    result->seconds = sum(result->seconds, first.seconds);
    for (const std::size_t use : cut[v]->uses) run.results[use] = result;
  }
  run.time.finish(index);
  run.progress.finish(index);
}

double meshesEnd(const Options& options) {
  return options.validate ? kMeshesShare : 1;
}

/// What a mesh needs is known only when it is done, so meshes that time cut short get what the others left of it.
void useTimeLeft(HullCount& written, Run& run) {
  while (true) {
    std::vector<std::size_t> cut;
    for (std::size_t i = 0; i < run.tasks.size(); ++i)
      if (std::any_of(run.tasks[i].variants.begin(), run.tasks[i].variants.end(), [&](const auto& v) { return isCut(v, run); }))
        cut.push_back(i);
    cut = run.time.again(cut);
    if (cut.empty()) return;
    std::vector<double> costs(run.tasks.size(), 0);
    for (const std::size_t task : cut) costs[task] = 1;
    run.progress.begin("decompose", meshesEnd(run.options), costs);
    forEachInTurn(cut.size(), [&](std::size_t i) { decomposeAgain(cut[i], written, run); });
  }
}

/// Steps 1 to 4, once per mesh; then step 5, once per model.
void decomposeAll(Run& run) {
  HullCount written(run);
  forEachInTurn(run.tasks.size(), [&](std::size_t i) { decomposeTask(i, written, run); });
  if (run.options.time_limit > 0) useTimeLeft(written, run);
  if (!run.options.validate) return;
  const std::size_t models = 1 + run.report.models.size();
  run.progress.begin("validate", 1, std::vector<double>(models, 1));
  const std::vector<std::string> keys = keysOf(run);
  for (std::size_t model = 0; model < models; ++model) validateOrRemember(model, keys, run);
}

/// On links whose hulls touch though their meshes do not, of each model.
std::vector<std::string> notesOnContactsOf(const RobotDescription& robot, Run& run) {
  std::vector<std::string> notes;
  for (std::size_t model = 0; model <= run.report.models.size(); ++model) {
    RunControl control;
    run.progress.follow(control, model, 1, 1);
    const std::string& name = reportOf(model, run.report).model;
    for (const std::string& note : notesOnRestContacts(robot, run.uses, run.results, model, control))
      notes.push_back((name.empty() ? "" : "model '" + name + "': ") + note);
  }
  return notes;
}

/// On an output without a single hull.
std::vector<std::string> notesOnNoHulls(const Report& report) {
  const Totals sums = totals(report);
  if (sums.failed == 0 || sums.failed < sums.meshes || allFailed(report)) return {};
  return {"no mesh could be decomposed: " + counted(report.primitive_links, "link") + " with primitives " +
          (report.primitive_links == 1 ? "has its" : "have their") + " collision model, and the others keep their elements"};
}

/// Models have tolerances of their own, so that another one for all says nothing.
std::vector<std::string> notesOnTolerance(const Options& options) {
  if (options.models.empty() || toString(options.tolerance) == toString(Options().tolerance)) return {};
  return {"the tolerance '" + toString(options.tolerance) + "' is not used: each model has its own; leave it out"};
}

}  // namespace

RobotResult decomposeRobot(const RobotDescription& robot, const PackageFinder& find_package, const Options& options,
                           const std::string& output, const RunControl& control, const StepCallback& step) {
  check(options);
  checkForRobot(options);
  Stopwatch run;
  refuseLosingCache(options, output);
  RobotResult result = emptyResult(robot, options, control);
  const std::vector<LinkDecisions> decisions = modelDecisions(options, robot, control);
  const std::vector<MeshUse> uses = meshUses(robot, decisions);
  refuseLosingOriginals(robot, uses, output, find_package, control);
  std::vector<std::string> notes;
  const auto stages = [&](Run& run) {
    decomposeAll(run);
    if (options.validate) notes = notesOnContactsOf(robot, run);
  };
  runStages({uses, resolverFor(robot, find_package, control), meshesEnd(options), control, step}, result, stages);
  result.report.primitive_links = primitiveLinks(robot, decisions.front());
  for (const std::string& note : notesOnNoHulls(result.report)) notes.push_back(note);
  for (const std::string& note : notesOnTolerance(options)) notes.push_back(note);
  for (const std::string& note : notesOnConvex(robot, result.report.links)) notes.push_back(note);
  rewriteDescription(robot, decisions, find_package, output, notes, result, control);
  result.report.seconds = run.lap();
  return result;
}

RobotResult decomposeMesh(const std::string& path, const Options& options, const RunControl& control, const StepCallback& step) {
  check(options);
  checkForMesh(path, options);
  Stopwatch run;
  RobotResult result;
  result.single_mesh = true;
  result.robot_name = std::filesystem::path(path).stem().string();
  result.report.input_path = path;
  result.report.options = options;
  MeshUse use;
  use.link = result.robot_name;
  use.options = options;
  for (const RegionRule& rule : options.region_rules) use.options.regions.push_back(regionOf(rule));
  if (!use.options.regions.empty()) use.options.tree.reset();  // it knows nothing of them
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
  refuseLosingCache(options, output);
  refuseLosingInput(input.path, output);
  return decomposeMesh(input.path, options, control, step);
}

}  // namespace collision_hulls
