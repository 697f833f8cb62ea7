// The frame that every run has: cache, tasks, progress, and the report at the end.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "base/time_budget.h"
#include "collision_hulls/pipeline/result.h"
#include "pipeline/cache.h"
#include "pipeline/mesh_uses.h"
#include "pipeline/progress.h"

namespace collision_hulls {

/// What the stages of a run work with, and what they leave behind. Stages that work on several tasks at once write to different results.
struct Run {
  const Options& options;
  const std::vector<MeshUse>& uses;
  const std::vector<MeshTask>& tasks;
  Cache& cache;
  Progress& progress;
  TimeBudget& time;
  MeshResults results;  ///< by use: at the end all of them
  Report& report;       ///< for what is no row
};

/// What is known of a run on a robot before it begins; the reports of all models have their names and places.
RobotResult emptyResult(const RobotDescription& robot, const Options& options, const RunControl& control);

/// The meshes of a run, and who follows it.
struct RunInput {
  const std::vector<MeshUse>& uses;
  UriResolver resolve;
  double meshes_end = 1;  ///< share of the run's time, approximately, at which the first stage, "decompose", ends
  const RunControl& control;
  const StepCallback& step;
};

/// Lets `stages` work on the meshes that have a file, on as many threads as the options of the report allow, then fills the report's rows,
/// the elements, and the notes of the cache.
void runStages(const RunInput& input, RobotResult& result, const std::function<void(Run&)>& stages);

/// A variant of a task of the first stage is done: hands its result to all of its uses. Where it failed, the reason names each use's own
/// mesh. `bodies`: how many the progress shows for each, the mesh's primitives among them.
void finishVariant(const MeshTask& task, const MeshVariant& variant, const std::shared_ptr<const MeshResult>& mesh, std::size_t bodies,
                   Run& run);

/// What belongs to a model, by its index among all of them.
ModelReport& reportOf(std::size_t model, Report& report);
ModelResult& modelOf(std::size_t model, RobotResult& result);

}  // namespace collision_hulls
