// What decomposing a robot and fitting it to a scene have in common, from the list of its meshes to the rows of the report.
#include "pipeline/run.h"

#include <filesystem>
#include <utility>

#include "base/failure_cause.h"
#include "base/parallel.h"
#include "collision_hulls/pipeline/fit_scene.h"
#include "pipeline/collision_model.h"
#include "pipeline/rows.h"
#include "storage/sha256.h"

namespace collision_hulls {

RobotResult emptyResult(const RobotDescription& robot, const Options& options, const RunControl& control) {
  RobotResult result;
  result.robot_name = robot.name;
  result.report.input_path = robot.path;
  result.report.xacro_arguments = robot.xacro_arguments;
  result.report.input_sha256 = sha256(robot.text, control);
  result.report.options = options;
  result.report.urdf = urdfFile(robot.name);
  if (options.models.empty()) return result;
  result.report.model = options.models.front().name;
  for (std::size_t i = 1; i < options.models.size(); ++i) {
    ModelReport other;
    other.model = options.models[i].name;
    other.urdf = urdfFile(robot.name, other.model);
    result.report.models.push_back(other);
  }
  result.models.resize(result.report.models.size());
  return result;
}

ModelReport& reportOf(std::size_t model, Report& report) {
  return model == 0 ? report : report.models[model - 1];
}

ModelResult& modelOf(std::size_t model, RobotResult& result) {
  return model == 0 ? result : result.models[model - 1];
}

namespace {

/// The failure of a mesh for a use that knows it by another name: the reason tells of the first one's file.
std::shared_ptr<const MeshResult> failedLike(const std::string& first, const MeshResult& mesh, const std::string& uri) {
  const auto own = std::make_shared<MeshResult>(mesh);
  own->reason = reasonOfCopy(uri, first, mesh.reason);
  own->seconds = {};  // they count once
  return own;
}

}  // namespace

void runStages(const RunInput& input, RobotResult& result, const std::function<void(Run&)>& stages) {
  const Options& options = result.report.options;
  Cache cache(options.cache ? cacheFolder() : std::filesystem::path());
  MeshResults results;
  withJobs(options.jobs, [&] {
    Progress progress(input.control, input.step, decomposedUses(input.uses));
    TimeBudget time(options.time_limit);
    MeshTasks found = meshTasks(input.uses, input.resolve, meshLimits(options), input.control);
    progress.begin("decompose", input.meshes_end, expectedCosts(found.tasks));
    for (std::size_t i = 0; i < input.uses.size(); ++i)
      if (found.done[i] && found.done[i]->status == Status::kFailed) progress.finishElement(input.uses[i].link, 0);
    time.share(expectedCosts(found.tasks), mostThreads());
    Run run{options, input.uses, found.tasks, cache, progress, time, std::move(found.done), result.report};
    stages(run);
    progress.end();
    results = std::move(run.results);
  });
  cache.trim();
  result.report.notes = cache.notes();
  if (options.cache && cacheFolder().empty())
    result.report.notes.push_back("nothing is remembered for later runs: none of COLLISION_HULLS_CACHE, ROS_HOME and HOME is set");
  putTogether(input.uses, results, result, input.control);
}

void finishVariant(const MeshTask& task, const MeshVariant& variant, const std::shared_ptr<const MeshResult>& mesh, std::size_t bodies,
                   Run& run) {
  const std::size_t primitives = mesh->primitives.size();
  for (const std::size_t use : variant.uses) {
    const std::string& uri = run.uses[use].source.uri;
    run.results[use] = mesh->status == Status::kFailed && uri != task.uri ? failedLike(task.uri, *mesh, uri) : mesh;
    run.progress.finishElement(run.uses[use].link, bodies - primitives, primitives);
  }
}

}  // namespace collision_hulls
