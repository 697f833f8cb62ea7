// FCL's own stability: which way of asking gives the truth about which pairs of bodies. Trials run in processes of their own, since FCL
// may abort or not end.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "check/fcl_trials.h"

namespace collision_hulls {

/// How often one way of asking came to one outcome on one kind of pair.
struct FclStabilityRow {
  FclSetting setting;
  PairKind pair = PairKind::kFar;
  std::string outcome;  ///< of FclTrial, or abort, or hang
  int count = 0;
  double worst_error = 0;  ///< in sizes of the larger body
};

struct FclStabilityOptions {
  int trials = 100;  ///< of each way of asking on each kind of pair
  std::uint64_t seed = 1;
  double time_limit = 5;  ///< [s] without an answer that count as a hang; no further trials after three of them
  std::string program;    ///< the executable that does trials: PROGRAM kFclTrialsCommand JOB_FILE RESULT_FILE
  std::string folder;     ///< for temporary files
};

constexpr const char* kFclTrialsCommand = "--fcl-trials";

/// Does the trials that a JSON file asks for ("setting", "pair": indices; "seed", "first", "last") and writes a line for each as it ends.
void doFclTrials(const std::string& job_file, const std::string& result_file);

/// Runs everything and hands over the rows, ordered by setting, pair and outcome.
void runFclStability(const FclStabilityOptions& options, const std::function<void(const FclStabilityRow&)>& row);

/// Column names, and a row, each as a line of fcl.csv.
std::string fclStabilityHeader();
std::string toCsv(const FclStabilityRow& row);

}  // namespace collision_hulls
