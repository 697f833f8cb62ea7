// Query speed against query error: the meshes of a robot or part, and each method's hulls of them, under the same queries.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/inputs.h"
#include "bench/table.h"

namespace collision_hulls {

/// A model of a subject in a workload. Anything not measured is empty. Lengths in metres; see query_job.h.
struct QueryRow {
  std::string subject, workload, method, effort, requested;
  std::string status = "ok";  ///< ok, timeout, crash, error
  std::optional<std::size_t> bodies, states;
  std::optional<double> collisions_per_second, tree_collisions_per_second, distances_per_second, hit_rate, phantom_rate;
  std::optional<std::size_t> missed;
  std::optional<double> distance_error_mean, distance_error_max, diagonal;  ///< diagonal: of the largest mesh
  std::uint64_t seed = 1;
  std::string message;
};

std::string queryHeader();
std::string toCsv(const QueryRow& row);

struct QueryOptions {
  std::size_t states = 2000;  ///< for collision queries; distance queries use the first hundred
  std::uint64_t seed = 1;
  std::string program, folder;  ///< as in BenchmarkOptions
};

/// For each subject and workload: the original meshes (method "original"), then each method's model at each tolerance, from the hulls that
/// `rows` kept; methods without a tolerance once. A model that lacks hulls of some mesh is a row with an error. One process at a time.
void runQueries(const BenchmarkInputs& inputs, const std::vector<BenchmarkRow>& rows, const QueryOptions& options,
                const std::function<void(const QueryRow&)>& row);

}  // namespace collision_hulls
