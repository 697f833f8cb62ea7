// Compares methods and other programs on the same meshes, at the same tolerances and on equal terms: build time against the result.
//
//   for each mesh: prepare it (cleaned OBJ for other programs, its size)
//     for each method and peer, for each tolerance: run it --repeat times, then score the hulls that it wrote
//
// Each step is a process of its own with a time limit. Times are those of whole processes, for methods and peers alike: reading the mesh,
// decomposing it, writing the hulls. They do not include scoring.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/contender.h"
#include "bench/inputs.h"
#include "bench/table.h"
#include "collision_hulls/report/options.h"

namespace collision_hulls {

struct BenchmarkOptions {
  std::vector<Method> methods = allMethods();
  std::vector<Effort> efforts{Effort::kQuick};  ///< for methods that have efforts
  std::vector<Peer> peers;
  std::vector<Length> tolerances{shareOf(0.05), shareOf(0.02), shareOf(0.01)};
  int max_vertices = DecomposeOptions{}.max_vertices;  ///< per hull, for the methods; 0: no cap
  int repeat = 1;                                      ///< runs per row; times and memory are their medians
  double time_limit = 60;                              ///< [s] per run
  std::uint64_t seed = 1;
  std::string program;          ///< the executable that runs jobs: PROGRAM kJobCommand JOB_FILE RESULT_FILE; see jobs.h
  std::string folder;           ///< for temporary files
  std::string keep_hulls = "";  ///< folder that keeps the hulls of successful runs; empty: not kept
};

/// Runs everything, one process at a time, and passes on each row once it is complete. Throws only for faults of its own; a method's
/// failure is a row.
void runBenchmark(const std::vector<BenchmarkMesh>& meshes, const BenchmarkOptions& options,
                  const std::function<void(const BenchmarkRow&)>& row);

}  // namespace collision_hulls
