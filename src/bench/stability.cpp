#include "bench/stability.h"

#include <signal.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/child_process.h"
#include "bench/jobs.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/mesh/repair.h"
#include "pipeline/files.h"

namespace collision_hulls {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr double kOwnLimit = 300;        // [s] for writing meshes and scoring, which are not what is looked at
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

/// The end of what a process wrote. The folder of its files says nothing and may be another next time.
std::string onOneLine(std::string text, const std::string& folder) {
  constexpr std::size_t kMost = 300;
  for (std::size_t at; (at = text.find(folder + "/")) != std::string::npos;) text.erase(at, folder.size() + 1);
  if (text.size() > kMost) text.erase(0, text.size() - kMost);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return text;
}

/// Outcome and message of a process that did not end well. A shell adds 128 to the signal that ended its command.
void judge(const ChildResult& used, const fs::path& folder, StabilityRow& row) {
  const bool by_signal = used.end == ChildResult::End::kSignal || used.code > 128;
  if (used.end == ChildResult::End::kTimeout) {
    row.outcome = "timeout";
    row.message = "ended after " + csvNumber(used.wall_seconds) + " s";
  } else if (by_signal) {
    row.outcome = "crash";
    row.message = strsignal(used.end == ChildResult::End::kSignal ? used.code : used.code - 128);
  } else if (used.code != 0) {
    row.outcome = "error";
    row.message = onOneLine(used.output, folder.string());
  }
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

/// The runs of a test in a folder of temporary files.
class Stability {
 public:
  explicit Stability(const StabilityOptions& options) : options_(options), folder_(fs::path(options.folder) / ".stability") {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Stability() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Stability(const Stability&) = delete;
  Stability& operator=(const Stability&) = delete;

  void run(const BenchmarkMesh& mesh, const std::function<void(const StabilityRow&)>& take) {
    hulls_without_trouble_.clear();
    for (const Trouble& trouble : options_.troubles) {
      StabilityRow start;
      start.mesh = mesh.name;
      start.trouble = trouble;
      putInTrouble(mesh, start);
      for (const Contender& contender : contendersOf(options_)) take(rowOf(contender, start));
    }
  }

 private:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  void putInTrouble(const BenchmarkMesh& mesh, StabilityRow& row) {
    const json done = doJob({{"job", "trouble"},
                             {"file", mesh.file},
                             {"scale", {mesh.scale.x(), mesh.scale.y(), mesh.scale.z()}},
                             {"kind", name(row.trouble.kind)},
                             {"amount", row.trouble.amount},
                             {"seed", options_.seed},
                             {"troubled", file("mesh.obj")}},
                            kOwnLimit, row);
    if (!done.is_object()) return;
    diagonal_ = done["diagonal"].get<double>() * lengthFactor(row.trouble);
    row.tolerance =
        options_.tolerance.relative ? options_.tolerance.value * diagonal_ : options_.tolerance.value * lengthFactor(row.trouble);
  }

  StabilityRow rowOf(const Contender& contender, StabilityRow row) {
    row.method = contender.name;
    if (row.outcome != "ok") return row;
    fs::remove(file("hulls.obj"));
    judge(runOnce(contender, row), folder_, row);
    if (row.outcome == "ok" && !fs::exists(file("hulls.obj"))) {
      row.outcome = "error";
      row.message = "no hulls were written";
    }
    if (row.outcome == "ok") score(contender, row);
    return row;
  }

  ChildResult runOnce(const Contender& contender, const StabilityRow& row) const {
    if (contender.command.empty()) {
      return runJob({{"job", "decompose"},
                     {"method", contender.name},
                     {"effort", name(Effort::kQuick)},
                     {"tolerance", *row.tolerance},
                     {"seed", options_.seed},
                     {"hulls", file("hulls.obj")}},
                    options_.time_limit);
    }
    const std::string command =
        filledIn(contender.command, {{"in", file("mesh.obj")}, {"out", file("hulls.obj")}, {"tolerance", csvNumber(row.tolerance)}});
    return runChild({"/bin/sh", "-c", command}, options_.time_limit);
  }

  void score(const Contender& contender, StabilityRow& row) {
    const json scored = doJob({{"job", "score"}, {"tolerance", *row.tolerance}, {"hulls", {file("hulls.obj")}}}, kOwnLimit, row);
    if (!scored.is_object()) {
      row.message = "the hulls could not be scored (" + row.outcome + "): " + row.message;
      row.outcome = "error";
      return;
    }
    row.hulls = scored["hulls"].get<std::size_t>();
    row.protrusion = scored["protrusion"].get<double>();
    row.uncovered = scored["uncovered"].get<double>();
    if (row.trouble.kind == TroubleKind::kNone) hulls_without_trouble_[contender.name] = *row.hulls;
    const auto before = hulls_without_trouble_.find(contender.name);
    if (before != hulls_without_trouble_.end()) row.hulls_ratio = static_cast<double>(*row.hulls) / static_cast<double>(before->second);
    row.outcome = outcomeOf(row, contender.command.empty() ? 0 : kPeersRounding * diagonal_);
  }

  ChildResult runJob(json job, double limit) const {
    if (!job.contains("file")) job.update({{"file", file("mesh.obj")}, {"scale", {1, 1, 1}}});
    fs::remove(file("result.json"));
    writeText(file("job.json"), job.dump());
    return runChild({options_.program, kJobCommand, file("job.json"), file("result.json")}, limit);
  }

  /// What the job came to; null, and the row says why, where it came to nothing.
  json doJob(const json& job, double limit, StabilityRow& row) const {
    judge(runJob(job, limit), folder_, row);
    return row.outcome == "ok" ? json::parse(readText(file("result.json")), nullptr, false) : json();
  }

  const StabilityOptions& options_;
  const fs::path folder_;
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
  return "mesh,method,trouble,amount,outcome,hulls,hulls_ratio,protrusion,message,uncovered,tolerance\n";
}

std::string toCsv(const StabilityRow& row) {
  return csvLine({row.mesh, row.method, name(row.trouble.kind), csvNumber(row.trouble.amount), row.outcome,
                  row.hulls ? std::to_string(*row.hulls) : "", csvNumber(row.hulls_ratio), csvNumber(row.protrusion), row.message,
                  csvNumber(row.uncovered), csvNumber(row.tolerance)});
}

}  // namespace collision_hulls
