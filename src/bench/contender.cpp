// A method runs as a job of the measuring program itself, a peer as a shell command; both are timed as whole processes and must leave a
// file of hulls.
#include "bench/contender.h"

#include <filesystem>

#include "storage/csv.h"

namespace collision_hulls {

std::vector<Contender> contenders(const std::vector<Method>& methods, const std::vector<Effort>& efforts, const std::vector<Peer>& peers) {
  std::vector<Contender> all;
  for (const Method method : methods) {
    if (method != Method::kCertified) all.push_back({name(method), "", ""});
    for (const Effort effort : efforts) {
      if (method == Method::kCertified) all.push_back({name(method), name(effort), ""});
    }
  }
  for (const Peer& peer : peers) all.push_back({peer.name, "", peer.command});
  return all;
}

HullsMade makeHulls(const JobRunner& runner, const Contender& contender, const HullsTask& task) {
  std::filesystem::remove(task.hulls);
  HullsMade made;
  if (contender.command.empty()) {
    nlohmann::json job = {
        {"job", "decompose"}, {"method", contender.name}, {"effort", contender.effort},       {"tolerance", task.tolerance},
        {"seed", task.seed},  {"hulls", task.hulls},      {"max_vertices", task.max_vertices}};
    job.update(task.mesh);
    made.used = runner.run(job, task.limit);
  } else {
    const std::string command =
        filledIn(contender.command, {{"in", runner.file("mesh.obj")}, {"out", task.hulls}, {"tolerance", csvNumber(task.tolerance)}});
    made.used = runChild({"/bin/sh", "-c", command}, task.limit);
  }
  made.outcome = runner.judge(made.used, task.limit);
  if (made.outcome.ok() && !std::filesystem::exists(task.hulls)) {
    made.outcome = {"error", runner.lastWords("no hulls were written", made.used.output)};
  }
  return made;
}

}  // namespace collision_hulls
