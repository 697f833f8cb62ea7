// A job travels as a JSON file to a child process and its result comes back as one. Messages keep the last words of the child, without the
// name of the temporary folder, so that rows of different runs can be compared.
#include "bench/job_runner.h"

#include <cstring>

#include "bench/json_file.h"
#include "storage/csv.h"
#include "storage/files.h"

namespace collision_hulls {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr double kOwnLimit = 300;  // [s] for jobs that are not timed

}  // namespace

JobRunner::JobRunner(std::string program, const std::string& folder)
    : program_(std::move(program)), folder_(fs::absolute(folder) / ".benchmark") {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

JobRunner::~JobRunner() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

ChildResult JobRunner::run(const json& job, double limit) const {
  fs::remove(file("result.json"));
  writeText(file("job.json"), job.dump());
  return runChild({program_, kJobCommand, file("job.json"), file("result.json")}, limit);
}

// A shell adds 128 to the signal that ended its command.
JobOutcome JobRunner::judge(const ChildResult& used, double limit) const {
  if (used.end == ChildResult::End::kExit && used.code == 0) return {};
  if (used.end == ChildResult::End::kTimeout) return {"timeout", "ended after " + csvNumber(limit) + " s"};
  if (used.end == ChildResult::End::kSignal) return {"crash", lastWords(strsignal(used.code), used.output)};
  if (used.code > 128) return {"crash", lastWords(strsignal(used.code - 128), used.output)};
  return {"error", lastWords("exit status " + std::to_string(used.code), used.output)};
}

json JobRunner::result(const json& job, JobOutcome& outcome) const {
  outcome = judge(run(job, kOwnLimit), kOwnLimit);
  return outcome.ok() ? readJson(file("result.json")) : json();
}

std::string JobRunner::lastWords(const std::string& what, std::string output) const {
  constexpr std::size_t kMost = 300;
  const std::string folder = folder_.string() + "/";
  for (std::size_t at; (at = output.find(folder)) != std::string::npos;) output.erase(at, folder.size());
  std::string text = output.substr(output.size() - std::min(output.size(), kMost));
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return text.empty() ? what : what + ": " + text;
}

}  // namespace collision_hulls
