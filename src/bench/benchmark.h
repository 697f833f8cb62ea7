// Methods and other programs on the same meshes, tolerances and terms: build time against what comes out.
//
//   for each mesh: prepare it (cleaned OBJ for other programs, its size)
//     for each method and peer, for each tolerance: run it --repeat times, then score the hulls that it wrote
//
// Each of these is a process of its own with a time limit. Times are of whole processes, from start to end, for methods and peers alike:
// reading the mesh, decomposing it, writing the hulls. Scoring is not part of them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/contender.h"
#include "bench/inputs.h"
#include "bench/table.h"
#include "collision_hulls/pipeline/options.h"

namespace collision_hulls {

struct BenchmarkOptions {
  std::vector<Method> methods = allMethods();
  std::vector<Effort> efforts{Effort::kQuick};  ///< of methods that have one
  std::vector<Peer> peers;
  std::vector<Length> tolerances{shareOf(0.05), shareOf(0.02), shareOf(0.01)};
  int max_vertices = DecomposeOptions{}.max_vertices;  ///< of a hull of the methods; 0: no cap
  int repeat = 1;                                      ///< runs of each; the medians of their times and memory count
  double time_limit = 60;                              ///< [s] of each run
  std::uint64_t seed = 1;
  std::string program;          ///< the executable that does jobs: PROGRAM kJobCommand JOB_FILE RESULT_FILE; see jobs.h
  std::string folder;           ///< for temporary files
  std::string keep_hulls = "";  ///< folder for the hulls of all that is ok; empty: not kept
};

/// Runs everything, one process at a time, and hands over each row once it is complete. Throws for faults of its own alone.
void runBenchmark(const std::vector<BenchmarkMesh>& meshes, const BenchmarkOptions& options,
                  const std::function<void(const BenchmarkRow&)>& row);

}  // namespace collision_hulls
