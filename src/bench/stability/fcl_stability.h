// FCL's own stability: which kind of query gives the right answer for which kind of pair. Trials run in processes of their own, since FCL
// may abort or never return.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "bench/stability/fcl_trials.h"

namespace collision_hulls {

/// How often one kind of query had one outcome on one kind of pair.
struct FclStabilityRow {
  FclSetting setting;
  PairKind pair = PairKind::kFar;
  std::string outcome;  ///< of FclTrial, or abort or hang
  int count = 0;
  double worst_error = 0;  ///< in sizes of the larger body
};

struct FclStabilityOptions {
  int trials = 100;  ///< per kind of query and kind of pair
  std::uint64_t seed = 1;
  double time_limit = 5;  ///< [s] a process that runs longer counts as a hang; after three hangs, the trials of that setting and pair stop
  std::string program;    ///< the executable that runs trials: PROGRAM kFclTrialsCommand JOB_FILE RESULT_FILE
  std::string folder;     ///< for temporary files
};

constexpr const char* kFclTrialsCommand = "--fcl-trials";

/// Runs the trials that a JSON file describes ("setting", "pair": indices; "seed", "first", "last") and writes a line for each as it ends.
void doFclTrials(const std::string& job_file, const std::string& result_file);

/// Runs everything and passes on the rows, ordered by setting, pair and outcome.
void runFclStability(const FclStabilityOptions& options, const std::function<void(const FclStabilityRow&)>& row);

/// The column names and a row, each as a line of fcl.csv.
std::string fclStabilityHeader();
std::string toCsv(const FclStabilityRow& row);

}  // namespace collision_hulls
