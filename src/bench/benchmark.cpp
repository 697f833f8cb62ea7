// Runs each contender as a process of its own and lets another process score its hulls, so that a crash or hang of either is a row of the
// table. Medians are over the repeated runs; a result that differs between runs of the same seed is reported in the message.
#include "bench/benchmark.h"

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/median.h"
#include "bench/original.h"

namespace collision_hulls {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Benchmarks one mesh after the other.
class Bench {
 public:
  explicit Bench(const BenchmarkOptions& options) : options_(options), runner_(options.program, options.folder) {
    if (!options.keep_hulls.empty()) fs::create_directories(options.keep_hulls);
  }

  void run(const BenchmarkMesh& mesh, const std::function<void(const BenchmarkRow&)>& take) {
    mesh_ = toJob(mesh);
    least_hulls_.clear();
    BenchmarkRow row;
    row.mesh = mesh.name;
    row.seed = options_.seed;
    const json prepared = result({{"job", "prepare"}, {"cleaned", runner_.file("mesh.obj")}}, row);
    if (prepared.is_object()) {
      row.triangles = prepared["triangles"].get<std::size_t>();
      row.diagonal = prepared["diagonal"].get<double>();
    }
    for (const Contender& contender : contenders(options_.methods, options_.efforts, options_.peers)) {
      for (const Length& tolerance : options_.tolerances) take(rowOf(contender, tolerance, row));
    }
  }

 private:
  BenchmarkRow rowOf(const Contender& contender, const Length& tolerance, BenchmarkRow row) {
    row.method = contender.name;
    row.effort = contender.effort;
    row.requested = toString(tolerance);
    if (row.diagonal || tolerance.share == Length::kUnset) row.tolerance = tolerance.metres(row.diagonal.value_or(0));
    if (row.status != "ok") return row;
    std::vector<double> cpu, wall, peak;
    json hulls = json::array();
    for (int i = 0; i < options_.repeat && row.status == "ok"; ++i) {
      hulls.push_back(runner_.file("hulls_" + std::to_string(i) + ".obj"));
      const HullsMade made =
          makeHulls(runner_, contender, {mesh_, *row.tolerance, options_.seed, hulls.back(), options_.time_limit, options_.max_vertices});
      enter(made.outcome, row);
      cpu.push_back(made.used.cpu_seconds);
      wall.push_back(made.used.wall_seconds);
      peak.push_back(made.used.peak_mb);
    }
    row.cpu_seconds = median(cpu);
    row.wall_seconds = median(wall);
    row.peak_mb = median(peak);
    if (row.status == "ok") score(hulls, row);
    if (row.status == "ok" && !options_.keep_hulls.empty()) {
      row.hulls_file = (fs::path(options_.keep_hulls) / (std::to_string(kept_++) + ".obj")).string();
      fs::rename(hulls[0].get<std::string>(), row.hulls_file);
    }
    return row;
  }

  void score(const json& hulls, BenchmarkRow& row) {
    const auto known = least_hulls_.find(row.requested);
    const json scored =
        result({{"job", "score"}, {"tolerance", *row.tolerance}, {"hulls", hulls}, {"least", known == least_hulls_.end()}}, row);
    if (!scored.is_object()) {
      row.message = "the hulls could not be scored: " + row.message;
      return;
    }
    row.hulls = scored["hulls"].get<std::size_t>();
    row.least_hulls = known == least_hulls_.end() ? scored["least_hulls"].get<std::size_t>() : known->second;
    least_hulls_[row.requested] = *row.least_hulls;
    row.hull_vertices = scored["hull_vertices"].get<std::size_t>();
    row.uncovered = scored["uncovered"].get<double>();
    row.protrusion = scored["protrusion"].get<double>();
    row.protrusion_found = scored["protrusion_found"].get<double>();
    if (!scored["volume_ratio"].is_null()) row.volume_ratio = scored["volume_ratio"].get<double>();
    row.hash = scored["hashes"][0].get<std::string>();
    const std::set<json> different(scored["hashes"].begin(), scored["hashes"].end());
    if (different.size() > 1)
      row.message = std::to_string(different.size()) + " different results in " + std::to_string(hulls.size()) + " runs";
  }

  /// The result of a job that is not timed; null if it failed, and then the row says why.
  json result(json job, BenchmarkRow& row) const {
    job.update(mesh_);
    JobOutcome outcome;
    json found = runner_.result(job, outcome);
    enter(outcome, row);
    return found;
  }

  static void enter(const JobOutcome& outcome, BenchmarkRow& row) {
    if (outcome.ok()) return;
    row.status = outcome.status;
    row.message = outcome.message;
  }

  const BenchmarkOptions& options_;
  const JobRunner runner_;
  json mesh_;
  std::map<std::string, std::size_t> least_hulls_;  // of this mesh, by tolerance: the same for all contenders
  int kept_ = 0;
};

}  // namespace

void runBenchmark(const std::vector<BenchmarkMesh>& meshes, const BenchmarkOptions& options,
                  const std::function<void(const BenchmarkRow&)>& row) {
  Bench bench(options);
  for (const BenchmarkMesh& mesh : meshes) bench.run(mesh, row);
}

}  // namespace collision_hulls
