// Methods and other programs on meshes in trouble: where does each hold, and where does it fail?
//
//   for each mesh, for each trouble: write the mesh, in trouble, to a file
//     for each method and peer: run it on the file, score its hulls against what the file holds, compare their number with that of the
//     mesh without trouble
//
// Each step is a process of its own with a time limit; several run side by side, since outcomes are asked for and not times.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/benchmark.h"
#include "bench/trouble.h"

namespace collision_hulls {

/// One mesh in one trouble by one method. What could not be measured is left empty. Lengths in metres.
struct StabilityRow {
  std::string mesh, method;
  Trouble trouble;
  std::uint64_t seed = 1;  ///< of the trouble
  /// ok; over_bound: hulls protrude further than the tolerance; uncovered: they leave some of the surface out; changed: their number is
  /// another than without trouble, by more than one and more than a tenth, though the shape is the same; error: refused with a reason, or
  /// not scored; crash; timeout. The worst that holds.
  std::string outcome = "ok";
  std::optional<std::size_t> hulls;
  std::optional<double> hulls_ratio;  ///< to the number without trouble
  /// The protrusion is a certified bound, as close as it takes to tell whether it keeps the tolerance (see the job decide).
  std::optional<double> protrusion, uncovered, tolerance;
  double allowed_uncovered = 0;                        ///< what counts as covered; no column
  std::optional<double> cpu_seconds, scoring_seconds;  ///< of CPU: the run, and the evaluation of its hulls
  std::string message;
};

struct StabilityOptions {
  std::vector<Method> methods = allMethods();
  std::vector<Peer> peers;
  std::vector<Trouble> troubles = usualTroubles();
  Length tolerance = shareOf(0.02);  ///< of the diagonal without trouble
  double time_limit = 60;            ///< [s] of each run
  std::uint64_t seed = 1;
  int draws = 1;        ///< of each random trouble, with this seed and those after it
  int jobs = 0;         ///< meshes in trouble at a time; 0: as many as cores
  std::string program;  ///< the executable that does jobs: PROGRAM kJobCommand JOB_FILE RESULT_FILE; see doStabilityJob
  std::string folder;   ///< for temporary files
};

/// Does a job of jobs.h, or this one:
///   trouble    "file", "scale", "kind", "amount", "seed"  -> writes the welded mesh in trouble to "troubled" (OBJ);
///              "diagonal" [m] without trouble
void doStabilityJob(const std::string& job_file, const std::string& result_file);

/// Runs everything and hands over the rows in the order of meshes, troubles and methods, from any thread but one at a time. Throws for
/// faults of its own alone.
void runStability(const std::vector<BenchmarkMesh>& meshes, const StabilityOptions& options,
                  const std::function<void(const StabilityRow&)>& row);

/// Column names, and a row, each as a line of stability.csv (RFC 4180).
std::string stabilityHeader();
std::string toCsv(const StabilityRow& row);

/// What a row that was scored comes to.
std::string outcomeOf(const StabilityRow& row);

}  // namespace collision_hulls
