// Groups the hulls that the benchmark kept into models, one per method and tolerance, and runs a job per model. The original comes first:
// its answers are the truth that the others are compared with.
#include "bench/queries/query_benchmark.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "bench/job_runner.h"
#include "bench/original.h"
#include "storage/csv.h"
#include "storage/files.h"

namespace collision_hulls {
namespace {

using nlohmann::json;

/// The hulls of a method at a tolerance, by mesh.
struct Model {
  std::string method, effort, requested;
  std::map<std::string, std::string> hulls;
};

bool heedsTolerance(const std::string& method) {
  return method != "single_hull" && method != "bounding_box";
}

std::vector<Model> modelsOf(const std::vector<BenchmarkRow>& rows) {
  std::vector<Model> models;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> index;
  for (const BenchmarkRow& row : rows) {
    const auto key = std::make_tuple(row.method, row.effort, heedsTolerance(row.method) ? row.requested : "");
    const auto [place, is_new] = index.emplace(key, models.size());
    if (is_new) models.push_back({row.method, row.effort, std::get<2>(key), {}});
    if (!row.hulls_file.empty()) models[place->second].hulls.emplace(row.mesh, row.hulls_file);
  }
  return models;
}

json toJson(const Eigen::Isometry3d& pose) {
  json rows = json::array();
  for (int i = 0; i < 12; ++i) rows.push_back(pose.matrix()(i / 4, i % 4));
  return rows;
}

std::optional<double> numberIn(const json& result, const char* key) {
  return result.contains(key) && result[key].is_number() ? std::optional<double>(result[key].get<double>()) : std::nullopt;
}

void fill(const json& result, QueryRow& row) {
  row.bodies = result["bodies"].get<std::size_t>();
  row.collisions_per_second = numberIn(result, "collisions_per_second");
  row.tree_collisions_per_second = numberIn(result, "tree_collisions_per_second");
  row.distances_per_second = numberIn(result, "distances_per_second");
  row.hit_rate = numberIn(result, "hit_rate");
  row.phantom_rate = numberIn(result, "phantom_rate");
  if (result.contains("missed")) row.missed = result["missed"].get<std::size_t>();
  row.distance_error_mean = numberIn(result, "distance_error_mean");
  row.distance_error_max = numberIn(result, "distance_error_max");
}

/// Runs the queries of one subject.
class SubjectQueries {
 public:
  SubjectQueries(const BenchmarkInputs& inputs, const QuerySubject& subject, const QueryOptions& options, const JobRunner& runner)
      : inputs_(inputs), subject_(subject), options_(options), runner_(runner) {}

  void run(const std::string& workload, const std::vector<Model>& models, double size, const std::function<void(const QueryRow&)>& take) {
    QueryRow row;
    row.subject = subject_.name;
    row.workload = workload;
    row.states = options_.states;
    row.seed = options_.seed;
    row.diagonal = size;
    const QueryRow original = rowOf({"original", "", "", {}}, row);
    take(original);
    if (original.status != "ok") return;
    for (const Model& model : models) take(rowOf(model, row));
  }

 private:
  QueryRow rowOf(const Model& model, QueryRow row) const {
    row.method = model.method;
    row.effort = model.effort;
    row.requested = model.requested;
    JobOutcome outcome;
    const std::size_t missing = missingMeshes(model);
    if (missing > 0) {
      outcome = {"error", "no hulls of " + std::to_string(missing) + " meshes"};
    } else {
      const json result = runner_.result(jobOf(model, row.workload), outcome);
      if (outcome.ok()) fill(result, row);
    }
    row.status = outcome.status;
    row.message = outcome.message;
    return row;
  }

  std::size_t missingMeshes(const Model& model) const {
    std::set<std::string> missing;
    for (const QuerySubject::Part& part : subject_.parts) {
      const std::string& mesh = inputs_.meshes[part.mesh].name;
      if (model.method != "original" && !model.hulls.count(mesh)) missing.insert(mesh);
    }
    return missing.size();
  }

  json jobOf(const Model& model, const std::string& workload) const {
    const bool original = model.method == "original", single = subject_.robot.links.empty();
    if (!single) writeText(runner_.file("robot.urdf"), subject_.robot.text);
    json parts = json::array();
    for (const QuerySubject::Part& part : subject_.parts) {
      const BenchmarkMesh& mesh = inputs_.meshes[part.mesh];
      parts.push_back(
          toJob(mesh, {{"link", part.link}, {"origin", toJson(part.origin)}, {"hulls", original ? "" : model.hulls.at(mesh.name)}}));
    }
    return {{"job", "query"},        {"workload", workload},     {"urdf", single ? "" : runner_.file("robot.urdf")},
            {"parts", parts},        {"original", original},     {"answers", runner_.file("answers.json")},
            {"seed", options_.seed}, {"states", options_.states}};
  }

  const BenchmarkInputs& inputs_;
  const QuerySubject& subject_;
  const QueryOptions& options_;
  const JobRunner& runner_;
};

double sizeOf(const BenchmarkInputs& inputs, const QuerySubject& subject, const std::vector<BenchmarkRow>& rows) {
  std::map<std::string, double> diagonals;
  for (const BenchmarkRow& row : rows) diagonals[row.mesh] = row.diagonal.value_or(0);
  double size = 0;
  for (const QuerySubject::Part& part : subject.parts) size = std::max(size, diagonals[inputs.meshes[part.mesh].name]);
  return size;
}

}  // namespace

std::string queryHeader() {
  return "subject,workload,method,effort,requested,status,bodies,states,collisions_per_second,tree_collisions_per_second,"
         "distances_per_second,hit_rate,phantom_rate,missed,distance_error_mean,distance_error_max,diagonal,seed,message\n";
}

std::string toCsv(const QueryRow& row) {
  return csvLine({row.subject, row.workload, row.method, row.effort, row.requested, row.status, csvCount(row.bodies), csvCount(row.states),
                  csvNumber(row.collisions_per_second), csvNumber(row.tree_collisions_per_second), csvNumber(row.distances_per_second),
                  csvNumber(row.hit_rate), csvNumber(row.phantom_rate), csvCount(row.missed), csvNumber(row.distance_error_mean),
                  csvNumber(row.distance_error_max), csvNumber(row.diagonal), std::to_string(row.seed), row.message});
}

void runQueries(const BenchmarkInputs& inputs, const std::vector<BenchmarkRow>& rows, const QueryOptions& options,
                const std::function<void(const QueryRow&)>& row) {
  const JobRunner runner(options.program, options.folder);
  const std::vector<Model> models = modelsOf(rows);
  for (const QuerySubject& subject : inputs.subjects) {
    SubjectQueries queries(inputs, subject, options, runner);
    const double size = sizeOf(inputs, subject, rows);
    queries.run("scene", models, size, row);
    if (!subject.robot.joints.empty()) queries.run("self", models, size, row);
  }
}

}  // namespace collision_hulls
