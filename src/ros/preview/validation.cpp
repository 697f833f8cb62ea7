// Works in the frame that every run has (pipeline/run.h): equal meshes are read once, whichever links use them. The hulls come from
// outside, as no cache knows what was fitted to a scene or cut for a slider.
#include "validation.h"

#include <memory>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "pipeline/run.h"
#include "pipeline/stages.h"
#include "report/check_text.h"

namespace collision_hulls {
namespace {

constexpr double kReadShare = 0.3;  // of the time, approximately

/// What is compared: a mesh in each of its places, with the hulls that it has there.
struct Places {
  std::vector<MeshUse> uses;
  std::vector<MeshResult> hulls;  // one for each use, without the original

  Places(const RobotDescription& robot, const std::map<std::string, LinkResult>& links) {
    for (const LinkDescription& link : robot.links) {
      const auto result = links.find(link.name);
      if (result == links.end()) continue;
      for (std::size_t i = 0; i < result->second.elements.size(); ++i) add(result->second.elements[i], result->second.rows[i]);
    }
  }

 private:
  void add(const ElementResult& element, const ElementReport& row) {
    if (element.hulls.empty()) return;
    MeshUse use;
    use.link = element.link;
    use.options.tolerance = shareOf(1);  // of no matter: nothing is decomposed
    use.element = row.element;
    use.source = element.source;
    use.pose = element.pose;
    uses.push_back(use);
    MeshResult result;
    result.hulls = element.hulls;
    result.primitives = element.primitives;
    result.model.protrusion = row.protrusion;
    hulls.push_back(std::move(result));
  }
};

void readTask(std::size_t index, const Places& places, Run& run) {
  const MeshTask& task = run.tasks[index];
  SharedMesh shared(task, run.options, run.cache);
  for (const MeshVariant& variant : task.variants) {
    RunControl reading;
    run.progress.follow(reading, index, 0, 1);
    MeshResult read;
    shared.read(variant.options, reading, read);
    for (const std::size_t use : variant.uses) {
      auto result = std::make_shared<MeshResult>(places.hulls[use]);
      result->mesh = read.mesh;
      result->original = read.original;
      result->solid = read.solid;
      run.results[use] = result;
    }
  }
  run.progress.finish(index);
}

void expectRead(const Run& run) {
  for (const auto& result : run.results)
    if (result && result->status == Status::kFailed) throw Error(ErrorCode::kFileNotFound, result->reason);
}

[[noreturn]] void refuseWithoutHulls(const std::map<std::string, LinkResult>& links) {
  if (links.empty())
    throw Error(ErrorCode::kBadOption, "no hulls are known that could be compared with their meshes: call ~build or ~decompose first");
  std::vector<std::string> names;
  for (const auto& [name, result] : links) names.push_back("'" + name + "'");
  const std::string who =
      names.size() == 1 ? "link " + names.front() + " has no hulls" : "no hulls are known of links " + listedFirst(names, 3);
  throw Error(ErrorCode::kBadOption,
              who + " that could be compared with a mesh: call ~build or ~decompose first, or choose links that have some");
}

}  // namespace

Validation validateLinks(const RobotDescription& robot, const PackageFinder& find_package, const Options& options,
                         const std::map<std::string, LinkResult>& links, const RunControl& control, const StepCallback& step) {
  const Places places(robot, links);
  if (places.uses.empty()) refuseWithoutHulls(links);
  Validation validation;
  RobotResult rows = emptyResult(robot, options, control);  // of no use here
  runStages({places.uses, resolverFor(robot, find_package, control), kReadShare, control, step}, rows, [&](Run& run) {
    expectRead(run);
    forEachInTurn(run.tasks.size(), [&](std::size_t task) { readTask(task, places, run); });
    run.progress.begin("validate", 1);
    RunControl validating;
    run.progress.follow(validating, 0);
    validation = validateUses(run.uses, run.results, 0, options.seed, validating);
  });
  return validation;
}

std::string summary(const Validation& validation) {
  std::string text = checkText(validation, "hulls");
  if (!validation.remarks.empty()) text += ". " + validation.remarks.front();
  return text;
}

}  // namespace collision_hulls
