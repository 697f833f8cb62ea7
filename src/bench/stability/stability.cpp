// Works in units, each one mesh with one trouble, which run in parallel and are reported in order: the undisturbed mesh comes first, and
// the number of its hulls is what later rows are compared with.
#include "bench/stability/stability.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "base/parallel.h"
#include "bench/jobs.h"
#include "bench/json_file.h"
#include "bench/original.h"
#include "collision_hulls/error.h"
#include "storage/csv.h"
#include "storage/files.h"

namespace collision_hulls {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr double kChange = 0.1;          // share of the number of hulls; a larger difference counts as a change if it is also more than one
constexpr double kPeersRounding = 1e-6;  // in diagonals: how far uncovered a peer may leave the surface, since it writes decimal numbers

json putInTrouble(const json& job) {
  const TriangleMesh mesh = repair(meshOf(job)).mesh;
  if (mesh.triangles.empty())
    throw Error(ErrorCode::kEmptyMesh, "'" + job["file"].get<std::string>() + "': no triangle has an area; give another mesh");
  const Trouble trouble{*troubleNamed(job["kind"]), job["amount"]};
  writeText(job["troubled"].get<std::string>(), toObj(troubled(mesh, trouble, job["seed"])));
  return {{"diagonal", diagonal(mesh)}};
}

void enter(const JobOutcome& outcome, StabilityRow& row) {
  row.outcome = outcome.status;
  row.message = outcome.message;
}

/// A mesh with one trouble; its runs are independent of all others.
struct Unit {
  const BenchmarkMesh& mesh;
  Trouble trouble;
  std::uint64_t seed;
};

std::vector<Unit> unitsOf(const std::vector<BenchmarkMesh>& meshes, const StabilityOptions& options) {
  std::vector<Unit> units;
  for (const BenchmarkMesh& mesh : meshes)
    for (const Trouble& trouble : options.troubles)
      for (int draw = 0; draw < (isRandom(trouble.kind) ? options.draws : 1); ++draw)
        units.push_back({mesh, trouble, options.seed + static_cast<std::uint64_t>(draw)});
  return units;
}

/// The runs on one troubled mesh.
class Runs {
 public:
  Runs(const StabilityOptions& options, const std::string& folder) : options_(options), runner_(options.program, folder) {}

  std::vector<StabilityRow> rowsOf(const Unit& unit) {
    StabilityRow start;
    start.mesh = unit.mesh.name;
    start.trouble = unit.trouble;
    start.seed = unit.seed;
    putInTrouble(unit.mesh, start);
    std::vector<StabilityRow> rows;
    for (const Contender& contender : contenders(options_.methods, {Effort::kQuick}, options_.peers))
      rows.push_back(rowOf(contender, start, hullsFile(rows.size())));
    score(rows);
    return rows;
  }

 private:
  BenchmarkMesh troubledMesh() const { return {"", runner_.file("mesh.obj")}; }

  void putInTrouble(const BenchmarkMesh& mesh, StabilityRow& row) {
    JobOutcome outcome;
    const json job{{"job", "trouble"},
                   {"kind", name(row.trouble.kind)},
                   {"amount", row.trouble.amount},
                   {"seed", row.seed},
                   {"troubled", troubledMesh().file}};
    const json done = runner_.result(toJob(mesh, job), outcome);
    enter(outcome, row);
    if (!outcome.ok()) return;
    diagonal_ = done["diagonal"].get<double>() * lengthFactor(row.trouble);
    row.tolerance = Length{options_.tolerance.limit * lengthFactor(row.trouble), options_.tolerance.share}.metres(diagonal_);
  }

  StabilityRow rowOf(const Contender& contender, StabilityRow row, const std::string& hulls) const {
    row.method = contender.name;
    if (row.outcome != "ok") return row;
    const HullsMade made =
        makeHulls(runner_, contender, {toJob(troubledMesh()), *row.tolerance, options_.seed, hulls, options_.time_limit});
    row.cpu_seconds = made.used.cpu_seconds;
    enter(made.outcome, row);
    if (!contender.command.empty()) row.allowed_uncovered = kPeersRounding * diagonal_;
    return row;
  }

  std::string hullsFile(std::size_t row) const { return runner_.file("hulls_" + std::to_string(row) + ".obj"); }

  /// Scores all rows in one process, which reads the mesh once; if that fails, each row in its own.
  void score(std::vector<StabilityRow>& rows) const {
    std::vector<std::size_t> done;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (rows[i].outcome == "ok") done.push_back(i);
    if (done.empty() || decide(rows, done) || done.size() == 1) return;
    for (const std::size_t i : done) decide(rows, {i});
  }

