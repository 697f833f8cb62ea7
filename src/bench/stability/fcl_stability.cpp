// Each process writes a line per trial as it ends. If it dies or hangs, the trial after the last line is to blame, and a new process
// continues with the one after that.
#include "bench/stability/fcl_stability.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <locale>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/child_process.h"
#include "bench/json_file.h"
#include "bench/table.h"
#include "storage/csv.h"
#include "storage/files.h"

namespace collision_hulls {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr int kMostHangs = 3;

struct Tally {
  int count = 0;
  double worst = 0;
  void add(double error) {
    ++count;
    worst = std::max(worst, error);
  }
};
using Tallies = std::map<std::string, Tally>;

/// Adds the trials that a process wrote; returns how many there were.
int addTrials(const std::string& file, Tallies& tallies) {
  std::ifstream in(file);
  in.imbue(std::locale::classic());
  int trials = 0;
  std::string outcome;
  for (double error = 0; in >> outcome >> error; ++trials) tallies[outcome].add(error);
  return trials;
}

/// All trials of one setting on one kind of pair; after a trial that killed its process, a new process continues.
Tallies trialsOf(std::size_t setting, std::size_t pair, const FclStabilityOptions& options) {
  const std::string job_file = fs::path(options.folder) / ".fcl_job.json", result_file = fs::path(options.folder) / ".fcl_trials";
  Tallies tallies;
  for (int first = 0; first < options.trials; ++first) {
    writeText(job_file,
              json{{"setting", setting}, {"pair", pair}, {"seed", options.seed}, {"first", first}, {"last", options.trials}}.dump());
    fs::remove(result_file);
    const ChildResult used = runChild({options.program, kFclTrialsCommand, job_file, result_file}, options.time_limit);
    first += addTrials(result_file, tallies);
    if (first >= options.trials) break;
    Tally& lost = tallies[used.end == ChildResult::End::kTimeout ? "hang" : "abort"];
    lost.add(0);
    if (used.end == ChildResult::End::kTimeout && lost.count == kMostHangs) break;
  }
  fs::remove(job_file);
  fs::remove(result_file);
  return tallies;
}

}  // namespace

void doFclTrials(const std::string& job_file, const std::string& result_file) {
  const json job = readJson(job_file);
  const FclSetting& setting = fclSettings().at(job["setting"]);
  const PairKind pair = allPairKinds().at(job["pair"]);
  std::ofstream out(result_file);
  out.imbue(std::locale::classic());
  for (int number = job["first"]; number < job["last"]; ++number) {
    const FclTrial trial = tryFcl(setting, bodyPair(pair, job["seed"], static_cast<std::uint64_t>(number)));
    out << name(trial.outcome) << ' ' << trial.error << std::endl;  // flushed: the next trial may be the last
  }
}

void runFclStability(const FclStabilityOptions& options, const std::function<void(const FclStabilityRow&)>& row) {
  for (std::size_t setting = 0; setting < fclSettings().size(); ++setting)
    for (std::size_t pair = 0; pair < allPairKinds().size(); ++pair)
      for (const auto& [outcome, tally] : trialsOf(setting, pair, options))
        row({fclSettings()[setting], allPairKinds()[pair], outcome, tally.count, tally.worst});
}

std::string fclStabilityHeader() {
  return "query,solver,tolerance,pair,outcome,count,worst_error\n";
}

std::string toCsv(const FclStabilityRow& row) {
  return csvLine({queryName(row.setting), name(row.setting.solver), csvNumber(row.setting.tolerance), name(row.pair), row.outcome,
                  std::to_string(row.count), csvNumber(row.worst_error)});
}

}  // namespace collision_hulls
