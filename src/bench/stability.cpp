#include "bench/stability.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/job_runner.h"
#include "bench/jobs.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/mesh/repair.h"
#include "pipeline/files.h"

namespace collision_hulls {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr double kChange = 0.1;          // share of the number of hulls that counts as a change, if it is more than one
constexpr double kPeersRounding = 1e-6;  // in diagonals: what of the surface a program that writes decimal numbers may leave out

struct Contender {
  std::string name, command;  // no command: a method
};

std::vector<Contender> contendersOf(const StabilityOptions& options) {
  std::vector<Contender> contenders;
  for (const Method method : options.methods) contenders.push_back({name(method), ""});
  for (const Peer& peer : options.peers) contenders.push_back({peer.name, peer.command});
  return contenders;
}

TriangleMesh meshOf(const json& job) {
  const Eigen::Vector3d scale(job["scale"][0], job["scale"][1], job["scale"][2]);
  return repair(scaled(readMesh(job["file"]).mesh, scale)).mesh;
}

json putInTrouble(const json& job) {
  const TriangleMesh mesh = meshOf(job);
  if (mesh.triangles.empty()) throw Error(ErrorCode::kEmptyMesh, "'" + job["file"].get<std::string>() + "': no triangle has an area");
  const Trouble trouble{*troubleNamed(job["kind"]), job["amount"]};
  writeText(job["troubled"].get<std::string>(), toObj(troubled(mesh, trouble, job["seed"])));
  return {{"diagonal", diagonal(mesh)}};
}

void enter(const JobOutcome& outcome, StabilityRow& row) {
  row.outcome = outcome.status;
  row.message = outcome.message;
}

/// The runs on one mesh after the other.
class Stability {
 public:
  explicit Stability(const StabilityOptions& options) : options_(options), runner_(options.program, options.folder) {}

  void run(const BenchmarkMesh& mesh, const std::function<void(const StabilityRow&)>& take) {
    hulls_without_trouble_.clear();
    for (const Trouble& trouble : options_.troubles) {
      for (int draw = 0; draw < (isRandom(trouble.kind) ? options_.draws : 1); ++draw) {
        StabilityRow start;
        start.mesh = mesh.name;
        start.trouble = trouble;
        start.seed = options_.seed + static_cast<std::uint64_t>(draw);
        putInTrouble(mesh, start);
        for (const Contender& contender : contendersOf(options_)) take(rowOf(contender, start));
      }
    }
  }

 private:
  void putInTrouble(const BenchmarkMesh& mesh, StabilityRow& row) {
    JobOutcome outcome;
    const json done = runner_.result({{"job", "trouble"},
                                      {"file", mesh.file},
                                      {"scale", {mesh.scale.x(), mesh.scale.y(), mesh.scale.z()}},
                                      {"kind", name(row.trouble.kind)},
                                      {"amount", row.trouble.amount},
                                      {"seed", row.seed},
                                      {"troubled", runner_.file("mesh.obj")}},
                                     outcome);
    enter(outcome, row);
    if (!outcome.ok()) return;
    diagonal_ = done["diagonal"].get<double>() * lengthFactor(row.trouble);
    const Length& tolerance = options_.tolerance;
    row.tolerance = tolerance.value * (tolerance.relative ? diagonal_ : lengthFactor(row.trouble));
  }

  StabilityRow rowOf(const Contender& contender, StabilityRow row) {
    row.method = contender.name;
    if (row.outcome != "ok") return row;
    fs::remove(runner_.file("hulls.obj"));
    const ChildResult used = runOnce(contender, row);
    enter(runner_.judge(used, options_.time_limit), row);
    if (row.outcome == "ok" && !fs::exists(runner_.file("hulls.obj")))
      enter({"error", runner_.lastWords("no hulls were written", used.output)}, row);
    if (row.outcome == "ok") score(contender, row);
    return row;
  }

  ChildResult runOnce(const Contender& contender, const StabilityRow& row) const {
    const std::string mesh = runner_.file("mesh.obj"), hulls = runner_.file("hulls.obj");
    if (!contender.command.empty()) {
      const std::string command = filledIn(contender.command, {{"in", mesh}, {"out", hulls}, {"tolerance", csvNumber(row.tolerance)}});
      return runChild({"/bin/sh", "-c", command}, options_.time_limit);
    }
    return runner_.run({{"job", "decompose"},
                        {"file", mesh},
                        {"scale", {1, 1, 1}},
                        {"method", contender.name},
                        {"effort", name(Effort::kQuick)},
                        {"tolerance", *row.tolerance},
                        {"seed", options_.seed},
                        {"hulls", hulls}},
                       options_.time_limit);
  }

  void score(const Contender& contender, StabilityRow& row) {
    JobOutcome outcome;
    const json scored = runner_.result({{"job", "score"},
                                        {"file", runner_.file("mesh.obj")},
                                        {"scale", {1, 1, 1}},
                                        {"tolerance", *row.tolerance},
                                        {"hulls", {runner_.file("hulls.obj")}}},
                                       outcome);
    if (!outcome.ok()) return enter({"error", "the hulls could not be scored (" + outcome.status + "): " + outcome.message}, row);
    row.hulls = scored["hulls"].get<std::size_t>();
    row.protrusion = scored["protrusion"].get<double>();
    row.uncovered = scored["uncovered"].get<double>();
    if (row.trouble.kind == TroubleKind::kNone) hulls_without_trouble_[contender.name] = *row.hulls;
    const auto before = hulls_without_trouble_.find(contender.name);
    if (before != hulls_without_trouble_.end()) row.hulls_ratio = static_cast<double>(*row.hulls) / static_cast<double>(before->second);
    row.outcome = outcomeOf(row, contender.command.empty() ? 0 : kPeersRounding * diagonal_);
  }

  const StabilityOptions& options_;
  const JobRunner runner_;
  double diagonal_ = 0;
  std::map<std::string, std::size_t> hulls_without_trouble_;
};

}  // namespace

std::string outcomeOf(const StabilityRow& row, double allowed_uncovered) {
  if (*row.uncovered > allowed_uncovered) return "uncovered";
  if (*row.protrusion > *row.tolerance) return "over_bound";
  if (!keepsShape(row.trouble.kind) || !row.hulls_ratio) return "ok";
  const double change = std::abs(*row.hulls_ratio - 1), hulls_before = static_cast<double>(*row.hulls) / *row.hulls_ratio;
  return change > kChange && std::lround(change * hulls_before) > 1 ? "changed" : "ok";
}

void doStabilityJob(const std::string& job_file, const std::string& result_file) {
  const json job = json::parse(readText(job_file));
  if (job["job"] != "trouble") return doJob(job_file, result_file);
  writeText(result_file, putInTrouble(job).dump());
}

void runStability(const std::vector<BenchmarkMesh>& meshes, const StabilityOptions& options,
                  const std::function<void(const StabilityRow&)>& row) {
  Stability stability(options);
  for (const BenchmarkMesh& mesh : meshes) stability.run(mesh, row);
}

std::string stabilityHeader() {
  return "mesh,method,trouble,amount,outcome,hulls,hulls_ratio,protrusion,message,uncovered,tolerance,seed\n";
}

std::string toCsv(const StabilityRow& row) {
  return csvLine({row.mesh, row.method, name(row.trouble.kind), csvNumber(row.trouble.amount), row.outcome,
                  row.hulls ? std::to_string(*row.hulls) : "", csvNumber(row.hulls_ratio), csvNumber(row.protrusion), row.message,
                  csvNumber(row.uncovered), csvNumber(row.tolerance), std::to_string(row.seed)});
}

}  // namespace collision_hulls