  /// Returns false if the process failed; if it was for a single row, that row records why.
  bool decide(std::vector<StabilityRow>& rows, const std::vector<std::size_t>& which) const {
    json files = json::array();
    for (const std::size_t i : which) files.push_back(hullsFile(i));
    JobOutcome outcome;
    const json job{{"job", "decide"}, {"tolerance", *rows[which[0]].tolerance}, {"hulls", files}};
    const json decided = runner_.result(toJob(troubledMesh(), job), outcome);
    if (!outcome.ok() && which.size() == 1) enterUnscored(outcome.status + ": " + outcome.message, rows[which[0]]);
    for (std::size_t k = 0; outcome.ok() && k < which.size(); ++k) enterScore(decided["results"][k], rows[which[k]]);
    return outcome.ok();
  }

  static void enterUnscored(const std::string& why, StabilityRow& row) { enter({"error", "the hulls could not be scored: " + why}, row); }

  static void enterScore(const json& result, StabilityRow& row) {
    row.scoring_seconds = result["seconds"].get<double>();
    if (result.contains("error")) return enterUnscored(result["error"], row);
    row.hulls = result["hulls"].get<std::size_t>();
    row.protrusion = result["protrusion"].get<double>();
    row.uncovered = result["uncovered"].get<double>();
  }

  const StabilityOptions& options_;
  const JobRunner runner_;
  double diagonal_ = 0;
};

/// Passes on the rows of units in the units' order, whatever order they end in, each compared with the first unit of its mesh.
class InOrder {
 public:
  explicit InOrder(const std::function<void(const StabilityRow&)>& take) : take_(take) {}

  void add(std::size_t unit, std::vector<StabilityRow> rows) {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_[unit] = std::move(rows);
    for (; !waiting_.empty() && waiting_.begin()->first == next_; ++next_) {
      for (StabilityRow& row : waiting_.begin()->second) complete(row);
      waiting_.erase(waiting_.begin());
    }
  }

 private:
  void complete(StabilityRow& row) {
    if (row.hulls) {
      const auto key = std::make_pair(row.mesh, row.method);
      if (row.trouble.kind == TroubleKind::kNone) hulls_without_trouble_[key] = *row.hulls;
      const auto before = hulls_without_trouble_.find(key);
      if (before != hulls_without_trouble_.end()) row.hulls_ratio = static_cast<double>(*row.hulls) / static_cast<double>(before->second);
      row.outcome = outcomeOf(row);
    }
    take_(row);
  }

  const std::function<void(const StabilityRow&)>& take_;
  std::mutex mutex_;
  std::map<std::size_t, std::vector<StabilityRow>> waiting_;
  std::size_t next_ = 0;
  std::map<std::pair<std::string, std::string>, std::size_t> hulls_without_trouble_;  // by mesh and method
};

}  // namespace

std::string outcomeOf(const StabilityRow& row) {
  if (*row.uncovered > row.allowed_uncovered) return "uncovered";
  if (*row.protrusion > *row.tolerance) return "over_bound";
  if (!keepsShape(row.trouble.kind) || !row.hulls_ratio) return "ok";
  const double change = std::abs(*row.hulls_ratio - 1), hulls_before = static_cast<double>(*row.hulls) / *row.hulls_ratio;
  return change > kChange && std::lround(change * hulls_before) > 1 ? "changed" : "ok";
}

void doStabilityJob(const std::string& job_file, const std::string& result_file) {
  withJobs(1, [&] {  // one thread, as other processes run in parallel
    const json job = readJson(job_file);
    if (job["job"] != "trouble") return doJob(job_file, result_file);
    writeText(result_file, putInTrouble(job).dump());
  });
}

void runStability(const std::vector<BenchmarkMesh>& meshes, const StabilityOptions& options,
                  const std::function<void(const StabilityRow&)>& row) {
  const fs::path temporary = fs::path(options.folder) / ".stability";
  fs::remove_all(temporary);
  const std::vector<Unit> units = unitsOf(meshes, options);
  InOrder in_order(row);
  withJobs(options.jobs, [&] {
    forEachInTurn(units.size(), [&](std::size_t i) {
      in_order.add(i, Runs(options, temporary / std::to_string(i)).rowsOf(units[i]));
      fs::remove_all(temporary / std::to_string(i));
    });
  });
  fs::remove_all(temporary);
}

std::string stabilityHeader() {
  return "mesh,method,trouble,amount,outcome,hulls,hulls_ratio,protrusion,message,uncovered,tolerance,seed,"
         "cpu_seconds,scoring_seconds\n";
}

std::string toCsv(const StabilityRow& row) {
  return csvLine({row.mesh, row.method, name(row.trouble.kind), csvNumber(row.trouble.amount), row.outcome, csvCount(row.hulls),
                  csvNumber(row.hulls_ratio), csvNumber(row.protrusion), row.message, csvNumber(row.uncovered), csvNumber(row.tolerance),
                  std::to_string(row.seed), csvNumber(row.cpu_seconds), csvNumber(row.scoring_seconds)});
}

}  // namespace collision_hulls
