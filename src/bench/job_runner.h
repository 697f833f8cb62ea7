// Runs jobs and other programs in processes of their own, and tells how they ended.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "bench/child_process.h"

namespace collision_hulls {

/// How a process ended, as reported in a row.
struct JobOutcome {
  std::string status = "ok";  ///< ok, timeout, crash, error
  std::string message;        ///< why not ok
  bool ok() const { return status == "ok"; }
};

/// Runs jobs (see jobs.h) in a folder of temporary files, which it removes on destruction.
class JobRunner {
 public:
  /// `program` runs jobs: PROGRAM kJobCommand JOB_FILE RESULT_FILE.
  JobRunner(std::string program, const std::string& folder);
  ~JobRunner();
  JobRunner(const JobRunner&) = delete;
  JobRunner& operator=(const JobRunner&) = delete;

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  ChildResult run(const nlohmann::json& job, double limit) const;               ///< [s]
  JobOutcome judge(const ChildResult& used, double limit) const;                ///< the message omits the temporary folder's name
  nlohmann::json result(const nlohmann::json& job, JobOutcome& outcome) const;  ///< for jobs that are not timed; null unless ok
  std::string lastWords(const std::string& what, std::string output) const;     ///< what happened, and the end of a process's output

 private:
  const std::string program_;
  const std::filesystem::path folder_;
};

constexpr const char* kJobCommand = "--job";

}  // namespace collision_hulls
