#include "bench/benchmark.h"

#include <signal.h>

#include <cstring>
#include <filesystem>
#include <set>

#include "bench/child_process.h"
#include "bench/jobs.h"
#include "pipeline/files.h"

namespace collision_hulls {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr double kOwnLimit = 300;  // [s] for preparing and scoring, which are not what is measured

/// A method with its effort, or a peer.
struct Contender {
  std::string name, effort, command;  // no command: a method
};

std::vector<Contender> contendersOf(const BenchmarkOptions& options) {
  std::vector<Contender> contenders;
  for (const Method method : options.methods) {
    if (method != Method::kCertified) contenders.push_back({name(method), "", ""});
    for (const Effort effort : options.efforts) {
      if (method == Method::kCertified) contenders.push_back({name(method), name(effort), ""});
    }
  }
  for (const Peer& peer : options.peers) contenders.push_back({peer.name, "", peer.command});
  return contenders;
}

/// What happened, and what the process wrote last, on one line. The folder of its files says nothing and may be another next time.
std::string withLastWords(const std::string& what, std::string output, const std::string& folder) {
  constexpr std::size_t kMost = 300;
  for (std::size_t at; (at = output.find(folder + "/")) != std::string::npos;) output.erase(at, folder.size() + 1);
  std::string text = output.substr(output.size() - std::min(output.size(), kMost));
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return text.empty() ? what : what + ": " + text;
}

/// The runs of a benchmark in a folder of temporary files.
class Bench {
 public:
  explicit Bench(const BenchmarkOptions& options) : options_(options), folder_(fs::path(options.folder) / ".benchmark") {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Bench() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  void run(const BenchmarkMesh& mesh, const std::function<void(const BenchmarkRow&)>& take) {
    mesh_ = {{"file", mesh.file}, {"scale", {mesh.scale.x(), mesh.scale.y(), mesh.scale.z()}}};
    BenchmarkRow row;
    row.mesh = mesh.name;
    row.seed = options_.seed;
    const json prepared = doJob({{"job", "prepare"}, {"cleaned", file("mesh.obj")}}, kOwnLimit, row);
    if (prepared.is_object()) {
      row.triangles = prepared["triangles"].get<std::size_t>();
      row.diagonal = prepared["diagonal"].get<double>();
    }
    for (const Contender& contender : contendersOf(options_)) {
      for (const Length& tolerance : options_.tolerances) take(rowOf(contender, tolerance, row));
    }
  }

 private:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  BenchmarkRow rowOf(const Contender& contender, const Length& tolerance, BenchmarkRow row) {
    row.method = contender.name;
    row.effort = contender.effort;
    row.requested = toString(tolerance);
    if (row.diagonal || !tolerance.relative) row.tolerance = tolerance.metres(row.diagonal.value_or(0));
    if (row.status != "ok") return row;
    std::vector<double> cpu, wall, peak;
    json hulls = json::array();
    for (int i = 0; i < options_.repeat && row.status == "ok"; ++i) {
      hulls.push_back(file("hulls_" + std::to_string(i) + ".obj"));
      fs::remove(hulls.back().get<std::string>());
      const ChildResult used = runOnce(contender, hulls.back(), row);
      cpu.push_back(used.cpu_seconds);
      wall.push_back(used.wall_seconds);
      peak.push_back(used.peak_mb);
    }
    row.cpu_seconds = median(cpu);
    row.wall_seconds = median(wall);
    row.peak_mb = median(peak);
    if (row.status == "ok") score(hulls, row);
    return row;
  }

  ChildResult runOnce(const Contender& contender, const std::string& hulls, BenchmarkRow& row) {
    ChildResult used;
    if (contender.command.empty()) {
      const json job = {{"job", "decompose"},          {"method", contender.name}, {"effort", contender.effort},
                        {"tolerance", *row.tolerance}, {"seed", options_.seed},    {"hulls", hulls}};
      used = runJob(job, options_.time_limit);
    } else {
      const std::string command =
          filledIn(contender.command, {{"in", file("mesh.obj")}, {"out", hulls}, {"tolerance", csvNumber(row.tolerance)}});
      used = runChild({"/bin/sh", "-c", command}, options_.time_limit);
    }
    judge(used, options_.time_limit, row);
    if (row.status == "ok" && !fs::exists(hulls)) {
      row.status = "error";
      row.message = withLastWords("no hulls were written", used.output, folder_.string());
    }
    return used;
  }

  void score(const json& hulls, BenchmarkRow& row) {
    const json scored = doJob({{"job", "score"}, {"tolerance", *row.tolerance}, {"hulls", hulls}}, kOwnLimit, row);
    if (!scored.is_object()) {
      row.message = "the hulls could not be scored: " + row.message;
      return;
    }
    row.hulls = scored["hulls"].get<std::size_t>();
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

  /// Sets status and message of a row after a process that did not end well. A shell adds 128 to the signal that ended its command.
  void judge(const ChildResult& used, double limit, BenchmarkRow& row) const {
    if (used.end == ChildResult::End::kExit && used.code == 0) return;
    if (used.end == ChildResult::End::kTimeout) {
      row.status = "timeout";
      row.message = "ended after " + csvNumber(limit) + " s";
    } else if (used.end == ChildResult::End::kSignal || used.code > 128) {
      row.status = "crash";
      row.message =
          withLastWords(strsignal(used.end == ChildResult::End::kSignal ? used.code : used.code - 128), used.output, folder_.string());
    } else {
      row.status = "error";
      row.message = withLastWords("exit status " + std::to_string(used.code), used.output, folder_.string());
    }
  }

  ChildResult runJob(json job, double limit) const {
    job.update(mesh_);
    fs::remove(file("result.json"));
    writeText(file("job.json"), job.dump());
    return runChild({options_.program, kJobCommand, file("job.json"), file("result.json")}, limit);
  }

  /// What the job came to; null, and the row says why, where it came to nothing.
  json doJob(const json& job, double limit, BenchmarkRow& row) const {
    judge(runJob(job, limit), limit, row);
    return row.status == "ok" ? json::parse(readText(file("result.json")), nullptr, false) : json();
  }

  const BenchmarkOptions& options_;
  const fs::path folder_;
  json mesh_;
};

}  // namespace

void runBenchmark(const std::vector<BenchmarkMesh>& meshes, const BenchmarkOptions& options,
                  const std::function<void(const BenchmarkRow&)>& row) {
  Bench bench(options);
  for (const BenchmarkMesh& mesh : meshes) bench.run(mesh, row);
}

}  // namespace collision_hulls
