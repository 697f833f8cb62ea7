// Methods and other programs on troubled meshes: where does each hold, and where does it fail?
//
//   for each mesh, for each trouble: write the troubled mesh to a file
//     for each method and peer: run it on the file, score its hulls against the file's mesh, compare their number with that for the
//     undisturbed mesh
//
// Each step is a process of its own with a time limit; several run in parallel, since only outcomes matter here, not times.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/benchmark.h"
#include "bench/stability/trouble.h"

namespace collision_hulls {

/// One mesh with one trouble, decomposed by one method. Anything not measured is empty. Lengths in metres.
struct StabilityRow {
  std::string mesh, method;
  Trouble trouble;
  std::uint64_t seed = 1;  ///< of the trouble
  /// ok; over_bound: hulls protrude further than the tolerance; uncovered: hulls leave out part of the surface; changed: the shape is the
  /// same, but the number of hulls differs from the undisturbed mesh's by more than one and more than a tenth; error: refused with a
  /// reason, or not scored; crash; timeout. The worst that applies.
  std::string outcome = "ok";
  std::optional<std::size_t> hulls;
  std::optional<double> hulls_ratio;  ///< to the number for the undisturbed mesh
  /// The protrusion is a certified bound, only as close as needed to decide whether the tolerance is kept (see the job `decide`).
  std::optional<double> protrusion, uncovered, tolerance;
  double allowed_uncovered = 0;                        ///< up to here counts as covered; not a column
  std::optional<double> cpu_seconds, scoring_seconds;  ///< CPU time of the run, and of scoring its hulls
  std::string message;
};

struct StabilityOptions {
  std::vector<Method> methods = allMethods();
  std::vector<Peer> peers;
  std::vector<Trouble> troubles = usualTroubles();
  Length tolerance = shareOf(0.02);  ///< a share refers to the undisturbed mesh's diagonal
  double time_limit = 60;            ///< [s] per run
  std::uint64_t seed = 1;
  int draws = 1;        ///< per random trouble, with this seed and the ones after it
  int jobs = 0;         ///< troubled meshes in parallel; 0: one per core
  std::string program;  ///< the executable that runs jobs: PROGRAM kJobCommand JOB_FILE RESULT_FILE; see doStabilityJob
  std::string folder;   ///< for temporary files
};

/// Does a job of jobs.h, or this one:
///   trouble    "file", "scale", "kind", "amount", "seed"  -> writes the welded mesh with the trouble to "troubled" (OBJ);
///              "diagonal" [m] of the undisturbed mesh
void doStabilityJob(const std::string& job_file, const std::string& result_file);

/// Runs everything and passes on the rows in the order of meshes, troubles and methods, from any thread but one at a time. Throws only for
/// faults of its own.
void runStability(const std::vector<BenchmarkMesh>& meshes, const StabilityOptions& options,
                  const std::function<void(const StabilityRow&)>& row);

/// The column names and a row, each as a line of stability.csv (RFC 4180).
std::string stabilityHeader();
std::string toCsv(const StabilityRow& row);

/// The outcome of a row that was scored.
std::string outcomeOf(const StabilityRow& row);

}  // namespace collision_hulls
